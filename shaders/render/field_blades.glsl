// Looks at each visible blade once a frame: where it stands, how it leans in the wind now and how it did. Its vertices, in the
// picture and in the shadows, only read that. A group a list (x: order and view) and part of it (y): the work goes with the blades that are
// seen, not with those that stand.
#define WINDROW_SET 1
#include "../coupling/windrow_plants.glsl"
#define GRASS_SET 3
#include "../grass/grass_blade.glsl"
#define FIELD_ACCESS
#include "field_blade.glsl"

layout(local_size_x = 64) in;
layout(std430, set = GRASS_SET, binding = 4) readonly buffer GrassDraws { uvec4 grass_draws[]; };
layout(std430, set = GRASS_SET, binding = 5) readonly buffer GrassOrders { ivec4 grass_orders[]; };

layout(push_constant) uniform Which { uint first_order; } which;

shared uint sums[gl_WorkGroupSize.x];

// Near and far blades of a list: 2 * order + view.
uvec2 counts_of(uint list) {
    uint slot = uint(grass_orders[which.first_order + list / 2u].x);
    uint draw = 2u * (2u * slot + list % 2u);
    return uvec2(grass_draws[draw].y, grass_draws[draw + 1u].y);
}

FieldBlade blade_of(uvec2 told, int instance) {
    GrassBlade now = grass_blade(told, instance);
    GrassBlade before = grass_blade_previous(told, instance);
    const vec3 up = vec3(0.0, 1.0, 0.0);
    vec3 middle = now.root + 0.5 * windrow_blade_length(now.kind, now.hash) * up;
    vec2 bend = windrow_blade_load(now.kind, up, now.hash, windrow_wind_on(middle, vec3(0.0))).xz;
    vec2 bend_before = windrow_blade_load(before.kind, up, now.hash, windrow_wind_on_previous(middle, vec3(0.0))).xz;
#ifdef FIELD_GROUND
    // What is trodden on does not follow the wind.
    vec4 ground = windrow_ground(now.root), ground_before = windrow_ground_previous(now.root);
    bend = bend * (1.0 - ground.z) + ground.xy;
    bend_before = bend_before * (1.0 - ground_before.z) + ground_before.xy;
#endif
    FieldBlade blade;
    blade.root = vec4(now.root, windrow_dryness(now.root.xz - grass.corner.xz));
    blade.bend = vec4(bend, bend_before);
    blade.size = vec4(now.kind.size.xz, before.kind.size.xz);
    blade.traits = uvec4(now.hash, floatBitsToUint(vec2(now.morph, before.morph)));
    blade.looks = vec4(now.clump, now.looks);
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
    uint slot = uint(grass_orders[which.first_order + list / 2u].x), view = list % 2u;
    if (gl_WorkGroupID.y == 0u && lane == 0u) {
        field_bases[4u * slot + 2u * view] = base;
        field_bases[4u * slot + 2u * view + 1u] = base + counts.x;
    }
    uint end = min(counts.x + counts.y, uint(field_blades.length()) - min(base, uint(field_blades.length())));
    for (uint n = gl_WorkGroupID.y * gl_WorkGroupSize.x + lane; n < end; n += gl_NumWorkGroups.y * gl_WorkGroupSize.x) {
        uint level = n < counts.x ? 0u : 1u;
        field_blades[base + n] = blade_of(uvec2(slot, level + 2u * view), int(n - level * counts.x));
    }
}
