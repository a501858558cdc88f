#include "fluid/sides.h"

#include "fluid/validation.h"

namespace windrow {
namespace {

constexpr const char* k_side_names[3][2] = {{"x_low", "x_high"}, {"y_low", "y_high"}, {"z_low", "z_high"}};

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
    return detail::validate_settings(sides, "sides");
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Sides& sides) {
    for (int axis = 0; axis < 3; ++axis) {
        const bool low = sides.at(axis, 0).kind == SideKind::periodic;
        const bool high = sides.at(axis, 1).kind == SideKind::periodic;
        if (low != high)
            reasons.add(detail::FieldPath{&path, k_side_names[axis][low ? 1 : 0]},
                        " is not periodic but its partner is: make both sides of the axis periodic, or neither.");
        for (int end = 0; end < 2; ++end) {
            const Side& side = sides.at(axis, end);
            const detail::FieldPath name{&path, k_side_names[axis][end]}, velocity{&name, "wall_velocity"};
            if (!detail::holds(k_speed_range, side.wall_velocity))
                continue;
            if (side.kind != SideKind::no_slip && side.wall_velocity != glm::vec3(0.0f))
                reasons.add(velocity, " is ", side.wall_velocity,
                            " m/s but only a no-slip wall drags the air: make the side no_slip or the velocity 0.");
            else if (side.wall_velocity[axis] != 0.0f)
                reasons.add(velocity, " is ", side.wall_velocity,
                            " m/s and leaves the wall's plane: set its component along the normal to 0.");
        }
    }
}

glm::vec3 admissible_ambient(const Sides& sides, glm::vec3 ambient) {
    for (int axis = 0; axis < 3; ++axis)
        if (sides.has_solid(axis))
            ambient[axis] = 0.0f;
    return ambient;
}

} // namespace windrow
