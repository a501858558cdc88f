// Distances: exact for each shape. Based on: Hart 1996, "Sphere tracing", The Visual Computer 12 (the march along a segment).
#include "fluid/obstacle.h"

#include "fluid/message.h"
#include "fluid/validation.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace windrow {
namespace detail {
namespace {

float distance(const Sphere& ball, glm::vec3 p) {
    return glm::length(p) - ball.radius;
}

float distance(const Capsule& capsule, glm::vec3 p) {
    const float square = glm::dot(capsule.half_axis, capsule.half_axis);
    const float along = square > 0.0f ? std::clamp(glm::dot(p, capsule.half_axis) / square, -1.0f, 1.0f) : 0.0f;
    return glm::length(p - along * capsule.half_axis) - capsule.radius;
}

float distance(const Block& block, glm::vec3 p) {
    const glm::vec3 beyond = glm::abs(p) - block.half_size;
    return glm::length(glm::max(beyond, 0.0f)) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0f);
}

float distance(const Cylinder& cylinder, glm::vec3 p) {
    const glm::vec2 beyond(std::hypot(p.x, p.z) - cylinder.radius, std::abs(p.y) - cylinder.half_length);
    return glm::length(glm::max(beyond, 0.0f)) + std::min(std::max(beyond.x, beyond.y), 0.0f);
}

float distance(const Plate& plate, glm::vec3 p) {
    return glm::length(glm::vec3(glm::max(glm::abs(glm::vec2(p)) - plate.half_size, 0.0f), p.z));
}

glm::vec3 extent(const Sphere& ball) {
    return glm::vec3(ball.radius);
}
glm::vec3 extent(const Capsule& capsule) {
    return glm::abs(capsule.half_axis) + capsule.radius;
}
glm::vec3 extent(const Block& block) {
    return block.half_size;
}
glm::vec3 extent(const Cylinder& cylinder) {
    return {cylinder.radius, cylinder.half_length, cylinder.radius};
}
glm::vec3 extent(const Plate& plate) {
    return {plate.half_size, 0.0f};
}

// A point on the plane counts as above it, so that each path between its sides has one crossing at least.
bool crosses(const Plate& plate, glm::vec3 from, glm::vec3 to) {
    if ((from.z < 0.0f) == (to.z < 0.0f))
        return false;
    const glm::vec3 at = from + from.z / (from.z - to.z) * (to - from);
    return std::abs(at.x) <= plate.half_size.x && std::abs(at.y) <= plate.half_size.y;
}

} // namespace

float distance_to(const Shape& shape, glm::vec3 point) {
    return std::visit([&](const auto& kind) { return distance(kind, point); }, shape);
}

glm::vec3 half_extent(const Shape& shape) {
    return std::visit([](const auto& kind) { return extent(kind); }, shape);
}

bool same(const Shape& a, const Shape& b) {
    return a.index() == b.index() &&
           std::visit(
               [&]<class Kind>(const Kind& kind) {
                   static_assert(std::is_trivially_copyable_v<Kind> && sizeof(Kind) % sizeof(float) == 0);
                   return std::memcmp(&kind, std::get_if<Kind>(&b), sizeof(Kind)) == 0;
               },
               a);
}

float thickness(const Shape& shape) {
    const glm::vec3 half = half_extent(shape);
    const auto* const capsule = std::get_if<Capsule>(&shape);
    return 2.0f * (capsule != nullptr ? capsule->radius : std::min({half.x, half.y, half.z}));
}

bool blocks(const Shape& shape, glm::vec3 from, glm::vec3 to) {
    if (const auto* plate = std::get_if<Plate>(&shape))
        return crosses(*plate, from, to);
    constexpr int k_most_steps = 64;
    const float length = glm::distance(from, to), near = 1e-4f * length;
    float way = 0.0f;
    for (int n = 0; n < k_most_steps && way < length; ++n) {
        const float free = distance_to(shape, from + way / length * (to - from));
        if (free <= near)
            return true;
        way += free;
    }
    return way < length;
}

Result<void> validate_pose(glm::dvec3 position, glm::quat orientation) {
    Reasons reasons;
    const FieldPath obstacle{nullptr, "obstacle"};
    check_value(reasons, FieldPath{&obstacle, "position"}, position, k_world_range);
    check_value(reasons, FieldPath{&obstacle, "orientation"}, orientation, {});
    return reasons.outcome();
}

} // namespace detail

Result<void> validate(const Obstacle& obstacle) {
    return detail::validate_settings(obstacle, "obstacle");
}

} // namespace windrow
