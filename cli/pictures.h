// Pictures of the air: what a person wants to see of a frame, and the contact sheet of a run.
#pragma once

#include "cases/backend_wind.h"
#include "fluid/motors.h"
#include "fluid/obstacle.h"
#include "fluid/result.h"
#include "scene/scene.h"

#include <array>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace windrow::cli {

/// The path of something that moves through the scene, in world metres: the player that the box follows, a wake's body.
struct Trail {
    std::string name;               ///< that of a wake motor: its body is drawn once, with its radius
    std::vector<glm::dvec3> points; ///< where it has been and will be, in order of time
    glm::dvec3 now{0.0};
    bool followed = false; ///< the box follows it
};

struct NamedMotor {
    std::string name;
    Motor motor;
    double strength = 1.0; ///< share of its full strength now; below 0: the other way round, as a burst that draws back
};

struct NamedObstacle {
    std::string name;  ///< empty: none is written
    Obstacle obstacle; ///< as it is now
};

/// How many of each kind, in the order of windrow::Motor.
using MotorCounts = std::array<int, std::variant_size_v<Motor>>;

struct PictureSettings {
    std::string title;
    /// [pixels] 640 to 8000; an odd one loses a pixel, as video coders want even sizes. The height follows from the box's shape.
    int width = 1600;
    /// [m/s] Speed at the top of the colour bar, > 0; one value for a whole sequence, so that its frames compare. What is no
    /// number above 0 becomes the default: a fresh breeze reaches it.
    float speed_scale = 10.0f;
    /// [m] World point that both slices pass through: its y is the level slice's height, its z the upright one's place. Held
    /// inside the box; what is no number becomes the box's middle.
    glm::dvec3 slice_point{0.0};
    /// The level slice follows the ground (Ground), as far above it as slice_point is above the box's low face.
    bool above_ground = false;
    /// Motors of the whole scene: the legend names the kinds among them and says how many act.
    MotorCounts motors_of_scene{};
    scene::FlowMarks flow = scene::FlowMarks::arrows;
};

/// [pixels] A part of a picture.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;
};
/// Where the parts of a frame lie: both slices with their captions and axes, and the legend.
struct FrameParts {
    PixelRect level, upright, legend;
};
/// The same for all frames of a run: it depends on the box's shape and the picture's width alone.
[[nodiscard]] FrameParts frame_parts(const cases::BackendWind& wind, const PictureSettings& settings);

/// An error of the functions below begins with this where the disk is to blame: it is full, or a quota or size limit is reached.
inline constexpr std::string_view k_disk_fault = "disk fault: ";

/// One PNG: a level and an upright slice of speed and of obstacles, with marks of the flow, motors and trails on top, scale bar,
/// colour bar, time. The file appears whole or not at all.
[[nodiscard]] Result<void> draw_frame(const cases::BackendWind& wind, double time, std::span<const Trail> trails,
                                      std::span<const NamedMotor> motors, std::span<const NamedObstacle> obstacles,
                                      const PictureSettings& settings, const std::filesystem::path& file);

/// One PNG with 1 to 64 frames in order, up to four beside each other, each under its time. With `parts` a tile holds the slices
/// alone, and the legend of the last frame stands once, at the foot.
[[nodiscard]] Result<void> draw_contact_sheet(std::span<const std::filesystem::path> frames, const std::filesystem::path& file,
                                              const std::optional<FrameParts>& parts = {});

} // namespace windrow::cli
