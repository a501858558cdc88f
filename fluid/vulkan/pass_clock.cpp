#include "fluid/vulkan/pass_clock.h"

#include <array>
#include <utility>

namespace windrow::vulkan {
namespace {

// Timestamps of a recording: both ends, where its read-back begins, then two a lap.
constexpr std::uint32_t k_start = 0, k_end = 1, k_read_back = 2, k_first_lap = 3;

constexpr std::uint32_t timestamps_for(std::uint32_t laps) {
    return k_first_lap + 2 * laps;
}

} // namespace

Result<PassClock> PassClock::create(Device& device, int slots, std::uint32_t laps) {
    PassClock clock;
    for (int n = 0; n < slots; ++n) {
        auto timestamps = Timestamps::create(device, timestamps_for(laps));
        if (!timestamps)
            return timestamps.failure();
        clock.slots_.push_back({.timestamps = *std::move(timestamps)});
        clock.slots_.back().laps.reserve(laps);
    }
    clock.moments_.reserve(timestamps_for(laps));
    clock.next_times_.passes.reserve(k_passes);
    return clock;
}

void PassClock::begin(VkCommandBuffer commands, int slot) {
    now_ = &slots_[static_cast<std::size_t>(slot)];
    take(*now_);
    now_->laps.clear();
    now_->untimed = 0;
    now_->reads_back = false;
    now_->recording = ++recording_;
    now_->timestamps.reset(commands);
    now_->timestamps.write(commands, k_start);
}

void PassClock::begin_read_back(VkCommandBuffer commands) {
    now_->timestamps.write(commands, k_read_back);
    now_->reads_back = true;
}

void PassClock::end(VkCommandBuffer commands) {
    if (!now_->reads_back) // each moment that is read was written
        now_->timestamps.write(commands, k_read_back);
    now_->timestamps.write(commands, k_end);
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
    if (timestamps_for(lap + 1) > slot.timestamps.count()) {
        ++slot.untimed;
        clock_ = nullptr;
        return;
    }
    slot.laps.push_back(pass);
    slot.timestamps.write(commands_, timestamps_for(lap));
}

PassClock::Lap::~Lap() {
    if (clock_ == nullptr)
        return;
    const FrameLaps& slot = *clock_->now_;
    slot.timestamps.write(commands_, timestamps_for(static_cast<std::uint32_t>(slot.laps.size())) - 1);
}

void PassClock::take(FrameLaps& slot) {
    if (!std::exchange(slot.pending, false) || slot.recording < taken_recording_) // slots in turns or not
        return;
    moments_.resize(timestamps_for(static_cast<std::uint32_t>(slot.laps.size())));
    if (!slot.timestamps.read(moments_))
        return;
    taken_recording_ = slot.recording;
    std::array<PassTimes::Pass, k_passes> kinds{};
    for (std::size_t lap = 0; lap < slot.laps.size(); ++lap) {
        PassTimes::Pass& kind = kinds[static_cast<std::size_t>(slot.laps[lap])];
        kind.name = name_of(slot.laps[lap]);
        ++kind.dispatches;
        kind.us += slot.timestamps.microseconds(moments_[k_first_lap + 2 * lap], moments_[k_first_lap + 2 * lap + 1]);
    }
    PassTimes& times = times_ ? *times_ : times_.emplace(std::move(next_times_));
    times.passes.clear();
    times.whole_us = slot.timestamps.microseconds(moments_[k_start], moments_[k_end]);
    times.read_back_us = slot.reads_back ? slot.timestamps.microseconds(moments_[k_read_back], moments_[k_end]) : 0.0;
    times.untimed = slot.untimed;
    for (const PassTimes::Pass& kind : kinds)
        if (kind.dispatches > 0)
            times.passes.push_back(kind);
}

} // namespace windrow::vulkan
