// Who walks in a scene's picture: it presses the grass down and carries the air along.
#pragma once

#include "coupling/ground_config.h"
#include "fluid/setting.h"
#include "scene/json_object.h"

#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace windrow::scene {

/// A time at which a walker's feet leave the ground, as a jump does: on a parabola.
struct Jump {
    double from = 0.0;
    double until = 0.0;
    float height = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("from", &Jump::from, {-1e9, 1e9, "s"}, "When the feet leave the ground."),
            Setting("until", &Jump::until, {-1e9, 1e9, "s"}, "Later than from."),
            Setting("height", &Jump::height, {0.0, 100.0, "m"}, "Of the feet in its middle."),
        };
    }
};

struct Walker {
    std::size_t path = 0;
    float radius = GroundWalker{}.radius;
    float weight = GroundWalker{}.weight;
    std::vector<Jump> airborne{};
    bool figure = true;
    bool wake = true;

    static constexpr auto settings() {
        return std::tuple{
            Setting("path", &Walker::path, "Name of the path that it walks on; x and z count."),
            Setting("radius", &Walker::radius, Range::above(0.0, 100.0, "m"), "Radius of its effect."),
            Setting("weight", &Walker::weight, k_fraction_range, "0: presses nothing; 1: all of ground_memory.push."),
            Setting("airborne", &Walker::airborne, {0.0, 1024.0},
                    "Times at which its feet leave the ground, on a parabola as a jump does."),
            Setting("figure", &Walker::figure,
                    "Whether a person in a cloak is drawn there, who walks or runs at the speed of the path."),
            Setting(
                "wake", &Walker::wake,
                "Whether it carries the air along where it moves, as a wake of its size; without a figure a ball of its radius. "
                "A wake or an obstacle of the scene on the same path replaces this."),
        };
    }

    /// [m] Height of the feet above the ground.
    [[nodiscard]] float foot_height(double time) const;
};

/// Reads a whole object.
void read_walker(JsonObject object, Walker& walker, std::span<const std::string> path_names);

} // namespace windrow::scene
