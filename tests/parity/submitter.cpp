#include "tests/parity/submitter.h"

#include <cstdint>

namespace windrow::vulkan {

Submitter::Submitter(const Host& host, int frames_in_flight) : host_(host), slots_(static_cast<std::size_t>(frames_in_flight)) {
    call<PFN_vkGetDeviceQueue>("vkGetDeviceQueue")(host_.device, host_.queue_family, 0, &queue_);
    for (FrameSlot& slot : slots_) {
        VkCommandPoolCreateInfo pool{};
        pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        pool.queueFamilyIndex = host_.queue_family;
        EXPECT_EQ(call<PFN_vkCreateCommandPool>("vkCreateCommandPool")(host_.device, &pool, nullptr, &slot.pool), VK_SUCCESS);
        VkCommandBufferAllocateInfo commands{};
        commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        commands.commandPool = slot.pool;
        commands.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        commands.commandBufferCount = 1;
        EXPECT_EQ(call<PFN_vkAllocateCommandBuffers>("vkAllocateCommandBuffers")(host_.device, &commands, &slot.commands),
                  VK_SUCCESS);
        VkFenceCreateInfo done{};
        done.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        done.flags = VK_FENCE_CREATE_SIGNALED_BIT;
        EXPECT_EQ(call<PFN_vkCreateFence>("vkCreateFence")(host_.device, &done, nullptr, &slot.done), VK_SUCCESS);
    }
}

Submitter::~Submitter() {
    wait();
    for (const FrameSlot& slot : slots_) {
        call<PFN_vkDestroyFence>("vkDestroyFence")(host_.device, slot.done, nullptr);
        call<PFN_vkDestroyCommandPool>("vkDestroyCommandPool")(host_.device, slot.pool, nullptr);
    }
}

void Submitter::wait() {
    for (const FrameSlot& slot : slots_)
        EXPECT_EQ(call<PFN_vkWaitForFences>("vkWaitForFences")(host_.device, 1, &slot.done, VK_TRUE, UINT64_MAX), VK_SUCCESS);
}

const Submitter::FrameSlot& Submitter::recorded(const std::function<void(VkCommandBuffer, int)>& record) {
    const FrameSlot& slot = slots_[next_];
    EXPECT_EQ(call<PFN_vkWaitForFences>("vkWaitForFences")(host_.device, 1, &slot.done, VK_TRUE, UINT64_MAX), VK_SUCCESS);
    EXPECT_EQ(call<PFN_vkResetCommandPool>("vkResetCommandPool")(host_.device, slot.pool, 0), VK_SUCCESS);
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    EXPECT_EQ(call<PFN_vkBeginCommandBuffer>("vkBeginCommandBuffer")(slot.commands, &begin), VK_SUCCESS);
    record(slot.commands, static_cast<int>(next_));
    EXPECT_EQ(call<PFN_vkEndCommandBuffer>("vkEndCommandBuffer")(slot.commands), VK_SUCCESS);
    return slot;
}

void Submitter::discard(const std::function<void(VkCommandBuffer, int)>& record) {
    const FrameSlot& slot = recorded(record);
    EXPECT_EQ(call<PFN_vkResetCommandPool>("vkResetCommandPool")(host_.device, slot.pool, 0), VK_SUCCESS);
}

void Submitter::frame(const std::function<void(VkCommandBuffer, int)>& record) {
    const FrameSlot& slot = recorded(record);
    bool overlaps = false;
    for (const FrameSlot& other : slots_)
        overlaps = overlaps ||
                   (&other != &slot && call<PFN_vkGetFenceStatus>("vkGetFenceStatus")(host_.device, other.done) == VK_NOT_READY);
    overlapped_ += overlaps ? 1 : 0;
    EXPECT_EQ(call<PFN_vkResetFences>("vkResetFences")(host_.device, 1, &slot.done), VK_SUCCESS);
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &slot.commands;
    EXPECT_EQ(call<PFN_vkQueueSubmit>("vkQueueSubmit")(queue_, 1, &submit, slot.done), VK_SUCCESS);
    next_ = (next_ + 1) % slots_.size();
}

} // namespace windrow::vulkan
