#include "fluid/debug_lines.h"

#include "fluid/core/message.h"
#include "fluid/portable_math.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace windrow {
namespace {

constexpr int k_most_arrows = 256;

class DebugPen {
  public:
    DebugPen(DebugKind kind, const std::function<void(const DebugLine&)>& draw) : kind_(kind), draw_(draw) {}

    /// Where a body is, and its own axes.
    void place(glm::dvec3 position, glm::dquat orientation = {1.0, 0.0, 0.0, 0.0}) {
        position_ = position;
        orientation_ = orientation;
    }
    /// Between two points along the body's own axes.
    void line(glm::dvec3 from, glm::dvec3 to, float speed = 0.0f) const {
        draw_({.from = position_ + orientation_ * from, .to = position_ + orientation_ * to, .kind = kind_, .speed = speed});
    }
    void circle(glm::dvec3 centre, glm::dvec3 normal, double radius) const {
        constexpr int k_sides = 16;
        const auto [a, b] = across(normal);
        glm::dvec3 last = centre + radius * a;
        for (int side = 1; side <= k_sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / k_sides;
            const glm::dvec3 next = centre + radius * (numerics::cos(angle) * a + numerics::sin(angle) * b);
            line(last, next);
            last = next;
        }
    }
    void ball(double radius) const {
        for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
            circle(glm::dvec3(0.0), axis, radius);
    }
    /// Two circles, and four lines between them.
    void tube(glm::dvec3 from, glm::dvec3 to, double from_radius, double to_radius) const {
        if (from == to)
            return ball(from_radius);
        circle(from, to - from, from_radius);
        circle(to, to - from, to_radius);
        const auto [a, b] = across(to - from);
        for (const glm::dvec3 side : {a, b, -a, -b})
            line(from + from_radius * side, to + to_radius * side);
    }
    void box(glm::dvec3 low, glm::dvec3 high) const {
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 4; ++side) {
                glm::dvec3 from = low;
                from[(axis + 1) % 3] = side % 2 == 0 ? low[(axis + 1) % 3] : high[(axis + 1) % 3];
                from[(axis + 2) % 3] = side / 2 == 0 ? low[(axis + 2) % 3] : high[(axis + 2) % 3];
                glm::dvec3 to = from;
                to[axis] = high[axis];
                line(from, to);
            }
    }
    void arrow(glm::dvec3 from, glm::dvec3 way, float speed = 0.0f) const {
        constexpr double k_head = 0.25; // of the length
        const glm::dvec3 to = from + way;
        line(from, to, speed);
        if (way == glm::dvec3(0.0))
            return;
        const glm::dvec3 side = 0.5 * k_head * glm::length(way) * across(way)[0];
        line(to, to - k_head * way + side, speed);
        line(to, to - k_head * way - side, speed);
    }

