// How a body of a scene's picture moves: its place, and its path, turns, sways and hops upon it.
#pragma once

#include "fluid/setting.h"
#include "fluid/timed_path.h"
#include "scene/ground_source.h"
#include "scene/motion_path.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <tuple>

namespace windrow::scene {

/// Where it is, or from where its path counts.
struct BodyPlace {
    glm::dvec3 position{0.0};
    float yaw_deg = 0.0f;
    float pitch_deg = 0.0f;
    float roll_deg = 0.0f;
    float scale = 1.0f;
    bool above_ground = false;

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &BodyPlace::position, {-1e9, 1e9, "m"}, "Of the mesh's origin."),
            Setting("yaw_deg", &BodyPlace::yaw_deg, {-360.0, 360.0, "deg"}, "Turn about the vertical."),
            Setting("pitch_deg", &BodyPlace::pitch_deg, {-360.0, 360.0, "deg"}, "Turn about its own x, after the yaw."),
            Setting("roll_deg", &BodyPlace::roll_deg, {-360.0, 360.0, "deg"}, "Turn about its own z, after both."),
            Setting("scale", &BodyPlace::scale, {1e-3, 1e3}, "Factor on mesh and coat."),
            Setting("above_ground", &BodyPlace::above_ground, "Whether its height counts from the ground below."),
        };
    }
};

/// To and fro, by a sine.
struct Sway {
    glm::dvec3 by{0.0};
    double turn_deg = 0.0;
    double nod_deg = 0.0;
    double hz = 0.5;
    double phase = 0.0;

    static constexpr auto settings() {
        return std::tuple{
            Setting("by", &Sway::by, {-1e3, 1e3, "m"}, "Farthest from the middle."),
            Setting("turn_deg", &Sway::turn_deg, {0.0, 360.0, "deg"}, "Farthest turn about the vertical."),
            Setting("nod_deg", &Sway::nod_deg, {0.0, 360.0, "deg"}, "Farthest turn about its own x."),
            Setting("hz", &Sway::hz, {0.0, 100.0, "Hz"}, "Of the sine."),
            Setting("phase", &Sway::phase, k_fraction_range, "Fraction of a turn by which it is ahead."),
        };
    }
};

/// Jumps on a parabola, one after another, with a rest between.
struct Hop {
    double height = 0.0;
    double hz = 1.0;
    double rest = 0.3;

    static constexpr auto settings() {
        return std::tuple{
            Setting("height", &Hop::height, {0.0, 100.0, "m", "it stays on the ground"}, "Of a jump."),
            Setting("hz", &Hop::hz, Range::above(0.0, 100.0, "Hz"), "Jumps a second."),
            Setting("rest", &Hop::rest, {0.0, 0.95}, "Fraction of the time on the ground."),
        };
    }
};

struct BodyMotion {
    std::optional<std::size_t> path{};
    bool faces = true;
    double spin_hz = 0.0;
    Sway sway{};
    Hop hop{};
    bool wake = true;

    static constexpr auto settings() {
        return std::tuple{
            Setting("path", &BodyMotion::path, "Name of a path of the scene's, to which the place is added."),
            Setting("faces", &BodyMotion::faces, "Whether its +z looks along the path."),
            Setting("spin_hz", &BodyMotion::spin_hz, {-100.0, 100.0, "Hz"}, "Turns about the vertical a second."),
            Setting("sway", &BodyMotion::sway, "To and fro, by a sine."),
            Setting("hop", &BodyMotion::hop, "Jumps on a parabola, one after another."),
            Setting("wake", &BodyMotion::wake,
                    "Whether a furred body on a path carries the air along, as a wake of its size. A wake or an obstacle of the "
                    "scene on the same path replaces this."),
        };
    }
};

/// Where it is at a time [s]. `path`: its motion's; null: none.
[[nodiscard]] BodyPose pose_at(const BodyPlace& place, const BodyMotion& motion, const MotionPath* path,
                               const GroundSource& ground, double time);

} // namespace windrow::scene
