// Force of the air on an obstacle.
//
//     const auto wind_on_sail = wind.force_on(sail);                      // after a step
//     if (wind_on_sail)
//         boat.push(wind_on_sail->force, wind_on_sail->moment);           // [N], [N m]
#pragma once

#include <glm/vec3.hpp>

namespace windrow {

/// [kg/m^3] Of the air that forces are of: at 20 C and sea level, as Drag::air_density. They grow in proportion.
inline constexpr float k_air_density = 1.2f;

/// What the pressure of the air does to the part of an obstacle that is in the box: the mean over the last step or tick. It is the
/// momentum that the pressure took from the air.
///
/// Not included: the pressure gradient that drives the ambient wind itself when it changes, the dynamic pressure of the flow of
/// volume sources (the impulse of a blast is), and friction.
struct ObstacleForce {
    glm::vec3 force{0.0f};  ///< [N]
    glm::vec3 moment{0.0f}; ///< [N m] about the obstacle's position
    /// [Pa] Mean pressure on its surface, over that beyond the open boundaries; in a closed box over the mean of the box.
    float pressure = 0.0f;
    /// False where no part of it was in the box in the last step, or it has no surface that cells hold: all else is 0.
    bool in_box = false;
};

} // namespace windrow
