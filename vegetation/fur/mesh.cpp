#include "vegetation/fur/mesh.h"

#include "fluid/core/message.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message;

bool sound(const glm::vec3& v) {
    return std::abs(v.x) <= k_farthest && std::abs(v.y) <= k_farthest && std::abs(v.z) <= k_farthest; // false for NaN
}

// What is wrong with one vertex; nothing: empty.
std::string fault_of(const MeshVertex& vertex) {
    if (!sound(vertex.position))
        return message(".position is ", vertex.position, ": give finite metres within ", k_farthest, " of the origin.");
    if (const float length = glm::length(vertex.normal); !(std::abs(length - 1.0f) <= 1e-3f))
        return message(".normal has the length ", length, ": give a unit vector.");
    if (!std::isfinite(vertex.uv.x) || !std::isfinite(vertex.uv.y))
        return ".uv is not finite: give finite coordinates.";
    const glm::vec4 w = vertex.weights;
    const bool positive = w.x >= 0.0f && w.y >= 0.0f && w.z >= 0.0f && w.w >= 0.0f;
    const float sum = w.x + w.y + w.z + w.w;
    if (!positive || !(sum == 0.0f || std::abs(sum - 1.0f) <= 1e-4f))
        return message(".weights sum to ", sum, ": give four from 0 to 1 that sum to 1, or none.");
    return {};
}

std::string fault_of_parts(const Mesh& mesh) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        const MeshPart& part = mesh.parts[i];
        if (part.first != next || part.count == 0 || part.count % 3 != 0 || part.count > mesh.indices.size() - next)
            return message(".parts[", i, "] takes ", part.count, " indices from ", part.first, " on: give whole triangles from ",
                           next, " on, of ", mesh.indices.size(), ".");
        next += part.count;
    }
    if (next != mesh.indices.size())
        return message(".parts hold ", next, " indices: give each of ", mesh.indices.size(), " a part.");
    return {};
}

} // namespace

Result<void> validate(const Mesh& mesh, const char* owner) {
    const auto reject = [&](const auto&... words) { return windrow::Error{message(owner, words...)}; };
    if (mesh.vertices.size() < 3 || mesh.vertices.size() > k_max_vertices)
        return reject(".vertices has ", mesh.vertices.size(), " entries: give 3 to ", k_max_vertices, ".");
    if (mesh.indices.empty() || mesh.indices.size() % 3 != 0 || mesh.triangles() > k_max_triangles)
        return reject(".indices has ", mesh.indices.size(), " entries: give three a triangle, 1 to ", k_max_triangles,
                      " triangles.");
    if (mesh.parts.empty() || mesh.parts.size() > k_max_parts)
        return reject(".parts has ", mesh.parts.size(), " entries: give 1 to ", k_max_parts, ".");
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        if (mesh.indices[i] >= mesh.vertices.size())
            return reject(".indices[", i, "] is ", mesh.indices[i], ": give 0 to ", mesh.vertices.size() - 1, ".");
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        if (const std::string fault = fault_of(mesh.vertices[i]); !fault.empty())
            return reject(".vertices[", i, "]", fault);
    if (const std::string fault = fault_of_parts(mesh); !fault.empty())
        return reject(fault);
    glm::vec3 low = mesh.vertices.front().position, high = low;
    for (const MeshVertex& vertex : mesh.vertices) {
        low = glm::min(low, vertex.position);
        high = glm::max(high, vertex.position);
    }
    if (low != mesh.low || high != mesh.high)
        return reject(".low and .high are ", mesh.low, " and ", mesh.high, ": give the box of the positions, ", low, " and ",
                      high, ".");
    return {};
}

void measure(Mesh& mesh) {
    if (mesh.vertices.empty())
        return;
    mesh.low = mesh.high = mesh.vertices.front().position;
    for (const MeshVertex& vertex : mesh.vertices) {
        mesh.low = glm::min(mesh.low, vertex.position);
        mesh.high = glm::max(mesh.high, vertex.position);
    }
}

} // namespace windrow::vegetation::fur
