// Pictures of the air: what a person wants to see of a frame, and the contact sheet of a run.
#pragma once

#include "fluid/motors.h"
#include "fluid/result.h"
#include "fluid/wind.h"

#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
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
};

struct PictureSettings {
    std::string title;
    int width = 1600; ///< [pixels] 640 to 8000; an odd one loses a pixel, as video coders want even sizes. The height follows
                      ///< from the box's shape.
    /// [m/s] Speed at the top of the colour bar, > 0; one value for a whole sequence, so that its frames compare. What is no
    /// number above 0 becomes the default: a fresh breeze reaches it.
    float speed_scale = 10.0f;
    /// [m] World point that both slices pass through: its y is the level slice's height, its z the upright one's place. Held
    /// inside the box; what is no number becomes the box's middle.
    glm::dvec3 slice_point{0.0};
};

/// An error of the functions below begins with this where the disk is to blame: it is full, or a quota or size limit is reached.
inline constexpr std::string_view k_disk_fault = "disk fault: ";

/// One PNG: a level and an upright slice of speed with arrows, motors and trails on top, scale bar, colour bar, time. The file
/// appears whole or not at all.
[[nodiscard]] Result<void> draw_frame(const Wind& wind, double time, std::span<const Trail> trails,
                                      std::span<const NamedMotor> motors, const PictureSettings& settings,
                                      const std::filesystem::path& file);

/// One PNG with 1 to 64 frames in order, up to four beside each other, each under its time.
[[nodiscard]] Result<void> draw_contact_sheet(std::span<const std::filesystem::path> frames, const std::filesystem::path& file);

} // namespace windrow::cli
