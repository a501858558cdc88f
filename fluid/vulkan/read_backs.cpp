#include "fluid/vulkan/read_backs.h"

#include "fluid/message.h"

#include <cmath>
#include <utility>

namespace windrow::vulkan {

Result<void> ReadBacks::make(Air& air, int slots, bool queries, const RecordedFrame& start) {
    queries_ = queries;
    for (int n = 0; n < slots; ++n) {
        auto buffer = Buffer::create(air.device(), air.slot_bytes(queries), MemoryUse::readback);
        if (!buffer)
            return Error{buffer.error()};
        slots_.push_back({.buffer = *std::move(buffer), .frame = start});
    }
    if (queries)
        cells_.reserve(start.box.cell_count());
    return {};
}

Result<int> ReadBacks::begin(const Air& air, int slot) {
    const int next = slot >= 0 ? slot : (last_ + 1) % static_cast<int>(slots_.size());
    if (auto taken = take(air, next); !taken)
        return Error{taken.error()};
    before_last_ = std::exchange(last_, next);
    ++recording_;
    return next;
}

void ReadBacks::record(Air& air, VkCommandBuffer commands, const RecordedFrame& frame) {
    Reading& slot = slots_[static_cast<std::size_t>(last_)];
    air.read_back(commands, slot.buffer, queries_);
    slot.pending = true;
    slot.ticked = air.stepped();
    slot.recording = recording_;
    slot.frame = frame;
}

Result<bool> ReadBacks::take(const Air& air, int number) {
    Reading& slot = slots_[static_cast<std::size_t>(number)];
    if (!slot.pending)
        return false;
    if (const VkResult result = slot.buffer.invalidate(); result != VK_SUCCESS)
        return call_error("vkInvalidateMappedMemoryRanges", detail::message("the read-back of slot ", number), result);
    slot.pending = false;
    const AirReport found = air.report(slot.buffer);
    if (slot.ticked) {
        repaired_ += found.repaired_cells;
        limited_ += found.limited_cells;
    }
    if (slot.recording < taken_recording_) // a host that does not take its slots in turns
        return false;
    taken_recording_ = slot.recording;
    report_ = found;
    tick_ = slot.frame.tick;
    if (!queries_)
        return true;
    const auto cells = air.shown(slot.buffer);
    cells_.assign(cells.begin(), cells.end());
    frame_ = slot.frame;
    return true;
}

void ReadBacks::forget() {
    for (Reading& slot : slots_)
        slot.pending = false;
    last_ = before_last_;
    report_ = {};
}

void ReadBacks::report_to(Diagnostics& diagnostics, const Box& box) const {
    const auto h = static_cast<double>(box.cell_size);
    diagnostics.max_speed = report_.largest_component;
    diagnostics.cfl = report_.cfl;
    diagnostics.substeps = report_.substeps;
    diagnostics.substeps_capped = report_.substeps_capped;
    diagnostics.energy = 0.5 * report_.squares * h * h * h;
    diagnostics.divergence_rms = std::sqrt(report_.divergence_squares / static_cast<double>(box.cell_count()));
}

void ReadBacks::take_counts(Diagnostics& diagnostics) {
    diagnostics.limited_cells = std::exchange(limited_, 0);
    diagnostics.repaired_cells = std::exchange(repaired_, 0);
}

} // namespace windrow::vulkan
