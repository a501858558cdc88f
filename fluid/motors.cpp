#include "fluid/motors.h"

#include "fluid/core/message.h"
#include "fluid/event_log.h"
#include "fluid/gust_tile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <new>

namespace windrow {
namespace {

// In double, so that the longest and the shortest float vector keep their direction.
void normalise(glm::vec3& direction) {
    direction = glm::vec3(glm::normalize(glm::dvec3(direction)));
}

Motor prepared(Motor motor) {
    if (auto* directional = std::get_if<DirectionalMotor>(&motor))
        normalise(directional->direction);
    else if (auto* jet = std::get_if<JetMotor>(&motor))
        normalise(jet->direction);
    else if (auto* vortex = std::get_if<VortexMotor>(&motor))
        normalise(vortex->axis);
    return motor;
}

double end_of(const Motor& motor) {
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.envelope; })
                return kind.envelope.end();
            else
                return kind.end();
        },
        motor);
}

bool stirs(const Motor& motor) {
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.turbulence; })
                return kind.turbulence.intensity > 0.0f;
            else
                return false;
        },
        motor);
}

} // namespace

Motors::Motors() : list_({"motor", "removed, ended, or never added"}, k_capacity) {}

Result<MotorId> Motors::add(const Motor& motor) {
    if (auto valid = validate(motor); !valid)
        return valid.failure();
    if (auto room = list_.check_room(); !room)
        return room.failure();
    const bool has_room = detail::memory_lasts([&] {
        list_.make_room();
        reserve_reach(&motor);
    });
    if (!has_room)
        return detail::out_of_memory();
    const MotorId id = list_.add();
    start(list_[id.slot], motor);
    if (log_ != nullptr)
        log_->note(MotorAdded{id.unowned(), motor});
    return id;
}

void Motors::start(Slot& slot, const Motor& motor) {
    slot.motor = prepared(motor);
    slot.track = Track(position_of(motor));
    slot.age = 0.0;
}

Result<void> Motors::set(MotorId id, const Motor& motor) {
    const auto found = list_.find(id);
    if (!found)
        return found.failure();
    if (auto valid = validate(motor); !valid)
        return valid;
    if (!detail::memory_lasts([&] { reserve_reach(&motor); }))
        return detail::out_of_memory();
    start(**found, motor);
    if (log_ != nullptr)
        log_->note(MotorSet{id.unowned(), motor});
    return {};
}

Result<void> Motors::move(MotorId id, glm::dvec3 position) {
    const auto found = list_.find(id);
    if (!found)
        return found.failure();
    Slot* const slot = *found;
    if (auto valid = detail::validate_motor_position(position); !valid)
        return valid;
    std::visit([&](auto& kind) { kind.position = position; }, slot->motor);
    slot->track.move_to(position);
    if (log_ != nullptr)
        log_->note(MotorMoved{id.unowned(), position});
    return {};
}

Result<void> Motors::remove(MotorId id) {
    if (const auto found = list_.find(id); !found)
        return found.failure();
    list_.release(id.slot);
    if (log_ != nullptr)
        log_->note(MotorRemoved{id.unowned()});
    return {};
}

// Called before a motor is added or changes kind, so that a step does not allocate: a wake may reach the box with several
// segments of its path.
void Motors::reserve_reach(const Motor* more) {
    std::size_t most = 0;
    const auto count = [&](const Motor& motor) {
        if (!tile_ && stirs(motor) && !(tile_ = GustTile::standard()))
            throw std::bad_alloc();
        most += std::holds_alternative<WakeMotor>(motor) ? std::size_t{Track::k_max_segments} : 1;
    };
    for (const Slot& slot : slots())
        if (slot.used)
            count(slot.motor);
    if (more != nullptr)
        count(*more);
    if (reach_.size() < most)
        reach_.resize(most + most / 2);
}

bool Motors::has_volume_source() const {
    return std::any_of(slots().begin(), slots().end(), [](const Slot& slot) {
        return slot.used && (std::holds_alternative<OmniMotor>(slot.motor) || std::holds_alternative<PressureMotor>(slot.motor));
    });
}

const Motor* Motors::find(MotorId id) const {
    const auto slot = list_.find(id);
    return slot ? &(*slot)->motor : nullptr;
}

void Motors::begin_frame(double lead, double duration) {
    for (Slot& slot : list_.slots())
        if (slot.used)
            slot.track.begin_frame(lead, duration);
}

void Motors::squeeze(double factor) {
    for (Slot& slot : list_.slots())
        if (slot.used)
            slot.track.squeeze(factor);
}

std::span<const detail::MotorReach> Motors::tick(double duration, const Window& window, const Boundaries& boundaries,
                                                 float jump_speed) {
    std::size_t count = 0;
    jumps_ = 0;
    std::array<Track::Segment, Track::k_max_segments> walked;
    for (std::uint32_t index = 0; index < list_.size(); ++index) {
        Slot& slot = list_[index];
        if (!slot.used)
            continue;
        std::span<const Track::Segment> path = slot.track.tick(duration);
        if (std::holds_alternative<WakeMotor>(slot.motor)) { // no other motor sweeps its way
            const auto end = std::copy_if(path.begin(), path.end(), walked.begin(), [&](const Track::Segment& piece) {
                return !detail::is_jump(piece.end - piece.start, piece.duration, jump_speed);
            });
            const auto kept = static_cast<std::size_t>(end - walked.begin());
            jumps_ += kept < path.size() ? 1 : 0;
            path = std::span(walked).first(kept);
        }
        const auto reaching = static_cast<std::size_t>(detail::prepare(slot.motor, slot.track, path, slot.age, duration, window,
                                                                       boundaries, std::span(reach_).subspan(count)));
        slot.reaches = reaching > 0;
        count += reaching;
        slot.age += duration;
        if (slot.age >= end_of(slot.motor))
            list_.release(index); // room is made
    }
    const std::span<detail::MotorReach> reached = std::span(reach_).first(count);
    std::sort(reached.begin(), reached.end(), detail::before);
    return reached;
}

void Motors::shift_origin(glm::dvec3 offset) {
    for (Slot& slot : list_.slots()) {
        std::visit([&](auto& kind) { kind.position += offset; }, slot.motor);
        slot.track.shift(offset);
    }
}

int Motors::lost(const Window& window, const Boundaries& boundaries, glm::bvec3 follows) const {
    const glm::dvec3 low = window.origin(), size = window.size();
    return static_cast<int>(std::count_if(slots().begin(), slots().end(), [&](const Slot& slot) {
        if (!slot.used || slot.reaches)
            return false;
        const glm::dvec3 from_low = position_of(slot.motor) - low;
        bool lost = boundaries.y_low.solid() && from_low.y < 0.0;
        for (int axis = 0; axis < 3; ++axis)
            lost = lost || (!follows[axis] && !boundaries.periodic(axis) &&
                            std::abs(from_low[axis] - 0.5 * size[axis]) > 1.5 * size[axis]);
        return lost;
    }));
}

std::size_t Motors::memory_bytes() const {
    return list_.memory_bytes() + reach_.capacity() * sizeof(detail::MotorReach) + (tile_ ? tile_->memory_bytes() : 0);
}

} // namespace windrow
