// Patches of a mesh's skin, and which vertices have some before their strands.
#include "vegetation/fur/coat_room.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace windrow::vegetation::fur {
namespace {

constexpr float k_most_patches = 60'000.0f;
constexpr int k_most_cuts = 64; // of a side of a triangle: a plane's may be as long as a field

struct Place {
    glm::vec3 at{0.0f}, normal{0.0f};
};

glm::vec3 position_of(const CoatVertexBlock& vertex) {
    return glm::vec3(vertex.position);
}

Place place_of(std::span<const CoatVertexBlock> vertices, const CoatPatchBlock& patch) {
    const glm::vec3 a = position_of(vertices[patch.corners.x]), along = position_of(vertices[patch.corners.y]) - a,
                    aside = position_of(vertices[patch.corners.z]) - a, across = glm::cross(along, aside);
    return {a + patch.weights.x * along + patch.weights.y * aside, across / std::max(glm::length(across), 1e-20f)};
}

// Key of a cell: 20 bits an axis, and 3 bits of its content.
std::uint64_t key_of(glm::vec3 at, float cell, std::uint64_t apart = 0) {
    std::uint64_t key = apart;
    for (int axis = 0; axis < 3; ++axis)
        key = key << 20 | (static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(at[axis] / cell))) & 0xfffffu);
    return key;
}

// The side that a normal faces most: 0 to 5.
std::uint64_t side_of(glm::vec3 normal) {
    const glm::vec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<std::uint64_t>(2 * axis + (normal[axis] < 0.0f ? 1 : 0));
}

struct Kept {
    std::size_t patch = 0;
    float area = 0.0f;
};

} // namespace

std::vector<CoatPatchBlock> skin_patches(std::span<const CoatVertexBlock> vertices, std::span<const std::uint32_t> indices,
                                         float length) {
    double area = 0.0;
    for (std::size_t n = 0; n < indices.size(); n += 3) {
        const glm::vec3 a = position_of(vertices[indices[n]]);
        area += 0.5 * static_cast<double>(glm::length(
                          glm::cross(position_of(vertices[indices[n + 1]]) - a, position_of(vertices[indices[n + 2]]) - a)));
    }
    const float apart = std::max(0.4f * length, std::sqrt(static_cast<float>(area) / k_most_patches));
    std::vector<CoatPatchBlock> patches;
    std::unordered_map<std::uint64_t, Kept> in_cell; // fine meshes: the largest of a cell stands for those beside it
    for (std::size_t n = 0; n < indices.size(); n += 3) {
        const glm::uvec3 corners(indices[n], indices[n + 1], indices[n + 2]);
        const glm::vec3 a = position_of(vertices[corners.x]), b = position_of(vertices[corners.y]),
                        c = position_of(vertices[corners.z]);
        const float longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
        const float size = 0.5f * glm::length(glm::cross(b - a, c - a));
        const glm::vec3 middle = (a + b + c) / 3.0f;
        const float around = std::max({glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)});
        if (!(size > 0.0f))
            continue;
        const int cuts = std::clamp(static_cast<int>(std::ceil(longest / (1.5f * apart))), 1, k_most_cuts);
        const auto step = 1.0f / static_cast<float>(cuts);
        for (int row = 0; row < cuts; ++row)
            for (int column = 0; column < 2 * (cuts - row) - 1; ++column) {
                const float turned = column % 2 == 1 ? 2.0f / 3.0f : 1.0f / 3.0f;
                const glm::vec2 weights{(static_cast<float>(column / 2) + turned) * step,
                                        (static_cast<float>(row) + turned) * step};
                const CoatPatchBlock patch{.corners = corners, .radius = 1.05f * around * step, .weights = weights};
                const Place place = place_of(vertices, patch);
                const auto [known, is_new] =
                    in_cell.try_emplace(key_of(place.at, 0.5f * apart, side_of(place.normal)), Kept{patches.size(), size});
                if (is_new) {
                    patches.push_back(patch);
                    continue;
                }
                CoatPatchBlock& kept = patches[known->second.patch];
                const float off = glm::distance(place.at, place_of(vertices, kept).at);
                if (size > known->second.area) {
                    const float covered = off + kept.radius;
                    kept = patch;
                    kept.radius = std::max(patch.radius, covered);
                    known->second.area = size;
                } else {
                    kept.radius = std::max(kept.radius, off + patch.radius);
                }
            }
    }
    return patches;
}

std::vector<std::uint32_t> narrow_vertices(std::span<const CoatVertexBlock> vertices, std::size_t drawn,
                                           std::span<const CoatPatchBlock> patches, float length) {
    std::vector<std::uint32_t> narrow;
    const bool moves = std::any_of(vertices.begin(), vertices.end(), [](const auto& vertex) { return vertex.weights.x > 0.0f; });
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells;
    const float cell = 1.4f * length;
    std::vector<Place> places;
    for (std::uint32_t n = 0; n < patches.size() && !moves; ++n) {
        places.push_back(place_of(vertices, patches[n]));
        cells[key_of(places.back().at, cell)].push_back(n);
    }
    for (std::uint32_t n = 0; n < drawn; ++n) {
        const glm::vec3 root = position_of(vertices[n]), up(vertices[n].normal);
        // Skin that rises over the tangent plane, by more than a lying strand is high, and that the root does not lie behind.
        const auto rises = [&](std::uint32_t patch) {
            const glm::vec3 off = places[patch].at - root;
            const float far = glm::length(off);
            const float over = glm::dot(off, up);
            return far < cell && glm::dot(off, places[patch].normal) < 0.15f * length &&
                   (over > 0.05f * far || (over > -0.05f * length && glm::dot(places[patch].normal, up) < 0.9f));
        };
        bool met = moves;
        for (int near = 0; near < 27 && !met; ++near) {
            const glm::vec3 there = root + cell * (glm::vec3(near % 3, near / 3 % 3, near / 9) - 1.0f);
            if (const auto found = cells.find(key_of(there, cell)); found != cells.end())
                met = std::any_of(found->second.begin(), found->second.end(), rises);
        }
        if (met)
            narrow.push_back(n);
    }
    return narrow;
}

} // namespace windrow::vegetation::fur
