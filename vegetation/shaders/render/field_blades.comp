// Looks at each visible blade once a frame: where it stands, how it leans in the wind now and how it did. Its vertices, in the
// picture and in the shadows, only read that. The work goes with the blades that are seen, not with those that stand.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_SET 1
#include "shaders/coupling/windrow_plants.glsl"
#include "air.glsl"
#include "field_lists.glsl"

shared uint sums[gl_WorkGroupSize.x];

FieldBlade blade_of(uvec2 told, int instance) {
    GrassBlade now = grass_blade(told, instance);
    GrassBlade before = grass_blade_previous(told, instance);
    const vec3 up = vec3(0.0, 1.0, 0.0);
    vec3 middle = now.root + 0.5 * windrow_blade_length(now.kind, now.hash) * up;
    vec2 bend = windrow_blade_load(now.kind, up, now.hash, windrow_wind_on(middle, vec3(0.0))).xz;
    vec2 bend_before = windrow_blade_load(before.kind, up, now.hash, windrow_wind_on_previous(middle, vec3(0.0))).xz;
    FieldBlade blade;
    blade.root = vec4(now.root, windrow_dryness(now.root.xz - grass.corner.xz));
    blade.bend = vec4(bend, bend_before);
    blade.size = vec4(now.kind.size.xz, before.kind.size.xz);
    blade.traits = uvec4(now.hash, floatBitsToUint(vec2(now.morph, before.morph)));
    blade.looks = vec4(now.clump, now.looks.x, now.size);
    blade.fog = air_before(middle);
    return blade;
}

void main() {
    uint list = gl_WorkGroupID.x, lane = gl_LocalInvocationIndex;
    uint sum = 0u;
    for (uint before = lane; before < list; before += gl_WorkGroupSize.x)
        sum += counts_of(before).x + counts_of(before).y;
    sums[lane] = sum;
    barrier();
    uint base = 0u;
    for (uint n = 0u; n < gl_WorkGroupSize.x; ++n)
        base += sums[n];
    uvec2 counts = counts_of(list);
    uint slot = slot_of(list), view = list % 2u;
    if (gl_WorkGroupID.y == 0u && lane == 0u) {
        field_bases[4u * slot + 2u * view] = base;
        field_bases[4u * slot + 2u * view + 1u] = base + counts.x;
    }
    uint end = room_of(base, counts.x + counts.y);
    for (uint n = gl_WorkGroupID.y * gl_WorkGroupSize.x + lane; n < end; n += gl_NumWorkGroups.y * gl_WorkGroupSize.x) {
        uint level = n < counts.x ? 0u : 1u;
        field_blades[base + n] = blade_of(uvec2(slot, level + 2u * view), int(n - level * counts.x));
    }
}
