#include "vegetation/vulkan/frames.h"

#include "vegetation/vulkan/calls.h"

namespace windrow::vegetation::engine {

Result<std::unique_ptr<Frames>> Frames::create(Device& device) {
    return guarded([&] { return std::unique_ptr<Frames>(new Frames(device)); });
}

Frames::Frames(Device& device) : objects_(device) {
    VkCommandPoolCreateInfo pool_info{};
    pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool_info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    pool_info.queueFamilyIndex = device.host().queue_family;
    const VkCommandPool pool = objects_.make(vkCreateCommandPool, vkDestroyCommandPool, pool_info, "vkCreateCommandPool");
    VkCommandBufferAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = k_frames_in_flight;
    must(vkAllocateCommandBuffers(device.handle(), &info, commands_), "vkAllocateCommandBuffers");
    VkFenceCreateInfo fence_info{};
    fence_info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    for (VkFence& fence : done_)
        fence = objects_.make(vkCreateFence, vkDestroyFence, fence_info, "vkCreateFence");
}

Result<Frame> Frames::begin() {
    return guarded([&] {
        const Frame frame{.commands = commands_[next_], .slot = next_};
        next_ = (next_ + 1) % k_frames_in_flight;
        wait_for(frame.slot);
        VkCommandBufferBeginInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
        must(vkBeginCommandBuffer(frame.commands, &info), "vkBeginCommandBuffer");
        objects_.device().begin_frame(frame.commands, frame.slot);
        return frame;
    });
}

Result<void> Frames::submit(const Frame& frame, const Signals& signals) {
    return guarded([&] {
        must(vkEndCommandBuffer(frame.commands), "vkEndCommandBuffer");
        must(vkResetFences(objects_.device().handle(), 1, &done_[frame.slot]), "vkResetFences");
        VkSubmitInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
        info.commandBufferCount = 1;
        info.pCommandBuffers = &frame.commands;
        constexpr VkPipelineStageFlags transfers = VK_PIPELINE_STAGE_TRANSFER_BIT;
        info.waitSemaphoreCount = signals.wait != VK_NULL_HANDLE ? 1 : 0;
        info.pWaitSemaphores = &signals.wait;
        info.pWaitDstStageMask = &transfers;
        info.signalSemaphoreCount = signals.done != VK_NULL_HANDLE ? 1 : 0;
        info.pSignalSemaphores = &signals.done;
        must(vkQueueSubmit(objects_.device().queue(), 1, &info, done_[frame.slot]), "vkQueueSubmit");
        submitted_[frame.slot] = true;
    });
}

Result<void> Frames::wait() {
    return guarded([&] {
        for (int slot = 0; slot < k_frames_in_flight; ++slot)
            wait_for(slot);
    });
}

// A frame whose submission failed never ends: nothing waits for it.
void Frames::wait_for(int slot) {
    if (std::exchange(submitted_[slot], false))
        must(vkWaitForFences(objects_.device().handle(), 1, &done_[slot], VK_TRUE, UINT64_MAX), "vkWaitForFences");
}

Result<void> Frames::finish(const Frame& frame) {
    if (auto submitted = submit(frame); !submitted)
        return submitted;
    return wait();
}

} // namespace windrow::vegetation::engine
