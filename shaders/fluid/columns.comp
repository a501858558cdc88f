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

// x[j+1] - x[j] = flux + d[0] + .. + d[j]; walls give flux 0, a periodic axis the flux that closes the ring.
void solve_singular(int at, int plane, int rows) {
    float mean = 0.0f;
    for (int j = 0; j < rows; ++j)
        mean += hat[at + j * plane];
    mean /= float(rows);
    float running = 0.0f, flux = 0.0f;
    if (push.vectors >= 0) {
        float total = 0.0f;
        for (int j = 0; j < rows; ++j) {
            running += hat[at + j * plane] - mean;
            total += running;
        }
        flux = -total / float(rows);
    }
    running = 0.0f;
    float x = 0.0f, x_mean = 0.0f;
    for (int j = 0; j < rows; ++j) {
        const float d = hat[at + j * plane];
        hat[at + j * plane] = x;
        x_mean += x / float(rows);
        running += d - mean;
        x += flux + running;
    }
    for (int j = 0; j < rows; ++j)
        hat[at + j * plane] -= x_mean;
}

void main() {
    const int plane = tick.cells.x * tick.cells.z, rows = tick.cells.y;
    const int at = int(gl_GlobalInvocationID.x);
    if (at >= plane)
        return;
    if (at == push.singular) {
        solve_singular(at, plane, rows);
        return;
    }
    const int pivots = push.pivots + at;
    float carry = 0.0f;
    for (int j = 0; j < rows; ++j) {
        carry = (hat[at + j * plane] - carry) * tables[pivots + j * plane];
        hat[at + j * plane] = carry;
    }
    for (int j = rows - 2; j >= 0; --j) {
        carry = hat[at + j * plane] - tables[pivots + j * plane] * carry;
        hat[at + j * plane] = carry;
    }
    if (push.vectors < 0)
        return;
    const int vectors = push.vectors + at, factors = push.vectors + rows * plane + at;
    const float share = tables[factors] * hat[at] + tables[factors + plane] * hat[at + (rows - 1) * plane];
    for (int j = 0; j < rows; ++j)
        hat[at + j * plane] -= share * tables[vectors + j * plane];
}
