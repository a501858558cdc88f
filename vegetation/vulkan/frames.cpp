#include "vegetation/vulkan/frames.h"

#include <vulkan/vulkan.h>

namespace windrow::vegetation::engine {

Frames::Frames(Device& device) : device_(device) {
    VkCommandPoolCreateInfo pool_info{};
    pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool_info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    pool_info.queueFamilyIndex = device.family;
    VkCommandPool pool = VK_NULL_HANDLE;
    must(vkCreateCommandPool(device.device, &pool_info, nullptr, &pool), "vkCreateCommandPool");
    device.at_end([vulkan = device.device, pool] { vkDestroyCommandPool(vulkan, pool, nullptr); });
    VkCommandBufferAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = k_frames_in_flight;
    must(vkAllocateCommandBuffers(device.device, &info, commands_), "vkAllocateCommandBuffers");
    VkFenceCreateInfo fence_info{};
    fence_info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    fence_info.flags = VK_FENCE_CREATE_SIGNALED_BIT; // nothing is in flight yet
    for (VkFence& fence : done_) {
        must(vkCreateFence(device.device, &fence_info, nullptr, &fence), "vkCreateFence");
        device.at_end([vulkan = device.device, fence] { vkDestroyFence(vulkan, fence, nullptr); });
    }
}

Frame Frames::begin() {
    const Frame frame{.commands = commands_[next_], .slot = next_};
    next_ = (next_ + 1) % k_frames_in_flight;
    must(vkWaitForFences(device_.device, 1, &done_[frame.slot], VK_TRUE, UINT64_MAX), "vkWaitForFences");
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    must(vkBeginCommandBuffer(frame.commands, &info), "vkBeginCommandBuffer");
    return frame;
}

void Frames::submit(const Frame& frame) {
    must(vkEndCommandBuffer(frame.commands), "vkEndCommandBuffer");
    must(vkResetFences(device_.device, 1, &done_[frame.slot]), "vkResetFences");
    VkSubmitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &frame.commands;
    must(vkQueueSubmit(device_.queue, 1, &info, done_[frame.slot]), "vkQueueSubmit");
}

void Frames::wait() {
    must(vkWaitForFences(device_.device, k_frames_in_flight, done_, VK_TRUE, UINT64_MAX), "vkWaitForFences");
}

} // namespace windrow::vegetation::engine
