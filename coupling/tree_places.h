// Where the trees of a stand are, how large they are, and how their crowns slow the air.
//
// A crown is a deposit of drag: as high as the crown, over a square of the area that it covers, with C_d times its leaves' area.
// C_d = 0.2 for the one-sided area of leaves. Leaf area: so many times the area that a crown covers, as grown trees in the open have
// in summer. Shapes are those of the kinds that are drawn (vegetation/trees/tree_presets.h).
// In one header: scene files and the renderer share it, and neither needs the other.
// Based on: Katul, Mahrt, Poggi & Sanz 2004, Boundary-Layer Meteorology 113 (C_d of leaves in canopies).
#pragma once

#include "../fluid/core/validation.h"
#include "../fluid/drag_deposit.h"
#include "../fluid/result.h"
#include "../fluid/setting.h"
#include "chance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace windrow {

/// Place of a tree.
struct TreePlace {
    glm::dvec3 base{0.0};
    float size = 1.0f;
    float yaw_deg = 0.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("base", &TreePlace::base, {-1e9, 1e9, "m"}, "Foot of the trunk."),
            Setting("size", &TreePlace::size, {0.05, 10.0}, "Factor on all its lengths."),
            Setting("yaw_deg", &TreePlace::yaw_deg, {-360.0, 360.0, "deg"}, "Turn about the vertical."),
        };
    }
};

/// Area without trees.
struct ClearCircle {
    glm::dvec2 centre{0.0};
    double radius = 5.0;

    static constexpr auto settings() {
        return std::tuple{
            Setting("centre", &ClearCircle::centre, {-1e9, 1e9, "m"}, "x and z."),
            Setting("radius", &ClearCircle::radius, {0.0, 1e6, "m"}, "Of the circle."),
        };
    }
};

/// Random places: groves rather than an even spread.
struct TreeScatter {
    int count = 0;
    glm::dvec2 low{-100.0};
    glm::dvec2 high{100.0};
    double apart = 4.0;
    float groves = 0.5f;
    double grove_length = 45.0;
    float size_spread = 0.22f;
    std::uint32_t seed = 1;
    std::vector<ClearCircle> clear{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("count", &TreeScatter::count, {0.0, 1e5}, "Maximal number; fewer where the region has no room."),
            Setting("low", &TreeScatter::low, {-1e9, 1e9, "m"}, "Corner of the region, x and z."),
            Setting("high", &TreeScatter::high, {-1e9, 1e9, "m"}, "The other corner, beyond low."),
            Setting("apart", &TreeScatter::apart, {0.0, 1000.0, "m"}, "Least distance between two trunks."),
            Setting("groves", &TreeScatter::groves, k_fraction_range, "0: evenly; 1: only in groves."),
            Setting("grove_length", &TreeScatter::grove_length, {1.0, 1e5, "m"}, "Size of a grove."),
            Setting("size_spread", &TreeScatter::size_spread, {0.0, 0.9}, "Sizes are 1 - spread to 1 + spread."),
            Setting("seed", &TreeScatter::seed, k_seed_range, "Another number, other places."),
            Setting("clear", &TreeScatter::clear, "Circles without trees."),
        };
    }
};

/// [m] The ground's height at x and z: of whatever heightmap a host has.
using GroundHeight = std::function<double(double x, double z)>;

namespace detail {

inline constexpr int k_tree_tries = 40; // a tree, before the region counts as full

// Which of the places so far stand near: a grid whose cells are as wide as trees must be apart.
class TreeNeighbours {
  public:
    explicit TreeNeighbours(double apart) : apart_(apart), cell_(std::max(apart, 0.01)) {}

    [[nodiscard]] bool any_near(glm::dvec2 at) const {
        const glm::i64vec2 here = cell(at);
        for (std::int64_t z = -1; z <= 1; ++z)
            for (std::int64_t x = -1; x <= 1; ++x) {
                const auto found = cells_.find(key({here.x + x, here.y + z}));
                if (found != cells_.end() && std::any_of(found->second.begin(), found->second.end(),
                                                         [&](glm::dvec2 p) { return glm::distance(p, at) < apart_; }))
                    return true;
            }
        return false;
    }
    void add(glm::dvec2 at) { cells_[key(cell(at))].push_back(at); }

