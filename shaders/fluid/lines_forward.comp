// First stage of a direct solve in slabs: the right-hand side to modes of x, some lines of neighbouring z and one y a group.
// hat_x[mode of x][y][z] is written in runs of z.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 9
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { vec4 tables[]; };
layout(std430, set = 0, binding = 3) readonly buffer Arrived { vec4 arrived[]; };
layout(std430, set = 0, binding = 4) readonly buffer Expansion { float expansion[]; };
layout(std430, set = 0, binding = 5) writeonly buffer HatX { float hat_x[]; };
#include "fluid/right_side.glsl"
#include "fluid/products.glsl"

void main() {
    const int lane = int(gl_LocalInvocationIndex), terms = k_fours / 2, nx = k_outputs;
    const int y = int(gl_WorkGroupID.y), first = int(gl_WorkGroupID.x) * k_lines;
    for (int n = lane; n < k_lines * terms; n += k_group) {
        const int line = n / terms, four = n % terms;
        vec4 low = vec4(0.0f), high = vec4(0.0f);
        for (int end = 0; end < 8 && first + line < tick.cells.z; ++end) {
            const int x = 4 * four + (end & 3);
            const float value = load(ivec3(end < 4 ? x : nx - 1 - x, y, first + line));
            if (end < 4)
                low[end] = value;
            else
                high[end - 4] = value;
        }
        part[line * k_fours + four] = low + high;
        part[line * k_fours + terms + four] = low - high;
    }
    barrier();
    multiply(push.x_vectors / 4, nx / 4, 0, terms);
    store_held();
    for (int n = lane; n < k_lines * nx; n += k_group) {
        const int mode = n / k_lines, line = n % k_lines;
        if (first + line < tick.cells.z)
            hat_x[(mode * tick.cells.y + y) * tick.cells.z + first + line] = value_at(line, mode);
    }
}
