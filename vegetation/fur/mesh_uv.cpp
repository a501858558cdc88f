#include "vegetation/fur/mesh.h"

#include <array>
#include <cmath>
#include <utility>

namespace windrow::vegetation::fur {
namespace {

constexpr std::uint32_t k_none = ~0u;

// 0 to 5: which side of the box the triangle faces, so that opposite sides do not share a vertex.
std::size_t side_of(const glm::vec3& normal) {
    const glm::vec3 size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<std::size_t>(2 * axis + (normal[axis] < 0.0f ? 1 : 0));
}

// u runs to the right and v up, seen from outside.
glm::vec2 seen(const glm::vec3& p, std::size_t side) {
    const float sign = side % 2 == 0 ? 1.0f : -1.0f;
    switch (side / 2) {
    case 0:
        return {-sign * p.z, p.y};
    case 1:
        return {p.x, -sign * p.z};
    default:
        return {sign * p.x, p.y};
    }
}

} // namespace

void project_uv(Mesh& mesh) {
    mesh.has_uv = false;
    std::vector<std::array<std::uint32_t, 6>> copies(mesh.vertices.size(), {k_none, k_none, k_none, k_none, k_none, k_none});
    std::vector<MeshVertex> vertices;
    vertices.reserve(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        // By the vertices' normals: they turn more evenly than the triangles', so that the seams wander less.
        const auto normal = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]].normal; };
        const std::size_t side = side_of(normal(0) + normal(1) + normal(2));
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t& copy = copies[mesh.indices[i + k]][side];
            if (copy == k_none) {
                copy = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(mesh.vertices[mesh.indices[i + k]]);
                vertices.back().uv = seen(vertices.back().position, side);
            }
            mesh.indices[i + k] = copy;
        }
    }
    mesh.vertices = std::move(vertices);
}

} // namespace windrow::vegetation::fur
