#include "fluid/debug_draw.h"

#include "fluid/core/message.h"
#include "fluid/obstacle_force.h"
#include "fluid/portable_math.h"
#include "fluid/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

namespace windrow {
namespace {

constexpr std::uint32_t k_box = 0xffe0e0e0, k_asleep = 0x60e0e0e0, k_zone = 0xa0e0b060, k_motor = 0xff30b0ff,
                        k_obstacle = 0xffd0a040, k_load = 0xff4040ff, k_arrow = 0xfff0f080;
constexpr int k_round = 24; // corners of a circle

/// Lines from shapes.
class Pen {
  public:
    Pen(const DebugSink& sink, std::uint32_t colour) : sink_(sink), colour_(colour) {}

    void line(glm::dvec3 from, glm::dvec3 to) const { sink_.line(from, to, colour_); }
    /// The box of `half` along three axes.
    void block(glm::dvec3 middle, const glm::dmat3& axes, glm::dvec3 half) const {
        for (int axis = 0; axis < 3; ++axis)
            for (int edge = 0; edge < 4; ++edge) {
                glm::dvec3 corner(0.0);
                corner[(axis + 1) % 3] = (edge & 1 ? 1.0 : -1.0) * half[(axis + 1) % 3];
                corner[(axis + 2) % 3] = (edge & 2 ? 1.0 : -1.0) * half[(axis + 2) % 3];
                glm::dvec3 end = corner;
                corner[axis] = -half[axis];
                end[axis] = half[axis];
                line(middle + axes * corner, middle + axes * end);
            }
    }
    void circle(glm::dvec3 middle, glm::dvec3 across, glm::dvec3 up, double radius) const {
        glm::dvec3 before = middle + radius * across;
        for (int n = 1; n <= k_round; ++n) {
            const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(n) / k_round;
            const glm::dvec3 next = middle + radius * (static_cast<double>(numerics::cos(angle)) * across +
                                                       static_cast<double>(numerics::sin(angle)) * up);
            line(before, next);
            before = next;
        }
    }
    void ball(glm::dvec3 middle, double radius) const {
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 across(0.0), up(0.0);
            across[(axis + 1) % 3] = up[(axis + 2) % 3] = 1.0;
            circle(middle, across, up, radius);
        }
    }
    /// Rings at both ends, and four lines.
    void tube(glm::dvec3 from, glm::dvec3 to, double first, double last) const {
        const glm::dvec3 along = glm::length(to - from) > 0.0 ? glm::normalize(to - from) : glm::dvec3(0.0, 1.0, 0.0);
        const glm::dvec3 other = std::abs(along.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
        const glm::dvec3 across = glm::normalize(glm::cross(along, other)), up = glm::cross(across, along);
        circle(from, across, up, first);
        circle(to, across, up, last);
        for (const glm::dvec3 side : {across, up, -across, -up})
            line(from + first * side, to + last * side);
    }
    void arrow(glm::dvec3 from, glm::dvec3 way) const {
        const double length = glm::length(way);
        if (!(length > 0.0))
            return;
        const glm::dvec3 along = way / length, tip = from + way;
        const glm::dvec3 other = std::abs(along.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
        const glm::dvec3 aside = glm::normalize(glm::cross(along, other));
        line(from, tip);
        line(tip, tip - 0.25 * length * along + 0.12 * length * aside);
        line(tip, tip - 0.25 * length * along - 0.12 * length * aside);
    }

  private:
    const DebugSink& sink_;
    std::uint32_t colour_;
};

glm::dvec3 unit(glm::vec3 direction) {
    const glm::dvec3 wide(direction);
    return glm::length(wide) > 0.0 ? glm::normalize(wide) : glm::dvec3(1.0, 0.0, 0.0);
}

void draw_region(const Pen& pen, glm::dvec3 place, const Region& region) {
    if (const auto* const ball = std::get_if<Sphere>(&region))
        pen.ball(place, static_cast<double>(ball->radius));
    else if (const auto* const capsule = std::get_if<Capsule>(&region)) {
        const glm::dvec3 half(capsule->half_axis);
        pen.tube(place - half, place + half, static_cast<double>(capsule->radius), static_cast<double>(capsule->radius));
    } else if (const auto* const box = std::get_if<AlignedBox>(&region))
        pen.block(place, glm::dmat3(1.0), glm::dvec3(box->half_size));
    else if (const auto* const cone = std::get_if<Cone>(&region))
        pen.tube(place, place + glm::dvec3(cone->axis), static_cast<double>(cone->start_radius),
                 static_cast<double>(cone->end_radius));
}

void draw_shape(const Pen& pen, const Obstacle& body) {
    const glm::dmat3 axes = glm::mat3_cast(glm::dquat(glm::normalize(body.orientation)));
    if (const auto* const ball = std::get_if<Sphere>(&body.shape))
        pen.ball(body.position, static_cast<double>(ball->radius));
    else if (const auto* const cylinder = std::get_if<Cylinder>(&body.shape)) {
        const glm::dvec3 half = axes * glm::dvec3(0.0, static_cast<double>(cylinder->half_length), 0.0);
        const auto radius = static_cast<double>(cylinder->radius);
        pen.tube(body.position - half, body.position + half, radius, radius);
    } else if (!std::holds_alternative<Ground>(body.shape)) // one is as wide as the world
        pen.block(body.position, axes, glm::dvec3(detail::half_extent(body.shape)));
}

void draw_arrows(const WindControl& control, const WindReader& reader, const DebugDraw& settings, const DebugSink& sink) {
    const glm::dvec3 size(control.box().size()), origin = control.origin();
    const double longer = std::max(size.x, size.z);
    // No finer than 256 arrows a side.
    const double spacing =
        std::max(settings.spacing > 0.0f ? static_cast<double>(settings.spacing) : longer / 24.0, longer / 256.0);
    for (double x = 0.5 * spacing; x < size.x; x += spacing)
        for (double z = 0.5 * spacing; z < size.z; z += spacing) {
            const glm::dvec3 place = origin + glm::dvec3(x, std::clamp(static_cast<double>(settings.height), 0.0, size.y), z);
            const double length = spacing / static_cast<double>(settings.speed);
            Pen(sink, k_arrow).arrow(place, length * glm::dvec3(reader.velocity(place)));
        }
}

void draw_loads(const WindControl& control, const WindReader& reader, const DebugSink& sink) {
    constexpr double k_metres_a_newton = 0.02;
    std::uint32_t number = 0;
    for (const Obstacles::Slot& slot : control.obstacles().slots()) {
        const ObstacleId id{.slot = number++, .generation = slot.generation};
        if (!slot.used)
            continue;
        const auto load = reader.force_on(id);
        if (!load || !load->in_box || std::holds_alternative<Ground>(slot.obstacle.shape))
            continue;
        Pen(sink, k_load).arrow(slot.obstacle.position, k_metres_a_newton * glm::dvec3(load->force));
        if (sink.text)
            sink.text(slot.obstacle.position, detail::message(std::round(glm::length(load->force)), " N"), k_load);
    }
}

} // namespace

void debug_draw(const Motor& motor, std::uint32_t colour, const DebugSink& sink) {
    if (!sink.line)
        return;
    const Pen pen(sink, colour);
    const glm::dvec3 place = position_of(motor);
    if (const auto* const push = std::get_if<DirectionalMotor>(&motor)) {
        draw_region(pen, place, push->region);
        pen.arrow(place, 2.0 * unit(push->direction));
    } else if (const auto* const jet = std::get_if<JetMotor>(&motor)) {
        const glm::dvec3 end = place + static_cast<double>(jet->length) * unit(jet->direction);
        pen.tube(place, end, static_cast<double>(jet->start_radius), static_cast<double>(jet->end_radius));
        pen.arrow(place, 0.5 * (end - place));
    } else if (const auto* const vortex = std::get_if<VortexMotor>(&motor)) {
        const glm::dvec3 half = static_cast<double>(vortex->half_length) * unit(vortex->axis);
        pen.tube(place - half, place + half, static_cast<double>(vortex->radius), static_cast<double>(vortex->radius));
        pen.arrow(place - half, 2.0 * half);
    } else if (const auto* const wake = std::get_if<WakeMotor>(&motor))
        pen.ball(place, static_cast<double>(wake->radius));
    else if (const auto* const ball = std::get_if<OmniMotor>(&motor))
        pen.ball(place, static_cast<double>(ball->radius));
    else if (const auto* const burst = std::get_if<PressureMotor>(&motor))
        pen.ball(place, static_cast<double>(burst->radius));
}

void debug_draw(const Obstacle& obstacle, std::uint32_t colour, const DebugSink& sink) {
    if (sink.line)
        draw_shape(Pen(sink, colour), obstacle);
}

void debug_draw(const WindControl& control, const WindReader& reader, const DebugDraw& settings, const DebugSink& sink) {
    const glm::dvec3 half = 0.5 * glm::dvec3(control.box().size()), middle = control.origin() + half;
    if (!sink.line)
        return;
    if (settings.box)
        Pen(sink, reader.diagnostics().asleep ? k_asleep : k_box).block(middle, glm::dmat3(1.0), half);
    if (settings.blend_zone) {
        const WindowBlock block = reader.window_block(control.origin());
        glm::dvec3 inner = half, at = middle;
        for (int axis = 0; axis < 3; ++axis)
            if (block.blend_reach[axis] > 0.0f) {
                inner[axis] = std::max(0.0, static_cast<double>(block.blend_reach[axis] - block.blend_width));
                at[axis] = control.origin()[axis] + static_cast<double>(block.blend_centre[axis]);
            }
        Pen(sink, k_zone).block(at, glm::dmat3(1.0), inner);
    }
    if (settings.motors)
        for (const Motors::Slot& slot : control.motors().slots())
            if (slot.used)
                debug_draw(slot.motor, k_motor, sink);
    if (settings.obstacles)
        for (const Obstacles::Slot& slot : control.obstacles().slots())
            if (slot.used)
                debug_draw(slot.obstacle, k_obstacle, sink);
    if (settings.loads)
        draw_loads(control, reader, sink);
    if (settings.arrows)
        draw_arrows(control, reader, settings, sink);
}

} // namespace windrow
