// Boundary conditions of the six faces of the box.
//
// With u the velocity, n the face's normal and p the pressure, the ghost cells beyond a face hold
//   open       the ambient wind: every read beyond it returns ambient, and p = 0 at the ghost's centre (the divergence sees the
//              cell itself there, so that air passes through);
//   free_slip  a wall without friction: u.n mirrored with its sign turned, the rest mirrored, dp/dn = 0;
//   no_slip    a wall that drags the air: for viscosity, u mirrored about the wall's velocity, dp/dn = 0. Advection slips along
//              it as along free_slip, so without viscosity the wall's velocity has no effect. With gusts, viscosity acts on the
//              perturbation of the motors only: gusts slip along every wall.
//   periodic   the cells at the opposite face.
// Mirrored ghosts put the wall on the face, half a cell beyond the last centre: second order.
#pragma once

#include "api.h"
#include "result.h"
#include "setting.h"

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <tuple>

namespace windrow {

enum class BoundaryKind : std::uint8_t { open, free_slip, no_slip, periodic };
template <>
inline constexpr std::array<const char*, 4> k_words<BoundaryKind>{"open", "free_slip", "no_slip", "periodic"};

/// Boundary condition of one face of the box.
struct Boundary {
    /// Default open. open: the ambient wind is beyond. free_slip: a wall without friction. no_slip: a wall that drags the air.
    /// periodic: the opposite face is beyond.
    BoundaryKind kind = BoundaryKind::open;
    /// [m/s] Each component -10000 to 10000, default (0, 0, 0). Velocity of a no-slip wall, in its own plane; 0 on every other
    /// kind. May change in every step.
    glm::vec3 wall_velocity{0.0f};

    static constexpr auto settings() {
        return std::tuple{
            Setting("kind", &Boundary::kind,
                    "open: the ambient wind is beyond. free_slip: a wall without friction. no_slip: a wall that drags the air. "
                    "periodic: the opposite face is beyond."),
            Setting("wall_velocity", &Boundary::wall_velocity, k_speed_range,
                    "Velocity of a no-slip wall, in its own plane; 0 on every other kind. May change in every step."),
        };
    }

    [[nodiscard]] bool solid() const { return kind == BoundaryKind::free_slip || kind == BoundaryKind::no_slip; }
    friend bool operator==(const Boundary&, const Boundary&) = default;
};

/// The six boundaries in the order x low, x high, y low, y high, z low, z high. Any mix per face; periodic boundaries come in
/// pairs.
struct WINDROW_API Boundaries {
    /// At the low end of x.
    Boundary x_low{};
    /// At its high end.
    Boundary x_high{};
    /// Below: the floor.
    Boundary y_low{};
    /// Above.
    Boundary y_high{};
    /// At the low end of z.
    Boundary z_low{};
    /// At its high end.
    Boundary z_high{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("x_low", &Boundaries::x_low, "At the low end of x."),
            Setting("x_high", &Boundaries::x_high, "At its high end."),
            Setting("y_low", &Boundaries::y_low, "Below: the floor."),
            Setting("y_high", &Boundaries::y_high, "Above."),
            Setting("z_low", &Boundaries::z_low, "At the low end of z."),
            Setting("z_high", &Boundaries::z_high, "At its high end."),
        };
    }

    /// end 0 is the low boundary, 1 the high one.
    [[nodiscard]] const Boundary& at(int axis, int end) const;
    [[nodiscard]] bool periodic(int axis) const { return at(axis, 0).kind == BoundaryKind::periodic; }
    [[nodiscard]] bool has_solid(int axis) const { return at(axis, 0).solid() || at(axis, 1).solid(); }
    [[nodiscard]] bool has_open(int axis) const;
    /// Every axis has an open boundary: the box is in free air, with at most one wall per axis.
    [[nodiscard]] bool in_free_air() const { return has_open(0) && has_open(1) && has_open(2); }

    static Boundaries all(BoundaryKind kind);
    /// Open air over a free-slip floor.
    static Boundaries open_over_floor();

    friend bool operator==(const Boundaries&, const Boundaries&) = default;
};

/// Rejects a periodic boundary opposite to another kind, and wall velocities that are not finite, have a normal component or
/// belong to another kind.
[[nodiscard]] WINDROW_API Result<void> validate(const Boundaries& boundaries);
namespace detail {
class Reasons;
struct FieldPath;
} // namespace detail
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Boundaries& boundaries);

/// `ambient` without its components along axes that a wall closes: the wind that the open boundaries of such a box can carry.
[[nodiscard]] WINDROW_API glm::vec3 admissible_ambient(const Boundaries& boundaries, glm::vec3 ambient);

} // namespace windrow
