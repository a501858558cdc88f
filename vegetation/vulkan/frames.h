// Frames in flight: while the device works on one, the host records the next.
#pragma once

#include "vegetation/vulkan/device.h"

namespace windrow::vegetation::engine {

inline constexpr int k_frames_in_flight = 2;

struct Frame {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    int slot = 0; ///< 0 to k_frames_in_flight - 1
};

class Frames {
  public:
    explicit Frames(Device& device);
    Frames(const Frames&) = delete;
    Frames& operator=(const Frames&) = delete;
    /// Nothing is in flight any more.
    ~Frames() { wait(); }

    /// The next frame, recording. What was recorded for its slot before is done.
    [[nodiscard]] Frame begin();
    void submit(const Frame& frame);
    /// Until all is done.
    void wait();

  private:
    Device& device_;
    VkCommandBuffer commands_[k_frames_in_flight]{};
    VkFence done_[k_frames_in_flight]{};
    int next_ = 0;
};

} // namespace windrow::vegetation::engine
