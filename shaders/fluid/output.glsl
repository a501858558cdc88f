// Output of a frame: the wind between the last two ticks as textures, and the figures of the tick's report. The last work group
// adds up what all have found, and writes it for the host.
//
// WINDROW_VECTORS and WINDROW_AXES are the formats of one texture of four components and of three of one; each alone, or both.
// WINDROW_TEXEL(u) makes of a vec4 what such a texture can hold: a half becomes no infinity.
#ifndef WINDROW_TEXEL
#define WINDROW_TEXEL(u) (u)
#endif
#define WINDROW_READS_TILE 6
#define WINDROW_PUSH WindrowShowPush
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) readonly buffer Before { vec4 before[]; };
layout(std430, set = 0, binding = 4) readonly buffer Expansion { float expansion[]; };
// of |u|^2 and of the squared divergence, a work group each
layout(std430, set = 0, binding = 5) coherent buffer Sums { vec2 sums[]; };
#define WINDROW_SOLIDS 7
#include "fluid/solids.glsl"
#include "numerics/closed_face.glsl"
#define WINDROW_READING 8
#ifdef WINDROW_VECTORS
#define WINDROW_FIRST_AXIS 12
layout(WINDROW_VECTORS, set = 0, binding = 11) writeonly uniform image3D vectors;
#else
#define WINDROW_FIRST_AXIS 11
#endif
#ifdef WINDROW_AXES
layout(WINDROW_AXES, set = 0, binding = WINDROW_FIRST_AXIS) writeonly uniform image3D axis_x;
layout(WINDROW_AXES, set = 0, binding = WINDROW_FIRST_AXIS + 1) writeonly uniform image3D axis_y;
layout(WINDROW_AXES, set = 0, binding = WINDROW_FIRST_AXIS + 2) writeonly uniform image3D axis_z;
#endif

#define WINDROW_FIELD(at) velocity[now(at)]
#include "fluid/divergence.glsl"

// Beyond that of the empty box, times h. `scale`: of the cell's row.
float through_closed_faces(int record, float scale) {
    float sum = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            const int n = record_face(record, axis, end);
            if (n < 0)
                continue;
            const SolidFace face = solid_face(n);
            const float both = WINDROW_FIELD(cell_index(solid_cell(face.cell[0])))[axis] +
                               WINDROW_FIELD(cell_index(solid_cell(face.cell[1])))[axis];
            const float passed = windrow_closed_flux(face.closed, both, face.wall);
            sum += axis == 1 ? (end == 1 ? -scale : scale) * passed : end == 1 ? -passed : passed;
        }
    return sum;
}
#include "fluid/shown.glsl"
#include "fluid/reading.glsl"

void write_texels(ivec3 cell, SampledCell sampled) {
#ifdef WINDROW_VECTORS
    imageStore(vectors, cell, WINDROW_TEXEL(vec4(sampled.velocity, sampled.height)));
#endif
#ifdef WINDROW_AXES
    const vec3 u = WINDROW_TEXEL(vec4(sampled.plain, 0.0f)).xyz;
    imageStore(axis_x, cell, vec4(u.x, 0.0f, 0.0f, 0.0f));
    imageStore(axis_y, cell, vec4(u.y, 0.0f, 0.0f, 0.0f));
    imageStore(axis_z, cell, vec4(u.z, 0.0f, 0.0f, 0.0f));
#endif
}

layout(constant_id = 3) const int k_group = 128; // invocations
#define WINDROW_AROUND 9
#define WINDROW_SLOT 10
#include "fluid/report.glsl"
shared uint group_largest, group_apart;
shared bool is_last;

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
        const vec4 u = velocity[now(at)];
        write_texels(cell, sampled_cell(cell, push.factor, push.shift));
        if (reports) {
            float divergence = 0.0f;
            const int record = has_obstacles() ? solid_record(cell) : -1;
            const bool within = record_is(record, WINDROW_INSIDE);
            if (is_on(WINDROW_PROJECTS) && !within) {
                divergence = 0.5f / tick.cell_size * differences(cell);
                if (record >= 0)
                    divergence += through_closed_faces(record, row_scale(cell.y)) / tick.cell_size;
                if (is_on(WINDROW_EXPANDS))
                    divergence -= expansion[at];
            }
            parts[local] = vec2(row_volume(cell.y) * dot(u.xyz, u.xyz), divergence * divergence);
            atomicMax(group_largest, floatBitsToUint(largest_component(u.xyz)));
            const float time = tick.duration + elapsed();
            const vec3 around =
                record_is(record, WINDROW_ROOM) ? vec3(0.0f) : around_at(cell, time, wind_at(cell, time, is_on(WINDROW_GUSTS)));
            if (!within)
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
        memoryBarrierBuffer();
        is_last = push.reports == WINDROW_REPORTS_TO_HOST &&
                  atomicAdd(control.reported_groups, 1u) == groups.x * groups.y * groups.z - 1u;
        memoryBarrierBuffer();
    }
    barrier();
    if (!is_last)
        return;
    memoryBarrierBuffer(); // it reads the sums of all
    if (local == 0)
        control.reported_groups = 0u;
    const uvec3 groups = gl_NumWorkGroups;
    write_report(int(groups.x * groups.y * groups.z), push.forces, push.forces_at);
}
