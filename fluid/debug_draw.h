// What a host draws over its picture to see the wind: lines and words of the world, by a callback.
//
//     windrow::debug_draw(*wind, *wind, {.arrows = true}, {
//         .line = [&](glm::dvec3 from, glm::dvec3 to, std::uint32_t colour) { host.line(from, to, colour); },
//         .text = [&](glm::dvec3 place, std::string_view words, std::uint32_t colour) { host.text(place, words, colour); }});
//
// Colours are sRGB with alpha, 0xAABBGGRR: red in the lowest byte, as Dear ImGui and textures of eight bits have it. Nothing is kept
// between calls, and what is switched off costs nothing. `windrow view` draws by these calls.
#pragma once

#include "api.h"
#include "motor.h"
#include "obstacle.h"
#include "setting.h"
#include "wind_control.h"
#include "wind_reader.h"

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <string_view>

namespace windrow {

/// What `debug_draw` draws.
struct DebugDraw {
    /// Default true. Edges of the box of cells; dim while the air sleeps.
    bool box = true;
    /// Default false. Edges of the air that is sampled without the ambient wind.
    bool blend_zone = false;
    /// Default true. Forms and directions of the motors.
    bool motors = true;
    /// Default true. Edges of the obstacles; of meshes and grids their box.
    bool obstacles = true;
    /// Default false. Force of the air on each obstacle in the box, 1 m for 50 N.
    bool loads = false;
    /// Default false. Velocity on a level lattice.
    bool arrows = false;
    /// [m] -1e6 to 1e6, default 1. Of the arrows above the box's low face.
    float height = 1.0f;
    /// [m] 0 (24 arrows along the longer side) to 1e6, default 0. Between arrows.
    float spacing = 0.0f;
    /// [m/s] A number above 0, at most 10000, default 10. At which an arrow is as long as the spacing.
    float speed = 10.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("box", &DebugDraw::box, "Edges of the box of cells; dim while the air sleeps."),
            Setting("blend_zone", &DebugDraw::blend_zone, "Edges of the air that is sampled without the ambient wind."),
            Setting("motors", &DebugDraw::motors, "Forms and directions of the motors."),
            Setting("obstacles", &DebugDraw::obstacles, "Edges of the obstacles; of meshes and grids their box."),
            Setting("loads", &DebugDraw::loads, "Force of the air on each obstacle in the box, 1 m for 50 N."),
            Setting("arrows", &DebugDraw::arrows, "Velocity on a level lattice."),
            Setting("height", &DebugDraw::height, {-1e6, 1e6, "m"}, "Of the arrows above the box's low face."),
            Setting("spacing", &DebugDraw::spacing,
                    {.min = 0.0, .max = 1e6, .unit = "m", .zero = "24 arrows along the longer side"}, "Between arrows."),
            Setting("speed", &DebugDraw::speed, Range::above(0.0, 1e4, "m/s"), "At which an arrow is as long as the spacing."),
        };
    }
};

/// Receives what is drawn; one that is empty receives nothing.
struct DebugSink {
    std::function<void(glm::dvec3 from, glm::dvec3 to, std::uint32_t colour)> line{};
    std::function<void(glm::dvec3 place, std::string_view words, std::uint32_t colour)> text{};
};

/// `control` and `reader` are of one wind, on the CPU or on a device. Of a device without cells to read the arrows are the ambient
/// wind's.
WINDROW_API void debug_draw(const WindControl& control, const WindReader& reader, const DebugDraw& settings,
                            const DebugSink& sink);
/// One motor or obstacle alone, as a hand that points at it needs it.
WINDROW_API void debug_draw(const Motor& motor, std::uint32_t colour, const DebugSink& sink);
WINDROW_API void debug_draw(const Obstacle& obstacle, std::uint32_t colour, const DebugSink& sink);

} // namespace windrow
