// The field that the tests of the grass share, and eyes that look at it.
#pragma once

#include "tests/fields.h"
#include "vegetation/grass/grass_block.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace windrow::vegetation::grass::test {

/// Hills of 4 m over 80 m x 112 m, a corner a metre.
inline HeightMap hills(glm::ivec2 corners = {81, 113}, float spacing = 1.0f) {
    auto made =
        HeightMap::create(corners, spacing, [](glm::vec2 p) { return 2.0f * std::sin(0.11f * p.x) * std::cos(0.07f * p.y); });
    EXPECT_TRUE(made) << made.error();
    return *std::move(made);
}

/// Grass in two places with a gap between them, and a bare patch in one.
inline PlacementMask glades(const HeightMap& heights) {
    auto mask = PlacementMask::create({129, 129}, heights.extent());
    EXPECT_TRUE(mask) << mask.error();
    EXPECT_TRUE(mask->paint({.centre = {22.0f, 25.0f}, .radius = 20.0f, .hardness = 0.8f}));
    EXPECT_TRUE(mask->erase({.centre = {28.0f, 30.0f}, .radius = 6.0f}));
    EXPECT_TRUE(mask->paint({.centre = {60.0f, 85.0f}, .radius = 25.0f, .hardness = 0.3f}));
    return *std::move(mask);
}

/// Chunks of 8 m, so that a small field has a hundred; cut and split well within it.
inline GrassSettings small_field() {
    return {.chunk_cells = 48, .split_distance = 12.0f, .cut_distance = 45.0f, .shadow_distance = 20.0f, .max_chunks = 140};
}

struct Eye {
    glm::mat4 view_projection{1.0f}; // of positions from the field's corner
    glm::vec3 at{0.0f};
};

/// Vulkan's clip space: y down, depth 0 to 1.
inline Eye eye_at(glm::vec3 at, glm::vec3 toward, float field_of_view = 0.9f) {
    glm::mat4 projection = glm::perspectiveRH_ZO(field_of_view, 16.0f / 9.0f, 0.1f, 300.0f);
    projection[1][1] = -projection[1][1];
    return {projection * glm::lookAtRH(at, at + toward, glm::vec3(0.0f, 1.0f, 0.0f)), at};
}

/// Anywhere over the field or a little beside it, looking anywhere but straight up or down.
inline Eye random_eye(windrow::test::Random& random, const HeightMap& heights) {
    const glm::vec2 place = heights.extent() * glm::vec2(random.uniform(-0.2f, 1.2f), random.uniform(-0.2f, 1.2f));
    const float yaw = random.uniform(0.0f, 6.2831853f);
    const glm::vec3 at(place.x, heights.height(place) + random.uniform(0.3f, 12.0f), place.y);
    return eye_at(at, {std::cos(yaw), random.uniform(-0.8f, 0.4f), std::sin(yaw)}, random.uniform(0.4f, 1.6f));
}

/// Whether the passes keep a blade for the eye's view, by the shared text: what cull.comp does.
inline int level_of(const Block& block, const Planes& planes, glm::vec3 eye, const BladeRecord& blade) {
    using namespace windrow::numerics;
    const glm::vec3 root(blade), sight = root - eye;
    if (!(blade.w > 0.0f))
        return WINDROW_GRASS_NONE;
    for (const glm::vec4& plane : planes)
        if (windrow_beyond_plane(plane, root, blade.w * block.corner.w))
            return WINDROW_GRASS_NONE;
    return windrow_grass_level(glm::dot(sight, sight), block.reach);
}

/// Whether any vertex of a blade's 15 lies within the clip volume, in a wind of 5 m/s along x.
inline bool shows(const Block& block, const Eye& eye, glm::ivec2 cell, const BladeRecord& record) {
    using namespace windrow::numerics;
    const glm::vec3 root(record), up(0.0f, 1.0f, 0.0f);
    const float distance = glm::length(root - eye.at);
    if (!(record.w > 0.0f) || !(distance < block.reach.w))
        return false;
    const WindrowBlade kind = windrow_grass_class(block, record.w, distance);
    const glm::uvec2 hash = windrow_plant_hash(windrow_grass_key(cell, static_cast<std::uint32_t>(block.cells.w), 0u));
    const glm::vec3 load = windrow_blade_load(kind, up, hash, {5.0f, 0.0f, 0.0f});
    const WindrowBladePlant plant = windrow_blade_plant(kind, up, hash, load, (root - eye.at) / distance);
    for (int vertex = 0; vertex < 15; ++vertex) {
        const glm::vec2 row = windrow_grass_row(vertex, WINDROW_GRASS_NEAR, 3, 0.0f);
        const glm::vec4 p =
            eye.view_projection * glm::vec4(root + windrow_blade_vertex(kind, plant, row.x, row.y).position, 1.0f);
        if (p.z >= 0.0f && p.z <= p.w && std::abs(p.x) <= p.w && std::abs(p.y) <= p.w)
            return true;
    }
    return false;
}

} // namespace windrow::vegetation::grass::test
