// A host that keeps frames in flight: each slot has its command buffer and its fence, and only a slot's own fence is waited for,
// when its turn comes again.
#pragma once

#include "fluid/vulkan/host.h"

#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace windrow::vulkan {

class Submitter {
  public:
    Submitter(const Host& host, int frames_in_flight);
    /// Waits for all.
    ~Submitter();
    Submitter(const Submitter&) = delete;
    Submitter& operator=(const Submitter&) = delete;

    /// Records and submits a frame in the slot whose turn it is, once that slot's last one is done.
    void frame(const std::function<void(VkCommandBuffer commands, int slot)>& record);
    /// Records into the next slot's command buffer and throws it away.
    void discard(const std::function<void(VkCommandBuffer commands, int slot)>& record);
    /// Until nothing is in flight.
    void wait();
    /// Frames that were recorded while another was still running on the device.
    [[nodiscard]] int overlapped() const { return overlapped_; }

  private:
    struct FrameSlot {
        VkCommandPool pool = VK_NULL_HANDLE;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        VkFence done = VK_NULL_HANDLE;
    };
    /// The slot whose turn it is, recorded.
    const FrameSlot& recorded(const std::function<void(VkCommandBuffer, int)>& record);
    template <class Call>
    [[nodiscard]] Call call(const char* name) const {
        return reinterpret_cast<Call>(host_.get_instance_proc_addr(host_.instance, name));
    }

    Host host_;
    VkQueue queue_ = VK_NULL_HANDLE;
    std::vector<FrameSlot> slots_;
    std::size_t next_ = 0;
    int overlapped_ = 0;
};

} // namespace windrow::vulkan
