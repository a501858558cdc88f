// The eye of a window: it circles a point, flies, follows what the box follows, or is the scene's own camera.
#pragma once

#include "vegetation/render/scene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace windrow::vegetation::view {

enum class EyeMode { orbit, fly, follow, scene };

class Eye {
  public:
    explicit Eye(const render::Camera& camera) { look(camera); }

    /// From there on; the lens is the camera's.
    void look(const render::Camera& camera);
    /// Changes the mode and keeps the view.
    void set_mode(EyeMode mode) { mode_ = mode; }
    [[nodiscard]] EyeMode mode() const { return mode_; }
    /// By angles [rad]: around the target, or on the spot where it flies.
    void turn(double yaw, double pitch);
    /// Moves the target across the view, as fractions of the distance.
    void pan(double right, double up);
    /// Toward the target for factors below 1.
    void zoom(double factor);
    /// [m] Along the view and across it.
    void fly(glm::dvec3 right_up_forward);
    /// The point that `follow` keeps its place to.
    void follow(glm::dvec3 point);
    /// With `scene`: the scene's own camera now.
    [[nodiscard]] render::Camera camera(const render::Camera& scene) const;
    [[nodiscard]] glm::dvec3 target() const { return target_; }

  private:
    [[nodiscard]] glm::dvec3 backward() const;

    EyeMode mode_ = EyeMode::orbit;
    render::Camera lens_{};
    glm::dvec3 target_{0.0};
    double yaw_ = 0.0, pitch_ = 0.2, distance_ = 10.0;
    std::optional<glm::dvec3> followed_{};
};

/// Where places of the world are in a picture, and the way back.
class Projection {
  public:
    Projection(const render::Camera& camera, glm::vec2 size);

    /// [px] From the left top corner; none behind the eye.
    [[nodiscard]] std::optional<glm::vec2> pixel(glm::dvec3 place) const;
    /// The ray through a pixel.
    [[nodiscard]] glm::dvec3 ray(glm::vec2 pixel) const;
    /// Where the ray meets the level plane of a height; none where it leads away or beyond 10 km.
    [[nodiscard]] std::optional<glm::dvec3> on_level(glm::vec2 pixel, double height) const;
    [[nodiscard]] glm::dvec3 eye() const { return eye_; }
    /// The part of a segment before the eye, in pixels; none where all is behind.
    [[nodiscard]] std::optional<std::pair<glm::vec2, glm::vec2>> segment(glm::dvec3 from, glm::dvec3 to) const;

  private:
    [[nodiscard]] glm::dvec4 clip(glm::dvec3 place) const;
    [[nodiscard]] glm::vec2 pixel_of(glm::dvec4 clip) const;

    glm::dvec3 eye_;
    glm::dmat4 matrix_, inverse_;
    glm::vec2 size_;
};

} // namespace windrow::vegetation::view
