#include "fluid/vulkan/pass_clock.h"

#include <array>
#include <utility>

namespace windrow::vulkan {

Result<PassClock> PassClock::create(Device& device, int slots, std::uint32_t laps) {
    PassClock clock;
    for (int n = 0; n < slots; ++n) {
        auto timestamps = Timestamps::create(device, 2 + 2 * laps);
        if (!timestamps)
            return Error{timestamps.error()};
        clock.slots_.push_back({.timestamps = *std::move(timestamps)});
        clock.slots_.back().laps.reserve(laps);
    }
    clock.moments_.reserve(2 + 2 * laps);
    clock.next_times_.passes.reserve(k_passes);
    return clock;
}

void PassClock::begin(VkCommandBuffer commands, int slot) {
    now_ = &slots_[static_cast<std::size_t>(slot)];
    take(*now_);
    now_->laps.clear();
    now_->untimed = 0;
    now_->recording = ++recording_;
    now_->timestamps.reset(commands);
    now_->timestamps.write(commands, 0);
}

void PassClock::end(VkCommandBuffer commands) {
    now_->timestamps.write(commands, 1);
    std::exchange(now_, nullptr)->pending = true;
}

void PassClock::forget() {
    for (FrameLaps& slot : slots_)
        slot.pending = false;
}

PassClock::Lap::Lap(PassClock* clock, VkCommandBuffer commands, Pass pass) : clock_(clock), commands_(commands) {
    if (clock_ == nullptr)
        return;
    FrameLaps& slot = *clock_->now_;
    const auto lap = static_cast<std::uint32_t>(slot.laps.size());
    if (2 * lap + 4 > slot.timestamps.count()) {
        ++slot.untimed;
        clock_ = nullptr;
        return;
    }
    slot.laps.push_back(pass);
    slot.timestamps.write(commands_, 2 * lap + 2);
}

PassClock::Lap::~Lap() {
    if (clock_ == nullptr)
        return;
    const FrameLaps& slot = *clock_->now_;
    slot.timestamps.write(commands_, 2 * static_cast<std::uint32_t>(slot.laps.size()) + 1);
}

void PassClock::take(FrameLaps& slot) {
    if (!std::exchange(slot.pending, false) || slot.recording < taken_recording_) // slots in turns or not
        return;
    moments_.resize(2 + 2 * slot.laps.size());
    if (!slot.timestamps.read(moments_))
        return;
    taken_recording_ = slot.recording;
    std::array<PassTimes::Pass, k_passes> kinds{};
    for (std::size_t lap = 0; lap < slot.laps.size(); ++lap) {
        PassTimes::Pass& kind = kinds[static_cast<std::size_t>(slot.laps[lap])];
        kind.name = name_of(slot.laps[lap]);
        ++kind.dispatches;
        kind.us += slot.timestamps.microseconds(moments_[2 * lap + 2], moments_[2 * lap + 3]);
    }
    PassTimes& times = times_ ? *times_ : times_.emplace(std::move(next_times_));
    times.passes.clear();
    times.whole_us = slot.timestamps.microseconds(moments_[0], moments_[1]);
    times.untimed = slot.untimed;
    for (const PassTimes::Pass& kind : kinds)
        if (kind.dispatches > 0)
            times.passes.push_back(kind);
}

} // namespace windrow::vulkan
