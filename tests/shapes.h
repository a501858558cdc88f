// Meshes and voxel grids with known distances, for tests of obstacles.
#pragma once

#include "fluid/obstacle.h"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace windrow::test {

inline std::shared_ptr<const TriangleMesh> mesh_of(MeshData data) {
    auto made = TriangleMesh::create(std::move(data));
    EXPECT_TRUE(made) << made.error();
    return made ? *made : nullptr;
}

inline std::shared_ptr<const VoxelGrid> grid_of(VoxelData data) {
    auto made = VoxelGrid::create(std::move(data));
    EXPECT_TRUE(made) << made.error();
    return made ? *made : nullptr;
}

inline std::shared_ptr<const HeightMap> heights_of(HeightData data) {
    auto made = HeightMap::create(std::move(data));
    EXPECT_TRUE(made) << made.error();
    return made ? *made : nullptr;
}

/// The same from a function of the place [m].
inline std::shared_ptr<const HeightMap> heights_of(glm::ivec2 corners, float spacing,
                                                   const std::function<double(double x, double z)>& height) {
    HeightData data{.corners = corners, .spacing = spacing};
    for (int z = 0; z < corners.y; ++z)
        for (int x = 0; x < corners.x; ++x)
            data.heights.push_back(
                static_cast<float>(height(static_cast<double>(spacing) * x, static_cast<double>(spacing) * z)));
    return heights_of(std::move(data));
}

/// Two triangles a face, outward.
inline MeshData box_mesh(glm::vec3 half, glm::vec3 centre = glm::vec3(0.0f)) {
    MeshData data;
    for (int n = 0; n < 8; ++n)
        data.vertices.push_back(centre + half * glm::vec3((n & 1) * 2 - 1, (n & 2) - 1, (n >> 1 & 2) - 1));
    data.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return data;
}

/// An icosahedron whose triangles are cut into four, `cuts` times, with all vertices on the sphere.
inline MeshData ball_mesh(float radius, int cuts) {
    const float g = 0.5f * (1.0f + std::sqrt(5.0f));
    MeshData data{.vertices = {{-1, g, 0},
                               {1, g, 0},
                               {-1, -g, 0},
                               {1, -g, 0},
                               {0, -1, g},
                               {0, 1, g},
                               {0, -1, -g},
                               {0, 1, -g},
                               {g, 0, -1},
                               {g, 0, 1},
                               {-g, 0, -1},
                               {-g, 0, 1}},
                  .triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (int n = 0; n < cuts; ++n) {
        std::map<std::pair<glm::uint, glm::uint>, glm::uint> middles;
        const auto middle = [&](glm::uint a, glm::uint b) {
            const auto [found, added] = middles.try_emplace({std::min(a, b), std::max(a, b)}, data.vertices.size());
            if (added)
                data.vertices.push_back(glm::normalize(data.vertices[a] + data.vertices[b]));
            return found->second;
        };
        std::vector<glm::uvec3> finer;
        for (const glm::uvec3 t : data.triangles) {
            const glm::uint ab = middle(t.x, t.y), bc = middle(t.y, t.z), ca = middle(t.z, t.x);
            finer.insert(finer.end(), {{t.x, ab, ca}, {ab, t.y, bc}, {ca, bc, t.z}, {ab, bc, ca}});
        }
        data.triangles = std::move(finer);
    }
    for (glm::vec3& place : data.vertices)
        place = radius * glm::normalize(place);
    return data;
}

/// About the y axis.
inline MeshData torus_mesh(float ring, float tube, glm::uint around, glm::uint across) {
    MeshData data;
    for (glm::uint i = 0; i < around; ++i)
        for (glm::uint j = 0; j < across; ++j) {
            const float u = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(around);
            const float v = 2.0f * std::numbers::pi_v<float> * static_cast<float>(j) / static_cast<float>(across);
            const float from_axis = ring + tube * std::cos(v);
            data.vertices.emplace_back(from_axis * std::cos(u), tube * std::sin(v), from_axis * std::sin(u));
            const glm::uint a = i * across + j, b = i * across + (j + 1) % across, c = (i + 1) % around * across + j,
                            d = (i + 1) % around * across + (j + 1) % across;
            data.triangles.push_back({a, b, d});
            data.triangles.push_back({a, d, c});
        }
    return data;
}

[[nodiscard]] inline MeshData inside_out(MeshData data) {
    for (glm::uvec3& t : data.triangles)
        std::swap(t.y, t.z);
    return data;
}

[[nodiscard]] inline MeshData both(MeshData data, const MeshData& other) {
    const auto first = static_cast<glm::uint>(data.vertices.size());
    data.vertices.insert(data.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const glm::uvec3 t : other.triangles)
        data.triangles.push_back(t + first);
    return data;
}

[[nodiscard]] inline MeshData placed(MeshData data, const std::function<glm::vec3(glm::vec3)>& place) {
    for (glm::vec3& vertex : data.vertices)
        vertex = place(vertex);
    return data;
}

/// Four walls, a floor and a roof around a room.
[[nodiscard]] inline MeshData room_mesh(glm::vec3 half, float wall) {
    return both(box_mesh(half), inside_out(box_mesh(half - wall)));
}

} // namespace windrow::test
