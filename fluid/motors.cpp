#include "fluid/motors.h"

#include "fluid/event_log.h"
#include "fluid/gust_tile.h"
#include "fluid/message.h"
#include "fluid/owner.h"

#include <algorithm>
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

// Form of an id in a log: valid for any wind that starts from the same snapshot.
MotorId unowned(MotorId id) {
    return {.slot = id.slot, .generation = id.generation};
}

} // namespace

Motors::Motors() : owner_(detail::next_owner()) {}

Result<MotorId> Motors::add(const Motor& motor) {
    if (auto valid = validate(motor); !valid)
        return Error{valid.error()};
    if (free_.empty() && slots_.size() >= k_capacity)
        return Error{detail::message("there are already ", count_, " motors: remove some; a wind has at most ", k_capacity, ".")};
    const bool has_room = detail::memory_lasts([&] {
        if (free_.empty() && slots_.size() == slots_.capacity())
            slots_.reserve(std::max<std::size_t>(1, 2 * slots_.capacity()));
        free_.reserve(slots_.capacity()); // a motor that ends in a step goes back there without allocating
        reserve_reach(&motor);
    });
    if (!has_room)
        return detail::out_of_memory();
    std::uint32_t index = 0;
    if (!free_.empty()) {
        index = free_.back();
        free_.pop_back();
    } else {
        index = static_cast<std::uint32_t>(slots_.size());
        slots_.emplace_back();
    }
    Slot& slot = slots_[index];
    slot.motor = prepared(motor);
    slot.track = Track(position_of(motor));
    slot.age = 0.0;
    slot.used = slot.named_here = true;
    ++slot.generation;
    ++count_;
    const MotorId id{index, slot.generation, owner_};
    if (log_ != nullptr)
        log_->note(MotorAdded{unowned(id), motor});
    return id;
}

Result<Motors::Slot*> Motors::slot_of(MotorId id) {
    Slot* const slot = id.slot < slots_.size() ? &slots_[id.slot] : nullptr;
    if (slot != nullptr && slot->used && slot->generation == id.generation) {
        if (id.owner == 0 || id.owner == owner_ || !slot->named_here)
            return slot;
        return Error{detail::message("motor ", id.slot, " of generation ", id.generation,
                                     " belongs to another wind: use the handle that add() of this one returned.")};
    }
    return Error{detail::message("motor ", id.slot, " of generation ", id.generation,
                                 " does not exist (removed, ended, or never added): use the handle that add() returned.")};
}

Result<void> Motors::set(MotorId id, const Motor& motor) {
    const auto found = slot_of(id);
    if (!found)
        return Error{found.error()};
    Slot* const slot = *found;
    if (auto valid = validate(motor); !valid)
        return valid;
    if (!detail::memory_lasts([&] { reserve_reach(&motor); }))
        return detail::out_of_memory();
    slot->motor = prepared(motor);
    slot->track = Track(position_of(motor));
    slot->age = 0.0;
    if (log_ != nullptr)
        log_->note(MotorSet{unowned(id), motor});
    return {};
}

Result<void> Motors::move(MotorId id, glm::dvec3 position) {
    const auto found = slot_of(id);
    if (!found)
        return Error{found.error()};
    Slot* const slot = *found;
    if (auto valid = detail::validate_motor_position(position); !valid)
        return valid;
    std::visit([&](auto& kind) { kind.position = position; }, slot->motor);
    slot->track.move_to(position);
    if (log_ != nullptr)
        log_->note(MotorMoved{unowned(id), position});
    return {};
}

Result<void> Motors::remove(MotorId id) {
    if (const auto found = slot_of(id); !found)
        return Error{found.error()};
    release(id.slot);
    if (log_ != nullptr)
        log_->note(MotorRemoved{unowned(id)});
    return {};
}

void Motors::release(std::uint32_t index) {
    slots_[index].used = false;
    free_.push_back(index);
    --count_;
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
    for (const Slot& slot : slots_)
        if (slot.used)
            count(slot.motor);
    if (more != nullptr)
        count(*more);
    if (reach_.size() < most)
        reach_.resize(most + most / 2);
}

bool Motors::has_volume_source() const {
    return std::any_of(slots_.begin(), slots_.end(), [](const Slot& slot) {
        return slot.used && (std::holds_alternative<OmniMotor>(slot.motor) || std::holds_alternative<PressureMotor>(slot.motor));
    });
}

const Motor* Motors::find(MotorId id) const {
    const auto slot = const_cast<Motors*>(this)->slot_of(id);
    return slot ? &(*slot)->motor : nullptr;
}

void Motors::begin_frame(double lead, double duration) {
    for (Slot& slot : slots_)
        if (slot.used)
            slot.track.begin_frame(lead, duration);
}

void Motors::squeeze(double factor) {
    for (Slot& slot : slots_)
        if (slot.used)
            slot.track.squeeze(factor);
}

std::span<const detail::MotorReach> Motors::tick(double duration, const Window& window, const Boundaries& boundaries) {
    std::size_t count = 0;
    for (std::uint32_t index = 0; index < slots_.size(); ++index) {
        Slot& slot = slots_[index];
        if (!slot.used)
            continue;
        const auto path = slot.track.tick(duration);
        const auto reaching = static_cast<std::size_t>(detail::prepare(slot.motor, slot.track, path, slot.age, duration, window,
                                                                       boundaries, std::span(reach_).subspan(count)));
        slot.reaches = reaching > 0;
        count += reaching;
        slot.age += duration;
        if (slot.age >= end_of(slot.motor))
            release(index);
    }
    const std::span<detail::MotorReach> reached = std::span(reach_).first(count);
    std::sort(reached.begin(), reached.end(), detail::before);
    return reached;
}

int Motors::lost(const Window& window, const Boundaries& boundaries, glm::bvec3 follows) const {
    const glm::dvec3 low = window.origin(), size = window.size();
    return static_cast<int>(std::count_if(slots_.begin(), slots_.end(), [&](const Slot& slot) {
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
    return slots_.capacity() * sizeof(Slot) + reach_.capacity() * sizeof(detail::MotorReach) +
           free_.capacity() * sizeof(std::uint32_t) + (tile_ ? tile_->memory_bytes() : 0);
}

} // namespace windrow
