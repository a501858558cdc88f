#include "fluid/motors.h"

#include "fluid/message.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <string_view>

namespace windrow {
namespace {

constexpr double k_farthest = 1e12;    // [m] beyond it a double no longer tells millimetres apart
constexpr float k_most_acceleration = 1e6f;
constexpr float k_most_speed = 1e4f;
constexpr float k_most_rate = 1e6f;
constexpr float k_most_wake = 1e4f;
constexpr float k_most_size = 1e6f;

template <class Vector>
bool finite(const Vector& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Refuses NaN too, which fails every comparison.
void require(detail::Reasons& reasons, bool valid, std::string_view field, float value, std::string_view fix) {
    if (!valid)
        reasons.add(field, " is ", value, ": ", fix);
}

void check_position(detail::Reasons& reasons, const glm::dvec3& position) {
    if (!finite(position) || glm::length(position) > k_farthest)
        reasons.add("motor.position is ", position, " m: give finite numbers within 1e12 m of the origin.");
}

void check_radius(detail::Reasons& reasons, std::string_view field, float radius) {
    require(reasons, radius > 0.0f && radius <= k_most_size, field, radius, "give a radius above 0 m, at most 1e6 m.");
}

struct RegionCheck {
    detail::Reasons& reasons;
    void operator()(const Sphere& sphere) const { check_radius(reasons, "motor.region.sphere.radius", sphere.radius); }
    void operator()(const Capsule& capsule) const {
        check_radius(reasons, "motor.region.capsule.radius", capsule.radius);
        if (!finite(capsule.half_axis) || glm::length(capsule.half_axis) > k_most_size)
            reasons.add("motor.region.capsule.half_axis is ", capsule.half_axis, " m: give finite numbers, at most 1e6 m long.");
    }
    void operator()(const AlignedBox& box) const {
        for (int axis = 0; axis < 3; ++axis)
            if (!(box.half_size[axis] > 0.0f && box.half_size[axis] <= k_most_size)) {
                reasons.add("motor.region.box.half_size is ", box.half_size, " m: give each axis above 0 m, at most 1e6 m.");
                return;
            }
    }
};

struct LawCheck {
    detail::Reasons& reasons;
    void operator()(const Force& law) const {
        require(reasons, std::abs(law.acceleration) <= k_most_acceleration, "motor.law.force.acceleration", law.acceleration,
                "give at most 1e6 m/s2 in size.");
    }
    void operator()(const Drive& law) const {
        require(reasons, std::abs(law.speed) <= k_most_speed, "motor.law.drive.speed", law.speed, "give at most 1e4 m/s in size.");
        require(reasons, law.rate >= 0.0f && law.rate <= k_most_rate, "motor.law.drive.rate", law.rate, "give 0 to 1e6 per second.");
    }
    void operator()(const WakeForce& law) const {
        require(reasons, law.strength >= 0.0f && law.strength <= k_most_wake, "motor.law.force.strength", law.strength,
                "give 0 to 1e4 per second.");
    }
    void operator()(const WakeDrive& law) const {
        require(reasons, law.per_metre >= 0.0f && law.per_metre <= k_most_wake, "motor.law.drive.per_metre", law.per_metre,
                "give 0 to 1e4 per metre.");
        require(reasons, law.entrainment >= 0.0f && law.entrainment <= 2.0f, "motor.law.drive.entrainment", law.entrainment, "give 0 to 2.");
    }
};

struct MotorCheck {
    detail::Reasons& reasons;
    void operator()(const DirectionalMotor& motor) const {
        check_position(reasons, motor.position);
        if (!finite(motor.direction) || motor.direction == glm::vec3(0.0f))
            reasons.add("motor.direction is ", motor.direction, ": give a finite vector that is not 0.");
        std::visit(RegionCheck{reasons}, motor.region);
        std::visit(LawCheck{reasons}, motor.law);
    }
    void operator()(const WakeMotor& motor) const {
        check_position(reasons, motor.position);
        check_radius(reasons, "motor.radius", motor.radius);
        std::visit(LawCheck{reasons}, motor.law);
    }
};

// In double, so that the direction of the longest and of the shortest float vector survives.
glm::vec3 normalised(glm::vec3 direction) { return glm::vec3(glm::normalize(glm::dvec3(direction))); }

Motor prepared(Motor motor) {
    if (auto* directional = std::get_if<DirectionalMotor>(&motor))
        directional->direction = normalised(directional->direction);
    return motor;
}

glm::dvec3 position_of(const Motor& motor) {
    return std::visit([](const auto& kind) { return kind.position; }, motor);
}

Error stale(MotorId id) {
    return Error{detail::message("motor ", id.slot, " of generation ", id.generation,
                                 " does not exist (removed, or never added): use the handle that add() returned.")};
}

} // namespace

Result<void> validate(const Motor& motor) {
    detail::Reasons reasons;
    std::visit(MotorCheck{reasons}, motor);
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

Result<MotorId> Motors::add(const Motor& motor) {
    if (auto valid = validate(motor); !valid)
        return Error{valid.error()};
    if (free_.empty() && slots_.size() >= k_capacity)
        return Error{detail::message("motors is full with ", count_, " motors: remove some; the list takes ", k_capacity, ".")};
    std::uint32_t index = 0;
    if (!free_.empty()) {
        index = free_.back();
        free_.pop_back();
    } else {
        index = static_cast<std::uint32_t>(slots_.size());
        slots_.emplace_back();
        reach_.emplace_back();
    }
    Slot& slot = slots_[index];
    slot.motor = prepared(motor);
    slot.path_start = position_of(motor);
    slot.used = true;
    ++slot.generation;
    ++count_;
    return MotorId{index, slot.generation};
}

Motors::Slot* Motors::slot_of(MotorId id) {
    if (id.slot >= slots_.size() || !slots_[id.slot].used || slots_[id.slot].generation != id.generation)
        return nullptr;
    return &slots_[id.slot];
}

Result<void> Motors::set(MotorId id, const Motor& motor) {
    Slot* const slot = slot_of(id);
    if (slot == nullptr)
        return stale(id);
    if (auto valid = validate(motor); !valid)
        return valid;
    slot->motor = prepared(motor);
    slot->path_start = position_of(motor);
    return {};
}

Result<void> Motors::move(MotorId id, glm::dvec3 position) {
    Slot* const slot = slot_of(id);
    if (slot == nullptr)
        return stale(id);
    detail::Reasons reasons;
    check_position(reasons, position);
    if (!reasons.empty())
        return Error{reasons.take()};
    std::visit([&](auto& kind) { kind.position = position; }, slot->motor);
    return {};
}

Result<void> Motors::remove(MotorId id) {
    Slot* const slot = slot_of(id);
    if (slot == nullptr)
        return stale(id);
    slot->used = false;
    free_.push_back(id.slot);
    --count_;
    return {};
}

const Motor* Motors::find(MotorId id) const {
    const Slot* const slot = const_cast<Motors*>(this)->slot_of(id);
    return slot != nullptr ? &slot->motor : nullptr;
}

void Motors::finish_paths() {
    for (Slot& slot : slots_)
        if (slot.used)
            slot.path_start = position_of(slot.motor);
}

std::size_t Motors::memory_bytes() const {
    return slots_.capacity() * sizeof(Slot) + reach_.capacity() * sizeof(detail::MotorReach) + free_.capacity() * sizeof(std::uint32_t);
}

} // namespace windrow
