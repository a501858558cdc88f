// Settings of a ground memory, its walkers and its steps. The formulas: shaders/numerics/ground.glsl.
#pragma once

#include "../fluid/api.h"
#include "../fluid/result.h"
#include "spring.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace windrow {

/// Memory of trodden ground: its square of texels, and how fast the ground rises again.
struct GroundConfig {
    /// 8 to 512, default 128. Texels along each edge of its square window. 128 are 32 m at 0.25 m, and 1 MB on a device.
    int texels = 128;
    /// [m] 0.01 to 100, default 0.25. Edge of a texel. At 0.25 a walker's radius covers several; with coarser ones a path looks
    /// like beads.
    float texel_size = 0.25f;
    /// Spring of the plants, one class for the window. Default: grass.
    SpringClass spring = springs::grass;
    /// [rad] 0 to 2.5, default 1.4. Lean of plants right beside a walker of weight 1. pi/2 is flat, more points down; 1.4 is
    /// nearly flat.
    float push = 1.4f;
    /// 0 to 1, default 0.5. Fraction of that lean that stays as a trail. 0: plants rise at once; 1: with trail_time alone.
    float trail_fraction = 0.5f;
    /// [s] 0.01 to 1e6, default 20. Time in which a trail falls to 1/e. With 20 it is invisible after a minute.
    float trail_time = 20.0f;
    /// [s] 0.01 to 1e6, default 0.8. Time in which the pressing falls to 1/e, about the time in which a blade rises. Pressed
    /// plants do not follow the wind.
    float trample_time = 0.8f;
    /// [m] 0.001 to 100, default 0.4. Height of the feet above which they do not touch plants; 0.4 is knee-high grass. At half of
    /// it the weight is half. Feet that are deeper in the ground than this press less, and from twice of it nothing.
    float clearance = 0.4f;
    /// [m] 0.001 to 12800, default 2. Width over which the memory fades to the lean of the wind at the window's edge; at most a
    /// quarter of the window.
    float blend_width = 2.0f;
    /// [m/s] 0 (never) to 1e9, default 100. A walker that moved faster in the step has jumped: it stands at its new place and
    /// sweeps nothing on the way. As that of the wind (Config::jump_speed).
    float jump_speed = 100.0f;
    /// 1 to 256, default 64. Maximal number of walkers in the window per step. Of more, only the first ones count.
    int max_walkers = 64;

    static constexpr auto settings() {
        return std::tuple{
            Setting("texels", &GroundConfig::texels, {8.0, 512.0},
                    "Texels along each edge of its square window. 128 are 32 m at 0.25 m, and 1 MB on a device."),
            Setting("texel_size", &GroundConfig::texel_size, {0.01, 100.0, "m"},
                    "Edge of a texel. At 0.25 a walker's radius covers several; with coarser ones a path looks like beads."),
            Setting("spring", &GroundConfig::spring, "Spring of the plants, one class for the window. Default: grass."),
            Setting("push", &GroundConfig::push, {0.0, 2.5, "rad"},
                    "Lean of plants right beside a walker of weight 1. pi/2 is flat, more points down; 1.4 is nearly flat."),
            Setting("trail_fraction", &GroundConfig::trail_fraction, k_fraction_range,
                    "Fraction of that lean that stays as a trail. 0: plants rise at once; 1: with trail_time alone."),
            Setting("trail_time", &GroundConfig::trail_time, {0.01, 1e6, "s"},
                    "Time in which a trail falls to 1/e. With 20 it is invisible after a minute."),
            Setting(
                "trample_time", &GroundConfig::trample_time, {0.01, 1e6, "s"},
                "Time in which the pressing falls to 1/e, about the time in which a blade rises. Pressed plants do not follow "
                "the wind."),
            Setting("clearance", &GroundConfig::clearance, {0.001, 100.0, "m"},
                    "Height of the feet above which they do not touch plants; 0.4 is knee-high grass. At half of it the weight "
                    "is half. Feet that are deeper in the ground than this press less, and from twice of it nothing."),
            Setting("blend_width", &GroundConfig::blend_width, {0.001, 12800.0, "m"},
                    "Width over which the memory fades to the lean of the wind at the window's edge; at most a quarter of the "
                    "window."),
            Setting(
                "jump_speed", &GroundConfig::jump_speed, {0.0, 1e9, "m/s", "never"},
                "A walker that moved faster in the step has jumped: it stands at its new place and sweeps nothing on the way. As "
                "that of the wind (Config::jump_speed)."),
            Setting("max_walkers", &GroundConfig::max_walkers, {1.0, 256.0},
                    "Maximal number of walkers in the window per step. Of more, only the first ones count."),
        };
    }
};

/// Rejects fields out of range, each with its reason.
[[nodiscard]] WINDROW_API Result<void> validate(const GroundConfig& config);
namespace detail {
class Reasons;
struct FieldPath;
} // namespace detail
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const GroundConfig& config);

/// A foot, a body, a wheel: a disc that was at `previous` at the step's start and is at `position` at its end.
struct GroundWalker {
    glm::dvec3 position{0.0};          ///< [m] in the world; x and z count, y may be anything
    glm::dvec3 previous{0.0};          ///< [m] the same a step ago; equal: stands
    float foot_height = 0.0f;          ///< [m] height above the ground now; GroundConfig::clearance and more: airborne
    float previous_foot_height = 0.0f; ///< [m] a step ago
    /// [m] How far it reaches, above 0, to 100. Below a texel it counts as a texel: a smaller one would fall between their
    /// centres. Default: a person wading through grass.
    float radius = 0.5f;
    float weight = 1.0f; ///< 0 (nothing) to 1 (all of GroundConfig::push)
};

/// Rejects what counts and is not finite, and a radius or weight out of range.
[[nodiscard]] WINDROW_API Result<void> validate(const GroundWalker& walker);

/// Source of the lean of the wind.
enum class WindLeans : std::uint8_t {
    everywhere, ///< GroundStep::wind_lean
    each_texel  ///< the host gives each texel its own; GroundStep::wind_lean outside of the window
};

/// Input of one step of the ground memory.
struct GroundStep {
    double duration = 0.0;                   ///< [s] 0 or more
    std::span<const GroundWalker> walkers{}; ///< the nearest first, where there may be more than GroundConfig::max_walkers
    glm::vec2 wind_lean{0.0f}; ///< [rad] bend (x and z) that the wind of now holds plants at, everywhere; within 1e3
};

} // namespace windrow
