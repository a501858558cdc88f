#include "fluid/boundaries.h"

#include "fluid/core/validation.h"

namespace windrow {
namespace {

constexpr const char* k_side_names[3][2] = {{"x_low", "x_high"}, {"y_low", "y_high"}, {"z_low", "z_high"}};

} // namespace

const Boundary& Boundaries::at(int axis, int end) const {
    const Boundary* const ordered[6] = {&x_low, &x_high, &y_low, &y_high, &z_low, &z_high};
    return *ordered[2 * axis + end];
}

bool Boundaries::has_open(int axis) const {
    return at(axis, 0).kind == BoundaryKind::open || at(axis, 1).kind == BoundaryKind::open;
}

Boundaries Boundaries::all(BoundaryKind kind) {
    const Boundary side{.kind = kind};
    return {side, side, side, side, side, side};
}

Boundaries Boundaries::open_over_floor() {
    Boundaries boundaries;
    boundaries.y_low.kind = BoundaryKind::free_slip;
    return boundaries;
}

Result<void> validate(const Boundaries& boundaries) {
    return detail::validate_settings(boundaries, "boundaries");
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Boundaries& boundaries) {
    for (int axis = 0; axis < 3; ++axis) {
        const bool low = boundaries.at(axis, 0).kind == BoundaryKind::periodic;
        const bool high = boundaries.at(axis, 1).kind == BoundaryKind::periodic;
        if (low != high)
            reasons.add(detail::FieldPath{&path, k_side_names[axis][low ? 1 : 0]},
                        " is not periodic, but the opposite boundary is: make both boundaries of the axis periodic, or neither.");
        for (int end = 0; end < 2; ++end) {
            const Boundary& side = boundaries.at(axis, end);
            const detail::FieldPath name{&path, k_side_names[axis][end]}, velocity{&name, "wall_velocity"};
            if (!detail::holds(k_speed_range, side.wall_velocity))
                continue;
            if (side.kind != BoundaryKind::no_slip && side.wall_velocity != glm::vec3(0.0f))
                reasons.add(velocity, " is ", side.wall_velocity,
                            " m/s, but only a no_slip wall may move: set the kind to no_slip or the velocity to 0.");
            else if (side.wall_velocity[axis] != 0.0f)
                reasons.add(velocity, " is ", side.wall_velocity,
                            " m/s, with a component normal to the wall: set that component to 0.");
        }
    }
}

glm::vec3 admissible_ambient(const Boundaries& boundaries, glm::vec3 ambient) {
    for (int axis = 0; axis < 3; ++axis)
        if (boundaries.has_solid(axis))
            ambient[axis] = 0.0f;
    return ambient;
}

} // namespace windrow
