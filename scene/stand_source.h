// A stand of trees of a scene's picture: a renderer draws it, and its crowns slow the air (coupling/tree_places.h).
#pragma once

#include "coupling/spring.h"
#include "coupling/tree_places.h"
#include "scene/ground_source.h"
#include "scene/json_object.h"

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace windrow::scene {

/// A tree at a place of its own; it stands on the ground there.
struct StandPlace {
    glm::dvec2 at{0.0};
    float size = 1.0f;
    float yaw_deg = 0.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("at", &StandPlace::at, {-1e9, 1e9, "m"}, "x and z; it is on the ground there."),
            Setting("size", &StandPlace::size, {0.05, 10.0}, "Factor on all its lengths."),
            Setting("yaw_deg", &StandPlace::yaw_deg, {-360.0, 360.0, "deg"}, "Turn about the vertical."),
        };
    }
};

/// Trees of one kind.
struct StandSource {
    std::string kind = "oak";
    std::uint32_t seed = 1;
    int variants = 2;
    bool springs = true;
    bool slows_air = true;
    FlutterClass flutter{};
    std::vector<StandPlace> places{};
    TreeScatter scatter{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("kind", &StandSource::kind, "Kind of tree, of trees::preset_names."),
            Setting("seed", &StandSource::seed, k_seed_range, "Another number, other trees of the kind."),
            Setting("variants", &StandSource::variants, {1.0, 8.0}, "Different trees of the kind; places take them in turn."),
            Setting("springs", &StandSource::springs,
                    "Whether trunks, limbs and twigs swing; else they take the bend that the wind holds."),
            Setting("slows_air", &StandSource::slows_air,
                    "Whether the crowns slow the air, as deposits of drag of the kind's size and leaves."),
            Setting("flutter", &StandSource::flutter, "How its leaves flutter; needles do not."),
            Setting("places", &StandSource::places, "Trees at places of their own."),
            Setting("scatter", &StandSource::scatter, "And more at random."),
        };
    }
};

/// Reads a whole object.
void read_stand(JsonObject object, StandSource& stand);

/// All trees of a valid stand, on the ground.
[[nodiscard]] std::vector<TreePlace> places_of(const StandSource& stand, const GroundSource& ground);
/// Their crowns, as deposits.
[[nodiscard]] std::vector<DragDeposit> drag_of(const StandSource& stand, const GroundSource& ground);

/// A stand that slows the air.
struct PlantedStand {
    std::string key; ///< for sentences: "picture.trees[0]"
    StandSource stand{};
    GroundSource ground{};
};

} // namespace windrow::scene
