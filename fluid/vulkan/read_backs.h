// Read-backs of the frames in flight, one slot each, and the latest result.
#pragma once

#include "fluid/vulkan/air.h"

#include <optional>
#include <vector>

namespace windrow::vulkan {

/// A frame that was recorded: where its cells lie, and when.
struct RecordedFrame {
    ShownFrame frame;
    Box box{}; ///< with the sides of its time
    BlendZone blend_zone{};
    double time = 0.0;      ///< [s] of the wind's own clock
    std::uint64_t tick = 0; ///< the last one in it or before
};

class ReadBacks {
  public:
    /// Makes the slots. `queries`: the cells are read back too; `start`: the wind before the first recording.
    [[nodiscard]] Result<void> make(Air& air, int slots, bool queries, const RecordedFrame& start);

    [[nodiscard]] bool has(int slot) const { return slot >= 0 && slot < static_cast<int>(slots_.size()); }
    /// A recording begins: its slot, the next in turn for -1. What was recorded there before is taken; nothing changes where
    /// that fails.
    [[nodiscard]] Result<int> begin(const Air& air, int slot);
    void record(Air& air, VkCommandBuffer commands, const RecordedFrame& frame);
    /// False where nothing waits there, or what is newer was taken already. The error: its memory could not be made visible to
    /// the host; it waits on.
    [[nodiscard]] Result<bool> take(const Air& air, int slot);
    /// Drops waiting read-backs; the last slot has its turn again.
    void forget();

    /// Of the last tick that was read, without counts.
    void report_to(Diagnostics& diagnostics, const Box& box) const;
    /// Cells that were repaired or limited since the last call.
    void take_counts(Diagnostics& diagnostics);
    [[nodiscard]] const AirReport& report() const { return report_; }
    [[nodiscard]] std::uint64_t tick() const { return tick_; } ///< of the report; 0: none was read
    [[nodiscard]] const std::optional<RecordedFrame>& frame() const { return frame_; }
    [[nodiscard]] std::span<const glm::vec4> cells() const { return cells_; } ///< [m/s] of the frame

  private:
    struct Reading {
        Buffer buffer;
        bool pending = false;        ///< recorded, and not taken yet
        bool ticked = false;         ///< with ticks of its own, whose counts it reports
        std::uint64_t recording = 0; ///< counted from 1
        RecordedFrame frame;
    };
    std::vector<Reading> slots_;
    bool queries_ = true;
    int last_ = -1, before_last_ = -1; ///< slots of the last two recordings
    std::uint64_t recording_ = 0, taken_recording_ = 0;
    AirReport report_;
    std::uint64_t tick_ = 0;
    std::int64_t repaired_ = 0, limited_ = 0; ///< cells that were read back and not taken yet
    std::optional<RecordedFrame> frame_;
    std::vector<glm::vec4> cells_;
};

} // namespace windrow::vulkan
