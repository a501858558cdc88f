// Frames in flight: while the device works on one, the host records the next.
#pragma once

#include "objects.h"

namespace windrow::vegetation::engine {

struct Frame {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    int slot = 0; ///< 0 to k_frames_in_flight - 1
};

/// Semaphores of a frame that goes to a window.
struct Signals {
    VkSemaphore wait = VK_NULL_HANDLE; ///< before transfers: the window's image is free
    VkSemaphore done = VK_NULL_HANDLE; ///< signalled at the end: the image can be shown
};

class Frames {
  public:
    [[nodiscard]] static Result<std::unique_ptr<Frames>> create(Device& device);
    Frames(const Frames&) = delete;
    Frames& operator=(const Frames&) = delete;
    /// Nothing is in flight any more.
    ~Frames() { (void)wait(); }

    /// The next frame, recording; submit it, since it holds the uploads. What was recorded for its slot before is done. Errors,
    /// here and below: a device that is lost, or memory that is out.
    [[nodiscard]] Result<Frame> begin();
    Result<void> submit(const Frame& frame, const Signals& signals = {});
    /// Until all is done.
    Result<void> wait();
    /// Submits a frame, and waits until all is done.
    Result<void> finish(const Frame& frame);

  private:
    explicit Frames(Device& device);
    void wait_for(int slot);

    Objects objects_;
    VkCommandBuffer commands_[k_frames_in_flight]{};
    VkFence done_[k_frames_in_flight]{};
    bool submitted_[k_frames_in_flight]{};
    int next_ = 0;
};

} // namespace windrow::vegetation::engine
