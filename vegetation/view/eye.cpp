#include "vegetation/view/eye.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace windrow::vegetation::view {
namespace {

constexpr double k_steepest = 1.5; // [rad] a camera does not look straight up or down

} // namespace

glm::dvec3 Eye::backward() const {
    return {std::cos(pitch_) * std::cos(yaw_), std::sin(pitch_), std::cos(pitch_) * std::sin(yaw_)};
}

void Eye::look(const render::Camera& camera) {
    lens_ = camera;
    target_ = camera.target;
    const glm::dvec3 back = camera.position - camera.target;
    distance_ = std::max(glm::length(back), 0.1);
    pitch_ = std::clamp(std::asin(std::clamp(back.y / distance_, -1.0, 1.0)), -k_steepest, k_steepest);
    yaw_ = std::atan2(back.z, back.x);
    followed_.reset();
}

void Eye::turn(double yaw, double pitch) {
    const glm::dvec3 eye = target_ + distance_ * backward();
    yaw_ = std::remainder(yaw_ + yaw, 2.0 * std::numbers::pi);
    pitch_ = std::clamp(pitch_ + pitch, -k_steepest, k_steepest);
    if (mode_ == EyeMode::fly)
        target_ = eye - distance_ * backward();
}

void Eye::pan(double right, double up) {
    fly({distance_ * right, distance_ * up, 0.0});
}

void Eye::zoom(double factor) {
    distance_ = std::clamp(distance_ * factor, 0.1, 1e5);
}

void Eye::fly(glm::dvec3 way) {
    const glm::dvec3 forward = -backward();
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)));
    target_ += way.x * right + way.y * glm::cross(right, forward) + way.z * forward;
}

void Eye::follow(glm::dvec3 point) {
    if (mode_ == EyeMode::follow && followed_)
        target_ += point - *followed_;
    followed_ = point;
}

render::Camera Eye::camera(const render::Camera& scene) const {
    if (mode_ == EyeMode::scene)
        return scene;
    render::Camera camera = lens_;
    camera.target = target_;
    camera.position = target_ + distance_ * backward();
    return camera;
}

Projection::Projection(const render::Camera& camera, glm::vec2 size) : eye_(camera.position), size_(size) {
    // Relative to the eye, so that it is as exact 1000 km away.
    const glm::dmat4 view = glm::lookAt(glm::dvec3(0.0), camera.target - camera.position, glm::dvec3(0.0, 1.0, 0.0));
    const glm::dmat4 lens = glm::perspective(glm::radians(static_cast<double>(camera.view_deg)),
                                             static_cast<double>(size.x) / static_cast<double>(size.y), 0.01, 1e6);
    matrix_ = lens * view;
    inverse_ = glm::inverse(matrix_);
}

glm::dvec4 Projection::clip(glm::dvec3 place) const {
    return matrix_ * glm::dvec4(place - eye_, 1.0);
}

glm::vec2 Projection::pixel_of(glm::dvec4 clip) const {
    return {static_cast<float>((0.5 + 0.5 * clip.x / clip.w) * static_cast<double>(size_.x)),
            static_cast<float>((0.5 - 0.5 * clip.y / clip.w) * static_cast<double>(size_.y))};
}

std::optional<glm::vec2> Projection::pixel(glm::dvec3 place) const {
    const glm::dvec4 at = clip(place);
    if (!(at.w > 0.01))
        return std::nullopt;
    return pixel_of(at);
}

std::optional<std::pair<glm::vec2, glm::vec2>> Projection::segment(glm::dvec3 from, glm::dvec3 to) const {
    constexpr double k_before = 0.05; // [m] of the eye
    glm::dvec4 a = clip(from), b = clip(to);
    if (a.w < k_before && b.w < k_before)
        return std::nullopt;
    if (a.w < k_before)
        a += (b - a) * ((k_before - a.w) / (b.w - a.w));
    if (b.w < k_before)
        b += (a - b) * ((k_before - b.w) / (a.w - b.w));
    return std::pair{pixel_of(a), pixel_of(b)};
}

glm::dvec3 Projection::ray(glm::vec2 pixel) const {
    const glm::dvec4 at(2.0 * static_cast<double>(pixel.x / size_.x) - 1.0, 1.0 - 2.0 * static_cast<double>(pixel.y / size_.y),
                        0.5, 1.0);
    const glm::dvec4 place = inverse_ * at;
    return glm::normalize(glm::dvec3(place) / place.w);
}

std::optional<glm::dvec3> Projection::on_level(glm::vec2 pixel, double height) const {
    const glm::dvec3 way = ray(pixel);
    const double far = (height - eye_.y) / way.y;
    if (!(far > 0.0) || far > 1e4)
        return std::nullopt;
    return eye_ + far * way;
}

} // namespace windrow::vegetation::view
