#include "vegetation/fur/mesh_weld.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message;

// Exact: what a file writes twice it writes alike. Adding 0 makes -0 a 0.
using Key = std::array<std::uint32_t, 5>;

struct KeyHash {
    std::size_t operator()(const Key& key) const {
        std::uint64_t hash = 0xcbf29ce484222325u; // FNV-1a by words
        for (const std::uint32_t word : key)
            hash = (hash ^ word) * 0x100000001b3u;
        return static_cast<std::size_t>(hash ^ hash >> 29);
    }
};

Key key_of(const glm::vec3& p, const glm::vec2& uv) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value + 0.0f); };
    return {bits(p.x), bits(p.y), bits(p.z), bits(uv.x), bits(uv.y)};
}

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Twice the area along the normal; 0 for a triangle that is a line.
glm::dvec3 facing(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    return glm::length(across) > 1e-6 * longest ? across : glm::dvec3(0.0);
}

double angle(const glm::dvec3& at, const glm::dvec3& one, const glm::dvec3& other) {
    return std::atan2(glm::length(glm::cross(one - at, other - at)), glm::dot(one - at, other - at));
}

std::string fault_of(const Corner& corner) {
    if (!finite(corner.position) || glm::dot(corner.position, corner.position) > 1e30f)
        return message("has the position ", corner.position, ": give finite ones.");
    if (!finite(corner.normal))
        return message("has the normal ", corner.normal, ": give finite ones.");
    if (!std::isfinite(corner.uv.x) || !std::isfinite(corner.uv.y))
        return "has a uv that is not finite: give finite ones.";
    return {};
}

} // namespace

std::vector<std::uint32_t> same_positions(const std::vector<MeshVertex>& vertices) {
    std::unordered_map<Key, std::uint32_t, KeyHash> numbers;
    std::vector<std::uint32_t> result;
    result.reserve(vertices.size());
    for (const MeshVertex& vertex : vertices)
        result.push_back(
            numbers.try_emplace(key_of(vertex.position, {}), static_cast<std::uint32_t>(numbers.size())).first->second);
    return result;
}

Result<Mesh> weld(const Soup& soup, const std::string& owner) {
    Mesh mesh;
    mesh.has_uv = std::all_of(soup.begin(), soup.end(), [](const SoupPart& part) { return part.has_uv; });
    std::unordered_map<Key, std::uint32_t, KeyHash> numbers;
    for (const SoupPart& part : soup) {
        const auto first = static_cast<std::uint32_t>(mesh.indices.size());
        const bool has_normals =
            std::any_of(part.corners.begin(), part.corners.end(), [](const Corner& c) { return c.normal != glm::vec3(0.0f); });
        for (std::size_t i = 0; i + 2 < part.corners.size(); i += 3) {
            const Corner* corners = &part.corners[i];
            for (std::size_t k = 0; k < 3; ++k)
                if (const std::string fault = fault_of(corners[k]); !fault.empty())
                    return windrow::Error{message(owner, fault)};
            if (facing(corners[0].position, corners[1].position, corners[2].position) == glm::dvec3(0.0))
                continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const Corner& corner = corners[k];
                const float length = glm::length(corner.normal);
                if (has_normals && !(length > 1e-6f))
                    return windrow::Error{message(owner, "has a normal of length ", length, " at ", corner.position,
                                                  ": give unit vectors, or none at all.")};
                const glm::vec2 uv = mesh.has_uv ? corner.uv : glm::vec2(0.0f);
                const auto [known, is_new] =
                    numbers.try_emplace(key_of(corner.position, uv), static_cast<std::uint32_t>(mesh.vertices.size()));
                if (is_new)
                    mesh.vertices.push_back({.position = corner.position, .normal = glm::vec3(0.0f), .uv = uv});
                if (mesh.vertices.size() > k_max_vertices)
                    return windrow::Error{message(owner, "has more than ", k_max_vertices, " vertices: give fewer.")};
                if (has_normals)
                    mesh.vertices[known->second].normal +=
                        corner.normal / length *
                        static_cast<float>(angle(corner.position, corners[(k + 1) % 3].position, corners[(k + 2) % 3].position));
                mesh.indices.push_back(known->second);
            }
        }
        if (mesh.indices.size() > first)
            mesh.parts.push_back({part.material, first, static_cast<std::uint32_t>(mesh.indices.size()) - first, {}});
    }
    if (mesh.indices.empty())
        return windrow::Error{message(owner, "has no triangle with an area: give a mesh of triangles.")};
    measure(mesh);
    return mesh;
}

void smooth_normals(Mesh& mesh) {
    const std::vector<std::uint32_t> number = same_positions(mesh.vertices);
    struct Sums {
        glm::dvec3 file{0.0}, faces{0.0}, first{0.0};
    };
    std::vector<Sums> sums(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        sums[number[i]].file += glm::dvec3(mesh.vertices[i].normal);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::array<std::uint32_t, 3> corner{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        const std::array<glm::dvec3, 3> p{mesh.vertices[corner[0]].position, mesh.vertices[corner[1]].position,
                                          mesh.vertices[corner[2]].position};
        const glm::dvec3 across = facing(p[0], p[1], p[2]);
        if (across == glm::dvec3(0.0))
            continue;
        const glm::dvec3 normal = glm::normalize(across);
        for (std::size_t k = 0; k < 3; ++k) {
            Sums& sum = sums[number[corner[k]]];
            sum.faces += normal * angle(p[k], p[(k + 1) % 3], p[(k + 2) % 3]);
            if (sum.first == glm::dvec3(0.0))
                sum.first = normal;
        }
    }
    const auto usable = [](const glm::dvec3& sum) { return glm::length(sum) > 1e-3; }; // [rad] of angles that do not cancel
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Sums& sum = sums[number[i]];
        const glm::dvec3 chosen = usable(sum.file) ? sum.file : usable(sum.faces) ? sum.faces : sum.first;
        mesh.vertices[i].normal = glm::vec3(glm::normalize(chosen));
    }
}

} // namespace windrow::vegetation::fur
