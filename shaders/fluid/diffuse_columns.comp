// Implicit diffusion of one component: second stage, the tridiagonal systems along y. Their pivots depend on the sub-step, which the
// device chose, so they are found here; the systems are as diagonally dominant as 1/r, which floats carry.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"
#include "fluid/viscosity.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) buffer Hat { float hat[]; };
layout(std430, set = 0, binding = 4) buffer Pivots { float pivots[]; };
layout(std430, set = 0, binding = 5) buffer Vectors { vec4 vectors[]; };

void main() {
    const int plane = tick.cells.x * tick.cells.z, rows = tick.cells.y;
    const int at = int(gl_GlobalInvocationID.x);
    if (at >= plane || !is_implicit())
        return;
    // push.y: eigenvalues of x, then of z, then what the low and the high end of y add to the diagonal, then 1 where y is periodic.
    const int facts = push.y + tick.cells.x + tick.cells.z;
    const float base = -2.0f + tables[push.y + at % tick.cells.x] + tables[push.y + tick.cells.x + at / tick.cells.x] -
                       1.0f / diffusion_ratio();
    const bool periodic = tables[facts + 2] != 0.0f, cyclic = periodic && rows > 1;
    const float gamma = -base;
    float pivot = 0.0f, carry = 0.0f, vector = 0.0f;
    for (int j = 0; j < rows; ++j) {
        float diagonal = base;
        if (cyclic)
            diagonal += j == 0 ? base : j == rows - 1 ? 1.0f / base : 0.0f;
        else if (periodic)
            diagonal += 2.0f;
        else
            diagonal += (j == 0 ? tables[facts] : 0.0f) + (j == rows - 1 ? tables[facts + 1] : 0.0f);
        pivot = 1.0f / (diagonal - pivot);
        carry = (hat[at + j * plane] - carry) * pivot;
        vector = ((j == 0 ? gamma : 0.0f) + (j == rows - 1 ? 1.0f : 0.0f) - vector) * pivot;
        pivots[at + j * plane] = pivot;
        hat[at + j * plane] = carry;
        vectors[at + j * plane].x = vector;
    }
    for (int j = rows - 2; j >= 0; --j) {
        carry = hat[at + j * plane] - pivots[at + j * plane] * carry;
        vector = vectors[at + j * plane].x - pivots[at + j * plane] * vector;
        hat[at + j * plane] = carry;
        vectors[at + j * plane].x = vector;
    }
    if (!cyclic)
        return;
    const float scale = 1.0f / (1.0f + vectors[at].x + vectors[at + (rows - 1) * plane].x / gamma);
    const float share = scale * (hat[at] + hat[at + (rows - 1) * plane] / gamma);
    for (int j = 0; j < rows; ++j)
        hat[at + j * plane] -= share * vectors[at + j * plane].x;
}
