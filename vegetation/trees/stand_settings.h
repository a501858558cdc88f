// A stand of trees in a scene: one kind at many places. A plain struct that a scene file can hold:
//
//     "trees": [{"kind": "oak", "places": [[x, z, size, yaw_deg], ...],
//                "scatter": {"count": 40, "region": [[x, z], [x, z]], "seed": 3, "clear": [[x, z, radius], ...]}}]
//
// A reader fills `kind` from preset(name), lays overrides of single fields over it, and fills places and scatter.
#pragma once

#include "vegetation/trees/tree_presets.h"

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace windrow::vegetation::trees {

/// Where a tree stands.
struct TreePlace {
    glm::dvec3 base{0.0}; ///< [m] foot of the trunk
    float size = 1.0f;    ///< factor on all its lengths, 0.05 to 10
    float yaw_deg = 0.0f; ///< turn about the vertical, -360 to 360
};

/// Where none may stand.
struct ClearCircle {
    glm::dvec2 centre{0.0}; ///< [m] x and z
    double radius = 5.0;    ///< [m] 0 to 1e6
};

/// Places by chance: groves rather than an even spread.
struct TreeScatter {
    int count = 0;                       ///< 0 to 100,000
    glm::dvec2 low{-100.0}, high{100.0}; ///< [m] corners of the region, x and z; high beyond low
    double apart = 4.0;                  ///< [m] least distance between two trunks, 0 to 1000
    float groves = 0.5f;                 ///< 0 even, 1 in groves alone
    double grove_length = 45.0;          ///< [m] size of a grove, 1 to 1e5
    float size_spread = 0.22f;           ///< sizes are 1 - spread to 1 + spread, 0 to 0.9
    std::uint32_t seed = 1;              ///< another number, other places
    std::vector<ClearCircle> clear{};
};

/// A stand. What it draws: `places`, and those of `scatter`.
struct TreeStandSettings {
    TreeKind kind{};
    int variants = 2; ///< different trees of the kind, 1 to 8: places take them in turn
    std::vector<TreePlace> places{};
    TreeScatter scatter{};
    bool springs = true; ///< trunks, limbs and twigs swing; without, they take the bend that the wind holds
};

/// [m] The ground's height at x and z: of whatever heightmap a host has.
using GroundHeight = std::function<double(double x, double z)>;

/// Every reason why it cannot be used, a line each.
[[nodiscard]] windrow::Result<void> validate(const TreeScatter& scatter);
[[nodiscard]] windrow::Result<void> validate(const TreeStandSettings& stand);

/// Places of a scatter on a ground: at most `count`, fewer where the region has no room for more. The same arguments, the same
/// places.
[[nodiscard]] windrow::Result<std::vector<TreePlace>> scatter(const TreeScatter& scatter, const GroundHeight& ground);
/// All places of a stand: its own, as they are, then those of its scatter.
[[nodiscard]] windrow::Result<std::vector<TreePlace>> places_of(const TreeStandSettings& stand, const GroundHeight& ground);

} // namespace windrow::vegetation::trees