  private:
    [[nodiscard]] glm::i64vec2 cell(glm::dvec2 at) const { return glm::i64vec2(glm::floor(at / cell_)); }
    [[nodiscard]] static std::int64_t key(glm::i64vec2 cell) { // modulo 2^64: far away products of signed numbers overflow
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(cell.x) * 0x1fffffffffffULL +
                                         static_cast<std::uint64_t>(cell.y));
    }

    double apart_, cell_; // [m]
    std::unordered_map<std::int64_t, std::vector<glm::dvec2>> cells_{};
};

} // namespace detail

[[nodiscard]] inline Result<void> validate(const TreeScatter& scatter) {
    return detail::validate_settings(scatter, "scatter");
}

inline void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const TreeScatter& scatter) {
    for (int axis = 0; axis < 2; ++axis)
        if (!(scatter.high[axis] > scatter.low[axis]))
            reasons.add(detail::FieldPath{&path, axis == 0 ? "high.x" : "high.z"}, " is ", scatter.high[axis],
                        " m: give more than ", detail::FieldPath{&path, axis == 0 ? "low.x" : "low.z"}, ", which is ",
                        scatter.low[axis], " m.");
}

/// Places of a scatter on a ground: at most `count`, fewer where the region has no room for more. The same arguments, the same
/// places.
[[nodiscard]] inline Result<std::vector<TreePlace>> scatter(const TreeScatter& s, const GroundHeight& ground) {
    if (auto judged = validate(s); !judged)
        return judged.failure();
    detail::Chance chance(s.seed, 6);
    detail::TreeNeighbours neighbours(s.apart);
    std::vector<TreePlace> places;
    const auto wanted = static_cast<std::size_t>(s.count);
    for (std::size_t tries = 0; places.size() < wanted && tries < wanted * detail::k_tree_tries; ++tries) {
        const glm::dvec2 share(static_cast<double>(chance.share()), static_cast<double>(chance.share()));
        const glm::dvec2 at = s.low + share * (s.high - s.low);
        const float grove =
            numerics::windrow_place_noise(glm::vec2((at - s.low) / s.grove_length) + 17.0f * static_cast<float>(s.seed % 64u));
        const float stands = 1.0f - s.groves + s.groves * glm::smoothstep(0.5f, 0.7f, grove);
        const float drawn = chance.share(), size = chance.around(s.size_spread), yaw = chance.share();
        const bool cleared = std::any_of(s.clear.begin(), s.clear.end(), [&](const ClearCircle& circle) {
            return glm::distance(circle.centre, at) < circle.radius;
        });
        if (cleared || drawn >= stands || neighbours.any_near(at))
            continue;
        neighbours.add(at);
        places.push_back({.base = {at.x, ground(at.x, at.y), at.y}, .size = 1.0f + size, .yaw_deg = 360.0f * yaw});
    }
    return places;
}

/// The crown of a grown tree of size 1.
struct TreeCrown {
    std::string_view kind;  ///< as trees::preset_names of vegetation/trees has them
    float height = 1.0f;    ///< [m] of its top over the tree's foot
    float base = 0.0f;      ///< [m] of its lowest leaves
    float radius = 1.0f;    ///< [m] half of its width
    float leaf_area = 1.0f; ///< over the area that it covers
};
inline constexpr std::array<TreeCrown, 4> k_tree_crowns{{{"oak", 12.0f, 2.8f, 5.4f, 4.0f},
                                                         {"birch", 13.0f, 3.3f, 3.1f, 3.0f},
                                                         {"spruce", 15.5f, 0.4f, 3.8f, 7.0f},
                                                         {"bush", 3.2f, 0.5f, 1.8f, 3.0f}}};
inline constexpr float k_leaf_drag = 0.2f; ///< C_d of one side of a leaf

[[nodiscard]] inline PlantDrag drag_of(const TreeCrown& crown, const TreePlace& place) {
    constexpr float k_pi = std::numbers::pi_v<float>;
    const float radius = crown.radius * place.size;
    return {.position = place.base,
            .radius = 0.5f * std::sqrt(k_pi) * radius,
            .base = crown.base * place.size,
            .height = crown.height * place.size,
            .area = k_leaf_drag * crown.leaf_area * k_pi * radius * radius};
}

} // namespace windrow
