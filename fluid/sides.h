// The six sides of the box: what the air meets there.
//
// With u the velocity, n the side's normal and p the pressure, beyond a side lies
//   open       the ambient wind: every read beyond it returns ambient, and p = 0 at the ghost's centre (the divergence sees the
//              cell itself there, so that air passes through);
//   free_slip  a wall that holds no air back: u.n mirrored with its sign turned, the rest mirrored, dp/dn = 0;
//   no_slip    a wall that carries the air along: for viscosity u mirrored about the wall's velocity, dp/dn = 0; transport slips
//              along it as along free_slip, so that where viscosity acts on nothing neither does the wall's velocity
//              (while gusts blow, of the air that motors move alone: gusts slip along every wall)
//   periodic   the far side of the box.
// Mirrored ghosts put the wall on the face, half a cell beyond the last centre: second order.
#pragma once

#include "fluid/result.h"

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace windrow {

enum class SideKind : std::uint8_t { open, free_slip, no_slip, periodic };

/// One side of the box.
struct Side {
    /// Default open: a window around a player lies in free air.
    SideKind kind = SideKind::open;
    /// [m/s] Velocity of a no-slip wall, in the wall's own plane: a component along its normal is refused, and so is any
    /// velocity on another kind, where it would do nothing. May change in every step.
    glm::vec3 wall_velocity{0.0f};

    [[nodiscard]] bool solid() const { return kind == SideKind::free_slip || kind == SideKind::no_slip; }
    friend bool operator==(const Side&, const Side&) = default;
};

/// The six sides in the order x low, x high, y low, y high, z low, z high. Any mix per face; periodic sides come in pairs.
struct Sides {
    Side x_low{}, x_high{}, y_low{}, y_high{}, z_low{}, z_high{};

    /// end 0 is the low side, 1 the high side.
    [[nodiscard]] const Side& at(int axis, int end) const;
    [[nodiscard]] bool periodic(int axis) const { return at(axis, 0).kind == SideKind::periodic; }
    [[nodiscard]] bool has_solid(int axis) const { return at(axis, 0).solid() || at(axis, 1).solid(); }
    [[nodiscard]] bool has_open(int axis) const;
    /// Every axis is open at one end at least: free air lies around the box, with a wall an axis at most.
    [[nodiscard]] bool in_free_air() const { return has_open(0) && has_open(1) && has_open(2); }

    static Sides all(SideKind kind);
    /// Open air over a free-slip floor.
    static Sides open_over_floor();

    friend bool operator==(const Sides&, const Sides&) = default;
};

/// Refuses periodic sides without their partner and wall velocities that are not finite, leave the wall or lie on a wrong kind.
[[nodiscard]] Result<void> validate(const Sides& sides);

/// `ambient` without its components along axes that a wall closes: the wind that the open sides of such a box can carry.
[[nodiscard]] glm::vec3 admissible_ambient(const Sides& sides, glm::vec3 ambient);

} // namespace windrow
