// Which blades of a chunk a view draws, and at which level: a group a chunk and view (y: 0 the colour's, 1 the shadow's).
//
// The group goes along the places in order and counts the kept ones before each: the lists come out in the same order on every
// machine and in every run, hence the same picture, which appending by a counter in memory would not give.
#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 128) in;
#include "../grass/field.glsl"

const uint k_words = 4u; // of 32 invocations each

// Kept blades of a round as bits, near then far. Three sets in turn: one is written, one was read a round ago, one is cleared for
// the next, so that a round needs one barrier.
shared uint kept[3][2][k_words];

bool is_seen(vec4 blade, uint view) {
    for (uint plane = 0u; plane < 6u; ++plane)
        if (windrow_beyond_plane(grass.planes[6u * view + plane], blade.xyz, blade.w * grass.corner.w))
            return false;
    return true;
}

int level_of(vec4 blade, uint view, ivec2 cell) {
    vec3 sight = blade.xyz - grass.eye.xyz;
    float square = dot(sight, sight);
    int level = windrow_grass_level(square, grass.reach);
    if (!(blade.w > 0.0) || (view == 1u && !(square < grass.ground.z * grass.ground.z)) || !is_seen(blade, view))
        return WINDROW_GRASS_NONE;
    if (grass.thin.y > 0.0 && square > grass.thin.x * grass.thin.x &&
        !(windrow_grass_chance(cell, uint(grass.cells.w)) < windrow_grass_fraction(grass.thin, sqrt(square))))
        return WINDROW_GRASS_NONE;
    return level;
}

void main() {
    const ivec4 order = orders[first_order + gl_WorkGroupID.x];
    const uint view = gl_WorkGroupID.y;
    const uint lane = gl_LocalInvocationIndex;
    const uint places = places_of_a_chunk();
    const int side = grass.cells.z;
    const ivec2 first = chunks[order.x] * side;
    const uint list = 2u * uint(order.x) + view;
    const bool wanted = (uint(order.y) >> view & 1u) != 0u; // the same for the whole group
    if (lane < 2u * k_words)
        kept[0][lane / k_words][lane % k_words] = 0u;
    barrier();
    uvec2 counts = uvec2(0u);
    const uint rounds = wanted ? (places + gl_WorkGroupSize.x - 1u) / gl_WorkGroupSize.x : 0u;
    for (uint round = 0u; round < rounds; ++round) {
        const uint set = round % 3u;
        const uint place = round * gl_WorkGroupSize.x + lane;
        int level = WINDROW_GRASS_NONE;
        if (place < places)
            level = level_of(blades[uint(order.x) * places + place], view, first + ivec2(int(place) % side, int(place) / side));
        if (level != WINDROW_GRASS_NONE)
            atomicOr(kept[set][level][lane / 32u], 1u << (lane % 32u));
        if (lane < 2u * k_words)
            kept[(set + 1u) % 3u][lane / k_words][lane % k_words] = 0u;
        barrier();
        uvec2 before = counts;
        for (uint word = 0u; word < k_words; ++word) {
            const uvec2 bits = uvec2(kept[set][0][word], kept[set][1][word]);
            counts += uvec2(bitCount(bits));
            const uint lower = word < lane / 32u ? 0xffffffffu : word == lane / 32u ? (1u << (lane % 32u)) - 1u : 0u;
            before += uvec2(bitCount(bits & lower));
        }
        if (level == WINDROW_GRASS_NEAR)
            lists[list * places + before.x] = place;
        else if (level == WINDROW_GRASS_FAR)
            lists[(list + 1u) * places - 1u - before.y] = place;
    }
    if (lane < 2u) {
        const uint vertices = lane == 0u ? 2u * WINDROW_GRASS_NEAR_ROWS + 1u : 2u * uint(grass.ground.w) + 1u;
        draws[2u * list + lane] = uvec4(vertices, lane == 0u ? counts.x : counts.y, 0u, 0u);
    }
}
