// Motor as the sources stage evaluates it: plain data relative to the box, with the range of its cells.
#pragma once

#include "api.h"
#include "boundaries.h"
#include "motor.h"
#include "track.h"
#include "window.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace windrow::detail {

struct MotorReach {
    /// As shaders/numerics/motors.glsl numbers them.
    enum class Shape : std::uint32_t { sphere, capsule, box, cone, jet, vortex, path };
    enum class Law : std::uint32_t { force, drive, source };

    Shape shape = Shape::sphere;
    Law law = Law::force;
    glm::vec3 centre{0.0f}; ///< [m] from the box's low corner; first end of a cone, start of a path
    /// [m] Half axis of a capsule or vortex, half size of a box, axis of a cone or jet, end of a path. Source in free air: the
    /// middle of what the walls leave of it.
    glm::vec3 extent{0.0f};
    float radius = 0.0f;     ///< [m] widened to what the cells can hold
    float end_radius = 0.0f; ///< [m] of cones and jets
    float lift = 0.0f;       ///< of vortices
    /// Force: added to f per unit of weight. Drive: the velocity U drawn toward. [m/s^2 or m/s] Jets and vortices: its size in x.
    /// Source in free air: [m^3/s] what comes out of it, in x.
    glm::vec3 push{0.0f};
    /// Drive: exponent per unit of weight. Source: S0 [1/s].
    float amount = 0.0f;
    /// Turbulence of `push`, in its unit: its standard deviation, at full weight; 0: none.
    float eddies = 0.0f;
    float texels = 0.0f;        ///< [1/m] of the gust tile
    glm::vec3 tile_place{0.0f}; ///< [texels] of the box's low corner in the tile, from the centre of its first texel
    glm::ivec3 low{0}, high{0}; ///< cells low <= index < high
};
static_assert(sizeof(MotorReach) == 4 * (2 + 3 + 3 + 3 + 3 + 1 + 5 + 6), "no padding: compared as bytes");

/// Prepares one motor for a tick of `duration` [s] that it begins at `age` [s], having moved along `path`. Writes at most
/// Track::k_max_segments entries to `reach`; returns how many. In free air (boundaries.h) a source is felt from outside the box
/// too, with no cell of its own.
WINDROW_API int prepare(const Motor& motor, const Track& track, std::span<const Track::Segment> path, double age, double duration,
                        const Window& window, const Boundaries& boundaries, std::span<MotorReach> reach);

/// A total order by content: equal only where all is equal.
[[nodiscard]] WINDROW_API bool before(const MotorReach& a, const MotorReach& b);

} // namespace windrow::detail
