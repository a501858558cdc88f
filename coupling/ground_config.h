// What a ground memory is made of, and who walks on it. The formulas: shaders/numerics/ground.glsl.
#pragma once

#include "coupling/spring.h"
#include "fluid/result.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace windrow {

struct GroundConfig {
    /// Texels along each side of the square window, 8 to 512. Default 128: 32 m at 0.25 m, and 1 MB on a device.
    int texels = 128;
    /// [m] Edge of a texel, 0.01 to 100. Default 0.25: a walker's radius covers some of them. Coarser texels show a path as
    /// beads.
    float texel_size = 0.25f;
    /// How the plants swing. One class for the window: grass.
    SpringClass spring = springs::grass;
    /// [rad] Lean to which a walker of weight 1 pushes what is right beside it, 0 to 2.5; pi / 2 is flat, beyond points down.
    /// Default: 80 degrees, just short of flat.
    float push = 1.4f;
    /// Share of that lean that stays as a trail, 0 to 1. 0: plants rise at once; 1: they stay as they were pushed, and rise with
    /// trail_time alone. Default: half stays, so that a trail is seen and the step beside it too.
    float trail_share = 0.5f;
    /// [s] Time in which a trail falls to 1/e, 0.01 to 1e6. Default: some 20 s, gone to the eye after a minute.
    float trail_time = 20.0f;
    /// [s] Time in which the press itself falls to 1/e, 0.01 to 1e6; while pressed, plants do not follow the wind. Default: about
    /// what a blade takes to stand up.
    float trample_time = 0.8f;
    /// [m] Height of the feet above the ground at which they touch no plant more, 0.001 to 100; half of it, half the weight.
    /// Default: knee-high grass.
    float clearance = 0.4f;
    /// [m] Width over which the memory fades to the lean of the wind at the window's edge, 0.001 to a quarter of the window.
    /// Default 2.
    float rim = 2.0f;
    /// [m] A walker who comes further than this in one step was teleported and sweeps nothing, 0.01 to 1e4. Default: 20, 50 m/s
    /// at a slow 2.5 frames a second.
    float longest_stride = 20.0f;
    /// Walkers of a step that touch the window, 1 to 256: room on a device. Of more, the first ones count. Default 64.
    int most_walkers = 64;
};

/// Refuses fields out of range, each with its reason.
[[nodiscard]] Result<void> validate(const GroundConfig& config);

/// A foot, a body, a wheel: a disc that was at `previous` at the step's start and is at `position` at its end.
struct GroundWalker {
    glm::dvec3 position{0.0};   ///< [m] in the world; x and z count, y may be anything
    glm::dvec3 previous{0.0};   ///< [m] the same a step ago; equal: stands
    float feet = 0.0f;          ///< [m] height above the ground now; GroundConfig::clearance and more: airborne
    float previous_feet = 0.0f; ///< [m] a step ago
    /// [m] How far it reaches, above 0, to 100. Below a texel it counts as a texel: a smaller one would fall between their
    /// centres. Default: a person wading through grass.
    float radius = 0.5f;
    float weight = 1.0f; ///< 0 (nothing) to 1 (all of GroundConfig::push)
};

/// Refuses what counts and is not finite, and a radius or weight out of range.
[[nodiscard]] Result<void> validate(const GroundWalker& walker);

/// Where the lean of the wind comes from.
enum class WindLeans : std::uint8_t {
    everywhere, ///< GroundStep::wind_lean
    each_texel  ///< the host gives each texel its own; GroundStep::wind_lean outside of the window
};

/// What the ground is told of a step.
struct GroundStep {
    double duration = 0.0;                   ///< [s] 0 or more
    std::span<const GroundWalker> walkers{}; ///< the nearest first, where there may be more than GroundConfig::most_walkers
    glm::vec2 wind_lean{0.0f}; ///< [rad] bend (x and z) that the wind of now holds plants at, everywhere; within 1e3
};

} // namespace windrow
