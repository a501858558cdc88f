// Last stage of a direct solve in slabs: modes of x back to cells. A group takes lines of neighbouring z in the low half of the box, and
// those that mirror them: the sum and the difference of what the slabs of even and of odd modes have there.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { vec4 tables[]; };
layout(std430, set = 0, binding = 3) readonly buffer Hat { float hat[]; };
#include "fluid/solution.glsl"
#include "fluid/products.glsl"

void main() {
    const int lane = int(gl_LocalInvocationIndex), nx = k_outputs, pairs = k_lines / 2, half_z = tick.cells.z / 2;
    const int y = int(gl_WorkGroupID.y), first = int(gl_WorkGroupID.x) * pairs;
    for (int n = lane; n < pairs * k_fours; n += k_group) {
        const int line = n % pairs, four = n / pairs, z = first + line;
        vec4 even = vec4(0.0f), odd = vec4(0.0f);
        for (int k = 0; k < 4 && z < half_z; ++k) {
            const int slab = (2 * (4 * four + k) * tick.cells.y + y) * half_z;
            even[k] = hat[slab + z];
            odd[k] = hat[slab + (tick.cells.y + 1) * half_z - 1 - z]; // of the odd slab, from its end
        }
        part[line * k_fours + four] = even + odd;
        part[(pairs + line) * k_fours + four] = even - odd;
    }
    barrier();
    multiply(push.x_vectors / 4, nx / 4, 0, k_fours / 2);
    store_held();
    for (int n = lane; n < k_lines * nx; n += k_group) {
        const int line = n / nx, x = n % nx, z = first + line % pairs;
        if (z >= half_z)
            continue;
        const float own = value_at(line, x), mirrored = value_at(line, nx - 1 - x);
        store(ivec3(x, y, line < pairs ? z : tick.cells.z - 1 - z), x < nx / 2 ? own + mirrored : mirrored - own);
    }
}
