// A stand of trees in a scene: one kind at many places. A plain struct that a scene file can hold:
//
//     "trees": [{"kind": "oak", "places": [[x, z, size, yaw_deg], ...],
//                "scatter": {"count": 40, "region": [[x, z], [x, z]], "seed": 3, "clear": [[x, z, radius], ...]}}]
//
// A reader fills `kind` from preset(name), lays overrides of single fields over it, and fills places and scatter.
#pragma once

#include "../../coupling/spring.h"
#include "tree_presets.h"

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace windrow::vegetation::trees {

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

/// A stand. What it draws: `places`, and those of `scatter`.
struct TreeStandSettings {
    TreeKind kind{};
    int variants = 2;
    std::vector<TreePlace> places{};
    TreeScatter scatter{};
    bool springs = true;
    windrow::FlutterClass flutter{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("kind", &TreeStandSettings::kind, "Growth and look of the trees.", k_not_stored),
            Setting("variants", &TreeStandSettings::variants, {1.0, 8.0},
                    "Different trees of the kind; places take them in turn."),
            Setting("places", &TreeStandSettings::places, "Trees at places of their own."),
            Setting("scatter", &TreeStandSettings::scatter, "More trees at random places."),
            Setting("springs", &TreeStandSettings::springs,
                    "Whether trunks, limbs and twigs swing; else they take the bend that the wind holds."),
            Setting("flutter", &TreeStandSettings::flutter, "How its leaves flutter; needles do not."),
        };
    }
};

/// [m] The ground's height at x and z: of whatever heightmap a host has.
using GroundHeight = std::function<double(double x, double z)>;

/// Every reason why it cannot be used, a line each.
[[nodiscard]] windrow::Result<void> validate(const TreeScatter& scatter);
[[nodiscard]] windrow::Result<void> validate(const TreeStandSettings& stand);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const TreeScatter& scatter);

/// Places of a scatter on a ground: at most `count`, fewer where the region has no room for more. The same arguments, the same
/// places.
[[nodiscard]] windrow::Result<std::vector<TreePlace>> scatter(const TreeScatter& scatter, const GroundHeight& ground);
/// All places of a stand: its own, as they are, then those of its scatter.
[[nodiscard]] windrow::Result<std::vector<TreePlace>> places_of(const TreeStandSettings& stand, const GroundHeight& ground);

} // namespace windrow::vegetation::trees
