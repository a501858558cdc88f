// Output of a frame: the wind between the last two ticks as three textures, and the figures of the tick's report.
#define WINDROW_READS_TILE 6
#define WINDROW_PUSH WindrowShowPush
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) readonly buffer Before { vec4 before[]; };
layout(std430, set = 0, binding = 4) readonly buffer Expansion { float expansion[]; };
// of |u|^2 and of the squared divergence, a work group each
layout(std430, set = 0, binding = 5) writeonly buffer Sums { vec2 sums[]; };
layout(WINDROW_TEXEL, set = 0, binding = 7) writeonly uniform image3D axis_x;
layout(WINDROW_TEXEL, set = 0, binding = 8) writeonly uniform image3D axis_y;
layout(WINDROW_TEXEL, set = 0, binding = 9) writeonly uniform image3D axis_z;

#define WINDROW_FIELD velocity
#include "fluid/divergence.glsl"
#include "fluid/shown.glsl"

layout(constant_id = 3) const int k_group = 128; // invocations
shared vec2 parts[k_group];
shared uint group_largest, group_apart;

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    const int local = int(gl_LocalInvocationIndex);
    const bool reports = push.reports != 0;
    if (local == 0)
        group_largest = group_apart = 0;
    parts[local] = vec2(0.0f);
    barrier();
    if (inside(cell, tick.cells)) {
        const int at = cell_index(cell);
        const vec4 u = velocity[at];
        const vec4 now = shown_cell(at, push.factor);
        imageStore(axis_x, cell, vec4(now.x, 0.0f, 0.0f, 0.0f));
        imageStore(axis_y, cell, vec4(now.y, 0.0f, 0.0f, 0.0f));
        imageStore(axis_z, cell, vec4(now.z, 0.0f, 0.0f, 0.0f));
        if (reports) {
            float divergence = 0.0f;
            if (is_on(WINDROW_PROJECTS)) {
                divergence = 0.5f / tick.cell_size * differences(cell);
                if (is_on(WINDROW_EXPANDS))
                    divergence -= expansion[at];
            }
            parts[local] = vec2(dot(u.xyz, u.xyz), divergence * divergence);
            atomicMax(group_largest, floatBitsToUint(largest_component(u.xyz)));
            const vec3 around = wind_at(cell, tick.duration, is_on(WINDROW_GUSTS));
            atomicMax(group_apart, floatBitsToUint(largest_component(u.xyz - around)));
        }
    }
    if (!reports)
        return;
    barrier();
    // A tree whose shape does not depend on the device: the same sums on all.
    for (int half_size = k_group / 2; half_size > 0; half_size /= 2) {
        if (local < half_size)
            parts[local] += parts[local + half_size];
        barrier();
    }
    if (local == 0) {
        const uvec3 group = gl_WorkGroupID, groups = gl_NumWorkGroups;
        sums[(group.z * groups.y + group.y) * groups.x + group.x] = parts[0];
        atomicMax(control.largest_speed, group_largest);
        atomicMax(control.farthest_from_ambient, group_apart);
    }
}
