#include "fluid/sides.h"

#include "fluid/message.h"

#include <cmath>

namespace windrow {
namespace {

constexpr const char* k_side_names[3][2] = {
    {"sides.x_low", "sides.x_high"}, {"sides.y_low", "sides.y_high"}, {"sides.z_low", "sides.z_high"}};

constexpr float k_most_wall_speed = 1e4f; // as of the ambient wind

bool usable(glm::vec3 v) {
    return std::abs(v.x) <= k_most_wall_speed && std::abs(v.y) <= k_most_wall_speed && std::abs(v.z) <= k_most_wall_speed;
}

} // namespace

const Side& Sides::at(int axis, int end) const {
    const Side* const ordered[6] = {&x_low, &x_high, &y_low, &y_high, &z_low, &z_high};
    return *ordered[2 * axis + end];
}

bool Sides::has_open(int axis) const {
    return at(axis, 0).kind == SideKind::open || at(axis, 1).kind == SideKind::open;
}

Sides Sides::all(SideKind kind) {
    const Side side{.kind = kind};
    return {side, side, side, side, side, side};
}

Sides Sides::open_over_floor() {
    Sides sides;
    sides.y_low.kind = SideKind::free_slip;
    return sides;
}

Result<void> validate(const Sides& sides) {
    detail::Reasons reasons;
    for (int axis = 0; axis < 3; ++axis) {
        const bool low = sides.at(axis, 0).kind == SideKind::periodic;
        const bool high = sides.at(axis, 1).kind == SideKind::periodic;
        if (low != high)
            reasons.add(k_side_names[axis][low ? 1 : 0],
                        " is not periodic but its partner is: make both sides of the axis periodic, or neither.");
        for (int end = 0; end < 2; ++end) {
            const Side& side = sides.at(axis, end);
            const char* const name = k_side_names[axis][end];
            if (side.kind > SideKind::periodic)
                reasons.add(name, ".kind is ", static_cast<int>(side.kind), ": give open, free_slip, no_slip or periodic.");
            if (!usable(side.wall_velocity))
                reasons.add(name, ".wall_velocity is ", side.wall_velocity,
                            " m/s: give finite numbers, at most 1e4 m/s in size.");
            else if (side.kind != SideKind::no_slip && side.wall_velocity != glm::vec3(0.0f))
                reasons.add(name, ".wall_velocity is ", side.wall_velocity,
                            " m/s but only a no-slip wall drags the air: make the side no_slip or the velocity 0.");
            else if (side.wall_velocity[axis] != 0.0f)
                reasons.add(name, ".wall_velocity is ", side.wall_velocity,
                            " m/s and leaves the wall's plane: set its component along the normal to 0.");
        }
    }
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

glm::vec3 admissible_ambient(const Sides& sides, glm::vec3 ambient) {
    for (int axis = 0; axis < 3; ++axis)
        if (sides.has_solid(axis))
            ambient[axis] = 0.0f;
    return ambient;
}

} // namespace windrow
