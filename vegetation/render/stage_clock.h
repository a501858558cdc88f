// Times of the stages of a frame, by the device's clock.
#pragma once

#include "../vulkan/frames.h"

#include <array>
#include <vector>

namespace windrow::vegetation::render {

struct StageTime {
    const char* name = "";
    double us = 0.0; ///< [us]
};

class StageClock {
  public:
    explicit StageClock(engine::Objects& objects);

    /// Whether the queue has timestamps; without them nothing is recorded or reported.
    [[nodiscard]] bool counts() const { return tick_us_ > 0.0; }
    /// Begins a frame, outside of a render pass. What was recorded for its slot before is done: its times are taken now.
    void begin(VkCommandBuffer commands, int slot);
    /// Ends the stage of this name, which began where the last one ended. The string must outlive the clock. At most 159 a frame.
    void mark(VkCommandBuffer commands, const char* name);
    /// Takes the times of a slot before its turn comes: for a host that has waited for it.
    void collect(int slot);
    /// Of the last frame whose times are in: its stages, which add up to the frame; empty before the first.
    [[nodiscard]] const std::vector<StageTime>& times() const { return times_; }

  private:
    static constexpr std::uint32_t k_marks = 160;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueryPool pool_ = VK_NULL_HANDLE;
    double tick_us_ = 0.0;
    std::uint64_t mask_ = 0;
    int slot_ = 0;
    std::array<std::vector<const char*>, engine::k_frames_in_flight> names_{};
    std::vector<StageTime> times_{};
};

} // namespace windrow::vegetation::render
