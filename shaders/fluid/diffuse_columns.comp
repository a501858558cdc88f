// Implicit diffusion of one component: second stage, the tridiagonal systems along y. Their pivots depend on the sub-step, which
// the device chose, so they are found here.
//
// Rows are (1, -2 - s, 1), s = 1/r less the eigenvalues of x and z: for large r so close to singular that -2 - s in floats has
// forgotten s. So a pivot is -1 / (1 + e), e_j = s + e_(j-1) / (1 + e_(j-1)): sums of positive numbers alone. Periodic columns by
// Sherman and Morrison, A = A' + u w^T with u = (g, 0 .., 1), w = (1, 0 .., 1/g), g = 2 + s: what they divide by, 1 + w.v with
// A' v = u, vanishes with s too. Since A takes a column of ones to -s of them, it is -s (w.o) / (1 + 1/g) with A' o = 1.
// Based on: Alfa, Xue & Ye 2002, Mathematics of Computation 71 (diagonally dominant M-matrices entry by entry).
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_PUSH WindrowDiffusePush
#include "fluid/pass.glsl"
#include "fluid/viscosity.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) buffer Hat { float hat[]; };
layout(std430, set = 0, binding = 4) buffer Pivots { float pivots[]; };
layout(std430, set = 0, binding = 5) buffer Vectors { vec4 vectors[]; };

// Rows of unequal thickness e with links c: c[j] x[j-1] - (c[j] + c[j+1] + e s) x[j] + c[j+1] x[j+1] = e d[j]. Eliminated, the diagonal is
// -(c[j+1] + g), g[j] = e s + c[j] g[j-1] / (c[j] + g[j-1]).
void solve_rows(int at, int plane, int facts, float s) {
    const int count = tick.cells.y;
    float below = 0.0f, carry = 0.0f; // g and the right-hand side of the row before
    for (int j = 0; j < count; ++j) {
        const float low = row_link(j), high = row_link(j + 1), before = low + below;
        float g = row_volume(j) * s + (j == 0 ? low * (1.0f - tables[facts]) : low * (below / before));
        carry = row_volume(j) * hat[at + j * plane] + (j == 0 ? 0.0f : (low / before) * carry);
        if (j == count - 1)
            g += high * (1.0f - tables[facts + 1]);
        pivots[at + j * plane] = j == count - 1 ? g : high + g;
        hat[at + j * plane] = carry;
        below = g;
    }
    float x = 0.0f;
    for (int j = count - 1; j >= 0; --j) {
        const float above = j == count - 1 ? 0.0f : row_link(j + 1) * x;
        x = (above - hat[at + j * plane]) / pivots[at + j * plane];
        hat[at + j * plane] = x;
    }
}

void main() {
    const int plane = tick.cells.x * tick.cells.z, count = tick.cells.y;
    const int at = int(gl_GlobalInvocationID.x);
    if (at >= plane || !is_implicit())
        return;
    const int facts = push.eigenvalues + tick.cells.x + tick.cells.z;
    const float s = 1.0f / diffusion_ratio() - tables[push.eigenvalues + at % tick.cells.x] -
                    tables[push.eigenvalues + tick.cells.x + at / tick.cells.x];
    if (k_own_rows) {
        solve_rows(at, plane, facts, s);
        return;
    }
    const bool periodic = tables[facts + 2] != 0.0f, cyclic = periodic && count > 1;
    const float gamma = 2.0f + s;
    float e = 0.0f, pivot = 0.0f, carry = 0.0f;
    vec2 boundaries = vec2(0.0f); // v, o
    for (int j = 0; j < count; ++j) {
        const bool first = j == 0, last = j == count - 1;
        float end = first ? 1.0f : 0.0f; // no row above
        if (cyclic)
            end += first ? gamma : last ? 1.0f / gamma : 0.0f;
        else if (periodic)
            end -= 2.0f;
        else
            end -= (first ? tables[facts] : 0.0f) + (last ? tables[facts + 1] : 0.0f);
        const float rest = s + e / (1.0f + e);
        e = end + rest;
        pivot = -1.0f / ((1.0f + end) + rest);
        carry = (hat[at + j * plane] - carry) * pivot;
        boundaries = (vec2((first ? gamma : 0.0f) + (last ? 1.0f : 0.0f), 1.0f) - boundaries) * pivot;
        pivots[at + j * plane] = pivot;
        hat[at + j * plane] = carry;
        vectors[at + j * plane].xy = boundaries;
    }
    for (int j = count - 2; j >= 0; --j) {
        carry = hat[at + j * plane] - pivots[at + j * plane] * carry;
        boundaries = vectors[at + j * plane].xy - pivots[at + j * plane] * boundaries;
        hat[at + j * plane] = carry;
        vectors[at + j * plane].xy = boundaries;
    }
    if (!cyclic)
        return;
    const int low = at, high = at + (count - 1) * plane;
    const float scale = -(1.0f + 1.0f / gamma) / (s * (vectors[low].y + vectors[high].y / gamma));
    const float share = scale * (hat[low] + hat[high] / gamma);
    for (int j = 0; j < count; ++j)
        hat[at + j * plane] -= share * vectors[at + j * plane].x;
}
