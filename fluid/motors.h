// Motors push the air: fans, gusts, bodies that pass.
//
// A motor lives in world space (double), is created, moved, changed and removed while the wind runs, and is named by a
// handle with a generation, so that a stale handle is refused instead of moving a stranger. A motor acts by one of two laws:
//   a force    adds an acceleration w(x) f,
//   a drive    pulls the air toward a velocity U: du = (1 - exp(-k w dt)) (U - u), stable for any strength and step,
// with the weight w(x) of its region: 1 at the centre, falling as (1 - s^2)^2 to exactly 0 at the rim (s = distance over
// radius), smooth there. The formulas stand in shaders/numerics/motors.glsl, one text for C++ and GLSL.
// A region thinner than 1.5 cells in radius would fall between the cells; it is widened to that and weakened so that its impulse stays.
#pragma once

#include "fluid/motor_reach.h"
#include "fluid/result.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace windrow {

// --- Regions ---------------------------------------------------------------------------------------------------------

/// Ball: w = (1 - d^2/radius^2)^2.
struct Sphere {
    float radius = 2.0f; ///< [m] > 0
};

/// All points within `radius` of the segment centre - half_axis .. centre + half_axis; d is the distance to the segment.
struct Capsule {
    glm::vec3 half_axis{2.0f, 0.0f, 0.0f}; ///< [m] any finite vector; 0 makes a sphere
    float radius = 1.0f;                   ///< [m] > 0
};

/// Axis-aligned box: w = product over the axes of (1 - d^2/half_size^2)^2.
struct AlignedBox {
    glm::vec3 half_size{2.0f}; ///< [m] each > 0
};

using Region = std::variant<Sphere, Capsule, AlignedBox>;

// --- Laws ------------------------------------------------------------------------------------------------------------

/// A constant acceleration along the motor's direction.
struct Force {
    float acceleration = 10.0f; ///< [m/s^2] any sign, at most 1e6 in size
};

/// Pulls the air toward a speed along the motor's direction.
struct Drive {
    float speed = 8.0f; ///< [m/s] any sign, at most 1e4 in size
    float rate = 4.0f;  ///< [1/s] how fast: 63 % of the way in 1/rate seconds at the centre; 0 to 1e6
};

/// A wake that pushes: along its path it adds `strength * w` metres per second for each metre that the body passes, so the
/// impulse per metre is fixed and the impulse per second grows in proportion to the speed.
struct WakeForce {
    float strength = 1.0f; ///< [1/s] 0 to 1e4
};

/// A wake that drags: the air is pulled toward `entrainment` times the body's velocity; the exponent is the path integral of
/// `per_metre * w`, so cutting the path into steps changes nothing.
struct WakeDrive {
    float per_metre = 0.5f;   ///< [1/m] 0 to 1e4
    float entrainment = 1.0f; ///< share of the body's velocity, 0 to 2
};

// --- Motors ----------------------------------------------------------------------------------------------------------

/// A fan, a gust, a draught: pushes along one direction within a region.
struct DirectionalMotor {
    glm::dvec3 position{0.0};               ///< [m] world; centre of the region
    glm::vec3 direction{1.0f, 0.0f, 0.0f};  ///< any length but 0; normalised on creation
    Region region = Sphere{};
    std::variant<Force, Drive> law = Drive{};
};

/// A moving body: acts only while it moves, along the path from where the last step left it to where `Motors::move` put it.
struct WakeMotor {
    glm::dvec3 position{0.0}; ///< [m] world; where the path begins
    float radius = 0.5f;      ///< [m] > 0
    std::variant<WakeForce, WakeDrive> law = WakeDrive{};
};

using Motor = std::variant<DirectionalMotor, WakeMotor>;

/// Every reason why a motor cannot be used, a line each.
[[nodiscard]] Result<void> validate(const Motor& motor);

/// Names a motor of one Motors object. A default one names none.
struct MotorId {
    std::uint32_t slot = 0;
    std::uint32_t generation = 0; ///< 0 names no motor
    friend bool operator==(MotorId, MotorId) = default;
};

/// The motors of one Wind, at most 4096.
class Motors {
  public:
    static constexpr std::uint32_t k_capacity = 4096;

    /// Adds a motor; refuses what `validate` refuses and a full list.
    [[nodiscard]] Result<MotorId> add(const Motor& motor);
    /// Replaces a motor whole, its position too; a wake starts a new path there and sweeps nothing in between. The kind may change.
    [[nodiscard]] Result<void> set(MotorId id, const Motor& motor);
    /// Moves a motor. A wake sweeps the straight path from where the last step left it.
    [[nodiscard]] Result<void> move(MotorId id, glm::dvec3 position);
    /// Removes a motor; a stale handle is refused.
    Result<void> remove(MotorId id);

    /// The motor as it stands, direction normalised; null for a stale handle.
    [[nodiscard]] const Motor* find(MotorId id) const;
    [[nodiscard]] int count() const { return count_; }

    /// One slot of the list, as the sources stage reads it.
    struct Slot {
        Motor motor;
        glm::dvec3 path_start{0.0}; ///< where the last step left a wake
        std::uint32_t generation = 0;
        bool used = false;
    };
    [[nodiscard]] std::span<const Slot> slots() const { return slots_; }
    /// Called by the step: every wake's path now begins where it stands.
    void finish_paths();
    /// Room for one MotorReach a slot, so that a step allocates nothing.
    [[nodiscard]] std::span<detail::MotorReach> reach() { return reach_; }
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    [[nodiscard]] Slot* slot_of(MotorId id);

    std::vector<Slot> slots_;
    std::vector<detail::MotorReach> reach_;
    std::vector<std::uint32_t> free_;
    int count_ = 0;
};

} // namespace windrow