  private:
    /// Unit vectors across a direction and each other, the first level where it may be.
    static std::array<glm::dvec3, 2> across(glm::dvec3 direction) {
        const glm::dvec3 along = glm::normalize(direction);
        const glm::dvec3 other = std::abs(along.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
        const glm::dvec3 a = glm::normalize(glm::cross(other, along));
        return {a, glm::cross(along, a)};
    }

    DebugKind kind_;
    const std::function<void(const DebugLine&)>& draw_;
    glm::dvec3 position_{0.0};
    glm::dquat orientation_{1.0, 0.0, 0.0, 0.0};
};

void draw_form(const DebugPen& pen, const Sphere& ball) {
    pen.ball(static_cast<double>(ball.radius));
}
void draw_form(const DebugPen& pen, const Capsule& capsule) {
    const glm::dvec3 half(capsule.half_axis);
    const auto radius = static_cast<double>(capsule.radius);
    const glm::dvec3 cap = half == glm::dvec3(0.0) ? half : radius * glm::normalize(half);
    pen.tube(-half, half, radius, radius);
    pen.line(-half - cap, half + cap);
}
void draw_form(const DebugPen& pen, const AlignedBox& box) {
    pen.box(-glm::dvec3(box.half_size), glm::dvec3(box.half_size));
}
void draw_form(const DebugPen& pen, const Cone& cone) {
    pen.tube(glm::dvec3(0.0), glm::dvec3(cone.axis), static_cast<double>(cone.start_radius),
             static_cast<double>(cone.end_radius));
}
void draw_form(const DebugPen& pen, const Block& block) {
    pen.box(-glm::dvec3(block.half_size), glm::dvec3(block.half_size));
}
void draw_form(const DebugPen& pen, const Cylinder& cylinder) {
    const glm::dvec3 half(0.0, static_cast<double>(cylinder.half_length), 0.0);
    pen.tube(-half, half, static_cast<double>(cylinder.radius), static_cast<double>(cylinder.radius));
}
void draw_form(const DebugPen& pen, const Plate& plate) {
    const glm::dvec3 a(plate.half_size.x, plate.half_size.y, 0.0), b(plate.half_size.x, -plate.half_size.y, 0.0);
    pen.line(a, b);
    pen.line(b, -a);
    pen.line(-a, -b);
    pen.line(-b, a);
}
void draw_form(const DebugPen& pen, const MeshShape& shape) {
    const auto scale = static_cast<double>(shape.scale);
    pen.box(scale * glm::dvec3(shape.mesh->low()), scale * glm::dvec3(shape.mesh->high()));
}
void draw_form(const DebugPen& pen, const VoxelShape& shape) {
    const glm::dvec3 half(detail::half_extent(shape));
    pen.box(-half, half);
}
void draw_form(const DebugPen& pen, const Ground& ground) {
    constexpr int k_parts = 16; // of a side
    const glm::dvec2 size = glm::dvec2(ground.heights->extent());
    const glm::dvec3 scale(ground.scale);
    glm::dvec3 last(0.0);
    for (int n = 0; n <= 4 * k_parts; ++n) {
        const double along = static_cast<double>(n % k_parts) / k_parts;
        const glm::dvec2 sides[] = {{along, 0.0}, {1.0, along}, {1.0 - along, 1.0}, {0.0, 1.0 - along}};
        const glm::dvec2 place = size * sides[n / k_parts % 4];
        const glm::dvec3 next =
            scale * glm::dvec3(place.x, static_cast<double>(ground.heights->height(glm::vec2(place))), place.y);
        if (n > 0)
            pen.line(last, next);
        last = next;
    }
}

void draw_motor(const DebugPen& pen, const DirectionalMotor& motor) {
    std::visit([&](const auto& region) { draw_form(pen, region); }, motor.region);
    pen.arrow(glm::dvec3(0.0), glm::dvec3(glm::normalize(motor.direction)));
}
void draw_motor(const DebugPen& pen, const WakeMotor& motor) {
    pen.ball(static_cast<double>(motor.radius));
}
void draw_motor(const DebugPen& pen, const JetMotor& motor) {
    const glm::dvec3 along = static_cast<double>(motor.length) * glm::dvec3(glm::normalize(motor.direction));
    pen.tube(glm::dvec3(0.0), along, static_cast<double>(motor.start_radius), static_cast<double>(motor.end_radius));
    pen.arrow(glm::dvec3(0.0), along);
}
void draw_motor(const DebugPen& pen, const VortexMotor& motor) {
    const glm::dvec3 half = static_cast<double>(motor.half_length) * glm::dvec3(glm::normalize(motor.axis));
    pen.tube(-half, half, static_cast<double>(motor.radius), static_cast<double>(motor.radius));
    pen.arrow(-half, 2.0 * half);
}
void draw_motor(const DebugPen& pen, const OmniMotor& motor) {
    pen.ball(static_cast<double>(motor.radius));
}
void draw_motor(const DebugPen& pen, const PressureMotor& motor) {
    pen.ball(static_cast<double>(motor.radius));
}

} // namespace

Result<void> debug_lines(const WindControl& wind, const WindReader& air, const DebugView& view,
                         const std::function<void(const DebugLine&)>& draw) {
    if (view.arrows < 0 || view.arrows > k_most_arrows)
        return Error{detail::message("arrows is ", view.arrows, ": give 0 to ", k_most_arrows, " along an axis.")};
    if (!(view.seconds > 0.0f && view.seconds <= 1e6f))
        return Error{detail::message("seconds is ", view.seconds, " s: give a time above 0, at most 1e6.")};
    if (!(std::abs(view.height) <= 1e6))
        return Error{detail::message("height is ", view.height, " m: give a height from -1e6 to 1e6.")};
    const glm::dvec3 low = wind.origin(), size(wind.box().size());
    if (view.box) {
        DebugPen pen(DebugKind::box, draw);
        pen.place(low);
        pen.box(glm::dvec3(0.0), size);
    }
    if (view.motors) {
        DebugPen pen(DebugKind::motor, draw);
        for (const Motors::Slot& slot : wind.motors().slots())
            if (slot.used)
                std::visit(
                    [&](const auto& motor) {
                        pen.place(motor.position);
                        draw_motor(pen, motor);
                    },
                    slot.motor);
    }
    if (view.obstacles) {
        DebugPen pen(DebugKind::obstacle, draw);
        for (const Obstacles::Slot& slot : wind.obstacles().slots())
            if (slot.used) {
                pen.place(slot.obstacle.position, glm::dquat(slot.obstacle.orientation));
                std::visit([&](const auto& shape) { draw_form(pen, shape); }, slot.obstacle.shape);
            }
    }
    if (view.arrows == 0)
        return {};
    const auto now = air.view();
    if (!now)
        return now.failure();
    const DebugPen pen(DebugKind::arrow, draw);
    for (int k = 0; k < view.arrows; ++k)
        for (int i = 0; i < view.arrows; ++i) {
            const glm::dvec3 foot =
                low + glm::dvec3((i + 0.5) / view.arrows * size.x, view.height, (k + 0.5) / view.arrows * size.z);
            const glm::vec3 velocity = now->velocity(foot);
            pen.arrow(foot, static_cast<double>(view.seconds) * glm::dvec3(velocity), glm::length(velocity));
        }
    return {};
}

} // namespace windrow
