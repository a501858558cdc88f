#include "fluid/cpu/body_loads.h"

#include <algorithm>
#include <utility>

namespace windrow::cpu {
namespace {

constexpr std::uint32_t k_none = ~std::uint32_t{0};

} // namespace

void BodyLoads::place(std::span<const PlacedObstacle> bodies) {
    others_.clear();
    detail::make_room(others_, bodies.size());
    detail::make_room(pushes_, bodies.size());
    pushes_.resize(bodies.size());
    for (const PlacedObstacle& body : bodies) {
        const BodyLoad* const before = find(body.slot, body.generation);
        others_.push_back(before != nullptr ? *before : BodyLoad{.slot = body.slot, .generation = body.generation});
    }
    index(others_);
    loads_.swap(others_);
}

// Of the loads to come: the room is made before anything changes.
void BodyLoads::index(std::span<const BodyLoad> loads) {
    std::uint32_t slots = 0;
    for (const BodyLoad& load : loads)
        slots = std::max(slots, load.slot + 1);
    detail::make_room(by_slot_, slots);
    by_slot_.assign(slots, k_none);
    for (std::size_t n = 0; n < loads.size(); ++n)
        by_slot_[loads[n].slot] = static_cast<std::uint32_t>(n);
}

const BodyLoad* BodyLoads::find(std::uint32_t slot, std::uint32_t generation) const {
    if (slot >= by_slot_.size() || by_slot_[slot] == k_none || loads_[by_slot_[slot]].generation != generation)
        return nullptr;
    return &loads_[by_slot_[slot]];
}

void BodyLoads::begin(float duration) {
    duration_ = duration;
    for (BodyLoad& load : loads_)
        load.sum = load.blast = {};
}

void BodyLoads::forget_pressure() {
    for (BodyLoad& load : loads_)
        load.sum = {};
}

void BodyLoads::clear() {
    for (BodyLoad& load : loads_)
        load.history = load.sources = load.sum = load.blast = {};
}

void BodyLoads::add(const SolidFlow& flow, const float* potential, float scale, float weight, float kept) {
    flow.find_pushes(potential, pushes_);
    for (std::size_t n = 0; n < loads_.size(); ++n) {
        BodyLoad& load = loads_[n];
        load.in_box = pushes_[n].wetted > 0.0;
        load.sum += pushes_[n] + static_cast<double>(scale) * load.history;
        load.history = static_cast<double>(weight) * pushes_[n] + static_cast<double>(kept) * load.history;
    }
}

void BodyLoads::renew_sources(const SolidFlow& flow, const float* potential) {
    end_sources();
    flow.find_pushes(potential, pushes_);
    for (std::size_t n = 0; n < loads_.size(); ++n) {
        loads_[n].sources = pushes_[n];
        loads_[n].blast += pushes_[n];
    }
}

void BodyLoads::end_sources() {
    for (BodyLoad& load : loads_) {
        load.blast += -1.0 * load.sources;
        load.sources = {};
    }
}

ObstacleForce BodyLoads::force_on(std::uint32_t slot, std::uint32_t generation) const {
    const BodyLoad* const load = find(slot, generation);
    if (load == nullptr || !(duration_ > 0.0f))
        return {};
    ObstacleForce force = force_of(load->sum + load->blast, static_cast<double>(duration_));
    force.in_box = load->in_box;
    return force;
}

void BodyLoads::restore(std::vector<BodyLoad>&& loads, float duration) {
    pushes_.resize(loads.size());
    index(loads);
    loads_ = std::move(loads);
    duration_ = duration;
}

std::size_t BodyLoads::memory_bytes() const {
    return (loads_.capacity() + others_.capacity()) * sizeof(BodyLoad) + by_slot_.capacity() * sizeof(std::uint32_t) +
           pushes_.capacity() * sizeof(PressurePush);
}

} // namespace windrow::cpu
