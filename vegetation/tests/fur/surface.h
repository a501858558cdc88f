// What a mesh is as a surface: its edges, counted by position, so that a seam of the map is no edge.
#pragma once

#include "vegetation/fur/mesh.h"
#include "vegetation/fur/mesh_weld.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

namespace windrow::vegetation::fur::test {

struct Surface {
    std::size_t points = 0, edges = 0, triangles = 0;
    std::size_t open = 0; ///< edges that are not once in each direction
    double volume = 0.0;  ///< [m3] positive: triangles face outwards
    double inward = 0.0;  ///< greatest -cosine between a triangle and a normal at its corner
    double behind = 0.0;  ///< share of corners where that is more than 1/4
    double split = 0.0;   ///< greatest difference of normals at one position
    [[nodiscard]] long euler() const {
        return static_cast<long>(points) - static_cast<long>(edges) + static_cast<long>(triangles);
    }
};

inline Surface surface_of(const Mesh& mesh) {
    Surface surface;
    const std::vector<std::uint32_t> point = same_positions(mesh.vertices);
    std::map<std::uint32_t, glm::vec3> normals;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        glm::dvec3 p[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = mesh.indices[i + k];
            p[k] = mesh.vertices[v].position;
            const auto [known, is_new] = normals.try_emplace(point[v], mesh.vertices[v].normal);
            surface.split = std::max(surface.split, static_cast<double>(glm::length(known->second - mesh.vertices[v].normal)));
            const std::uint32_t a = point[v], b = point[mesh.indices[i + (k + 1) % 3]];
            ++(a < b ? edges[{a, b}].first : edges[{b, a}].second);
        }
        surface.volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6.0;
        const glm::dvec3 facing = glm::cross(p[1] - p[0], p[2] - p[0]);
        for (std::size_t k = 0; k < 3; ++k) {
            const double inward = -glm::dot(facing, glm::dvec3(mesh.vertices[mesh.indices[i + k]].normal)) / glm::length(facing);
            surface.inward = std::max(surface.inward, inward);
            surface.behind += (inward > 0.25) / static_cast<double>(mesh.indices.size());
        }
    }
    surface.points = normals.size();
    surface.edges = edges.size();
    surface.triangles = mesh.triangles();
    for (const auto& [edge, count] : edges)
        surface.open += count.first != 1 || count.second != 1;
    return surface;
}

} // namespace windrow::vegetation::fur::test
