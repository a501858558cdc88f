// Second stage of a direct solve in slabs: along z, the columns of y, and along z back, for one mode of x and the even or the odd modes
// of z a group, which fit in shared memory. Columns as in columns.comp; none is periodic or without an inverse.
//
// hat[mode of x][even, odd][y][z of the low half, or from the middle for the odd ones].
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_PUSH WindrowSlabsPush
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { vec4 tables[]; };
layout(std430, set = 0, binding = 3) readonly buffer HatX { vec4 hat_x[]; };
layout(std430, set = 0, binding = 4) writeonly buffer Hat { vec4 hat[]; };
#include "fluid/products.glsl"

float row_column(int j) { return rows[j + WINDROW_HALO_LOW].column; }

// Four columns: Thomas' elimination with stored pivots.
void solve_columns(int four, int pivots) {
    const int stride = 2 * k_fours;
    vec4 carry = vec4(0.0f);
    for (int j = 0; j < k_lines; ++j) {
        vec4 d = part[j * k_fours + four];
        if (k_own_rows) // as cpu::ColumnRows
            d *= row_column(j) * row_volume(j);
        carry = (d - carry) * tables[pivots + j * stride];
        part[j * k_fours + four] = carry;
    }
    for (int j = k_lines - 1; j >= 0; --j) {
        if (j < k_lines - 1)
            carry = part[j * k_fours + four] - tables[pivots + j * stride] * carry;
        part[j * k_fours + four] = k_own_rows ? row_column(j) * carry : carry;
    }
}

void main() {
    const int lane = int(gl_LocalInvocationIndex), mode = int(gl_WorkGroupID.x), odd = int(gl_WorkGroupID.y);
    const int width = 2 * k_fours, first = mode * k_lines * width; // of hat_x and of the pivots
    for (int n = lane; n < k_lines * k_fours; n += k_group) {
        const int line = first + n / k_fours * width, four = n % k_fours;
        const vec4 low = hat_x[line + four], high = hat_x[line + width - 1 - four].wzyx;
        part[n] = odd == 0 ? low + high : low - high;
    }
    barrier();
    multiply(push.forward / 4, width, odd * k_fours, k_fours);
    store_held();
    if (lane < k_fours)
        solve_columns(lane, push.pivots / 4 + first + odd * k_fours + lane);
    barrier();
    multiply(push.back / 4, width, odd * k_fours, k_fours);
    for (int n = 0; n < k_each; ++n)
        if (own_line(n) < k_lines)
            hat[((2 * mode + odd) * k_lines + own_line(n)) * k_fours + own_four()] = held[n];
}
