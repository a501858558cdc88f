// Second stage of a direct solve: along y, for each mode of x and z, the tridiagonal system
//
//   x[j-1] + b[j] x[j] + x[j+1] = d[j]
//
// by Thomas' elimination with stored pivots 1 / (b[j] - pivot[j-1]); periodic columns by Sherman and Morrison. The one column of
// a closed box that has no inverse is solved for mean 0.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_PUSH WindrowColumnsPush
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) buffer Hat { float hat[]; };

float row_column(int j) { return rows[j + WINDROW_HALO_LOW].column; }

// In rows of unequal thickness what d adds to the flux counts by it, and a flux makes a difference over a row's own distance.
void solve_singular_rows(int at, int plane) {
    const int count = tick.cells.y;
    float mean = 0.0f, whole = 0.0f;
    for (int j = 0; j < count; ++j) {
        mean += row_volume(j) * hat[at + j * plane];
        whole += row_volume(j);
    }
    mean /= whole;
    float flux = 0.0f, x = 0.0f, x_mean = 0.0f;
    for (int j = 0; j < count; ++j) {
        flux += row_volume(j) * (hat[at + j * plane] - mean);
        hat[at + j * plane] = x;
        x_mean += row_volume(j) * x / whole;
        x += flux / row_link(j + 1);
    }
    for (int j = 0; j < count; ++j)
        hat[at + j * plane] -= x_mean;
}

// x[j+1] - x[j] = flux + d[0] + .. + d[j]; walls give flux 0, a periodic axis the flux that closes the ring.
void solve_singular(int at, int plane, int count) {
    float mean = 0.0f;
    for (int j = 0; j < count; ++j)
        mean += hat[at + j * plane];
    mean /= float(count);
    float running = 0.0f, flux = 0.0f;
    if (push.vectors >= 0) {
        float total = 0.0f;
        for (int j = 0; j < count; ++j) {
            running += hat[at + j * plane] - mean;
            total += running;
        }
        flux = -total / float(count);
    }
    running = 0.0f;
    float x = 0.0f, x_mean = 0.0f;
    for (int j = 0; j < count; ++j) {
        const float d = hat[at + j * plane];
        hat[at + j * plane] = x;
        x_mean += x / float(count);
        running += d - mean;
        x += flux + running;
    }
    for (int j = 0; j < count; ++j)
        hat[at + j * plane] -= x_mean;
}

void main() {
    const int plane = tick.cells.x * tick.cells.z, count = tick.cells.y;
    const int at = int(gl_GlobalInvocationID.x);
    if (at >= plane)
        return;
    if (at == push.singular && k_own_rows) {
        solve_singular_rows(at, plane);
        return;
    }
    if (at == push.singular) {
        solve_singular(at, plane, count);
        return;
    }
    const int pivots = push.pivots + at;
    float carry = 0.0f;
    for (int j = 0; j < count; ++j) {
        float d = hat[at + j * plane];
        if (k_own_rows) // as cpu::ColumnRows
            d *= row_column(j) * row_volume(j);
        carry = (d - carry) * tables[pivots + j * plane];
        hat[at + j * plane] = carry;
    }
    for (int j = count - 2; j >= 0; --j) {
        carry = hat[at + j * plane] - tables[pivots + j * plane] * carry;
        hat[at + j * plane] = carry;
    }
    for (int j = 0; k_own_rows && j < count; ++j)
        hat[at + j * plane] *= row_column(j);
    if (push.vectors < 0)
        return;
    const int vectors = push.vectors + at, factors = push.vectors + count * plane + at;
    const float share = tables[factors] * hat[at] + tables[factors + plane] * hat[at + (count - 1) * plane];
    for (int j = 0; j < count; ++j)
        hat[at + j * plane] -= share * tables[vectors + j * plane];
}
