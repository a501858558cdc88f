// Timer of the passes of a recording: a timestamp before and after each dispatch, at both ends of the recording, and before its
// read-back.
#pragma once

#include "fluid/vulkan/pass_times.h"
#include "fluid/vulkan/passes.h"
#include "gpu/timestamps.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace windrow::vulkan {

class PassClock {
  public:
    /// For `slots` frames in flight of up to `laps` dispatches; those beyond are left out and counted.
    [[nodiscard]] static Result<PassClock> create(Device& device, int slots, std::uint32_t laps);

    /// A recording begins for a slot. What was recorded for it before is done: its times are read now.
    void begin(VkCommandBuffer commands, int slot);
    /// The read-back follows.
    void begin_read_back(VkCommandBuffer commands);
    void end(VkCommandBuffer commands);
    /// Reads the times of a slot before its turn comes: what was recorded for it is done.
    void collect(int slot) { take(slots_[static_cast<std::size_t>(slot)]); }
    /// What was recorded and not read yet is not read: a recording among it was never submitted.
    void forget();

    /// From its making to its end: one dispatch. Without a clock it does nothing.
    class Lap {
      public:
        Lap(PassClock* clock, VkCommandBuffer commands, Pass pass);
        ~Lap();
        Lap(const Lap&) = delete;
        Lap& operator=(const Lap&) = delete;

      private:
        PassClock* clock_;
        VkCommandBuffer commands_;
    };

    /// Of the last recording whose times are in, never of one before it; nothing before the first.
    [[nodiscard]] const std::optional<PassTimes>& times() const { return times_; }

  private:
    struct FrameLaps {
        Timestamps timestamps;    ///< as k_start to k_first_lap count, then two a lap
        std::vector<Pass> laps{}; ///< in the order of recording
        int untimed = 0;
        bool reads_back = false;
        bool pending = false;        ///< recorded, and not read yet
        std::uint64_t recording = 0; ///< counted from 1
    };
    void take(FrameLaps& slot);

    std::vector<FrameLaps> slots_;
    FrameLaps* now_ = nullptr; ///< while a frame is recorded
    std::uint64_t recording_ = 0, taken_recording_ = 0;
    std::vector<std::uint64_t> moments_;
    std::optional<PassTimes> times_;
    PassTimes next_times_; ///< room for the first
};

} // namespace windrow::vulkan
