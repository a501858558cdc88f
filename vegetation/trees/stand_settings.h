// A stand of trees in a scene: one kind at many places. A plain struct that a scene file can hold:
//
//     "trees": [{"kind": "oak", "places": [[x, z, size, yaw_deg], ...],
//                "scatter": {"count": 40, "region": [[x, z], [x, z]], "seed": 3, "clear": [[x, z, radius], ...]}}]
//
// A reader fills `kind` from preset(name), lays overrides of single fields over it, and fills places and scatter.
#pragma once

#include "../../coupling/spring.h"
#include "../../coupling/tree_places.h"
#include "tree_presets.h"

#include <vector>

namespace windrow::vegetation::trees {

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

/// Every reason why it cannot be used, a line each.
[[nodiscard]] windrow::Result<void> validate(const TreeStandSettings& stand);

/// All places of a stand: its own, as they are, then those of its scatter.
[[nodiscard]] windrow::Result<std::vector<TreePlace>> places_of(const TreeStandSettings& stand, const GroundHeight& ground);

} // namespace windrow::vegetation::trees
