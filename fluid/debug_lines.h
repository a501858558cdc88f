// Lines that show a wind in a host's debug view: its box, motors, obstacles, and arrows along the velocity.
//
//     auto shown = windrow::debug_lines(wind, wind, {.arrows = 16, .height = 1.5},
//                                       [&](const windrow::DebugLine& line) { draw(line.from, line.to, colour_of(line)); });
//
// It reads the wind of this frame and keeps nothing: a host that does not call it pays nothing.
#pragma once

#include "api.h"
#include "result.h"
#include "wind_control.h"
#include "wind_reader.h"

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>

namespace windrow {

/// What a line belongs to; hosts have a colour for each.
enum class DebugKind : std::uint8_t { box, motor, obstacle, arrow };

struct DebugLine {
    glm::dvec3 from{0.0}, to{0.0}; ///< [m] in the world
    DebugKind kind = DebugKind::box;
    float speed = 0.0f; ///< [m/s] of the wind at an arrow's foot; 0 of others
};

struct DebugView {
    bool box = true;
    bool motors = true;
    bool obstacles = true;
    int arrows = 16; ///< along each level axis, 0 (none) to 256: 16 are 256 arrows of three lines, which a view still shows apart
    float seconds = 0.2f; ///< [s] an arrow is as long as the way of the air in this time; above 0: 10 m/s are 2 m
    double height = 1.0;  ///< [m] of the arrows above the box's low face: 1 m above a floor, where players are
};

/// draw(line) for each line, in an order that does not change. Forms without a wire drawing of their own (meshes, voxels, grounds) are
/// drawn as the box that holds them, a ground as its edge. Rejects settings out of range, and arrows on a device before its first
/// read-back. What `draw` throws goes through.
[[nodiscard]] WINDROW_API Result<void> debug_lines(const WindControl& wind, const WindReader& air, const DebugView& view,
                                                   const std::function<void(const DebugLine&)>& draw);

} // namespace windrow
