// One queue's recordings: a command buffer and a fence a slot, and a semaphore that the other queue's next submission waits for.
// Calls come from the host's vkGetInstanceProcAddr. A call that fails throws std::runtime_error.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <windrow/fluid/vulkan/host.h>

class QueueLane {
  public:
    static constexpr std::size_t k_slots = 2; ///< recordings in flight

    /// `queue` is of the family host.queue_family.
    QueueLane(const windrow::vulkan::Host& host, VkQueue queue) : host_(host), queue_(queue) {
        VkCommandPoolCreateInfo pool{};
        pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
        pool.queueFamilyIndex = host.queue_family;
        must("vkCreateCommandPool", call<PFN_vkCreateCommandPool>("vkCreateCommandPool")(host.device, &pool, nullptr, &pool_));
        VkCommandBufferAllocateInfo commands{};
        commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        commands.commandPool = pool_;
        commands.commandBufferCount = k_slots;
        must("vkAllocateCommandBuffers",
             call<PFN_vkAllocateCommandBuffers>("vkAllocateCommandBuffers")(host.device, &commands, commands_.data()));
        VkFenceCreateInfo fence{};
        fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        fence.flags = VK_FENCE_CREATE_SIGNALED_BIT;
        for (VkFence& done : done_)
            must("vkCreateFence", call<PFN_vkCreateFence>("vkCreateFence")(host.device, &fence, nullptr, &done));
        VkSemaphoreCreateInfo semaphore{};
        semaphore.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
        must("vkCreateSemaphore", call<PFN_vkCreateSemaphore>("vkCreateSemaphore")(host.device, &semaphore, nullptr, &signal_));
    }
    QueueLane(const QueueLane&) = delete;
    QueueLane& operator=(const QueueLane&) = delete;
    /// Waits for its queue. The lane of the last submission ends first.
    ~QueueLane() {
        call<PFN_vkQueueWaitIdle>("vkQueueWaitIdle")(queue_);
        for (const VkFence done : done_)
            call<PFN_vkDestroyFence>("vkDestroyFence")(host_.device, done, nullptr);
        call<PFN_vkDestroySemaphore>("vkDestroySemaphore")(host_.device, signal_, nullptr);
        call<PFN_vkDestroyCommandPool>("vkDestroyCommandPool")(host_.device, pool_, nullptr);
    }

    /// Of its last submission, for one wait.
    [[nodiscard]] VkSemaphore signal() const { return signal_; }
    /// Until what was submitted in the slot is done.
    void wait(std::size_t slot) const {
        must("vkWaitForFences",
             call<PFN_vkWaitForFences>("vkWaitForFences")(host_.device, 1, &done_.at(slot), VK_TRUE, UINT64_MAX));
    }
    /// Records and submits in a slot that is done. The stages `at` wait for the semaphore `after`; null: for nothing.
    template <class Record>
    void submit(std::size_t slot, VkSemaphore after, VkPipelineStageFlags at, const Record& record) const {
        const VkCommandBuffer commands = commands_.at(slot);
        VkCommandBufferBeginInfo begin{};
        begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
        must("vkBeginCommandBuffer", call<PFN_vkBeginCommandBuffer>("vkBeginCommandBuffer")(commands, &begin));
        record(commands);
        must("vkEndCommandBuffer", call<PFN_vkEndCommandBuffer>("vkEndCommandBuffer")(commands));
        VkSubmitInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
        info.waitSemaphoreCount = after == VK_NULL_HANDLE ? 0 : 1;
        info.pWaitSemaphores = &after;
        info.pWaitDstStageMask = &at;
        info.commandBufferCount = 1;
        info.pCommandBuffers = &commands;
        info.signalSemaphoreCount = 1;
        info.pSignalSemaphores = &signal_;
        must("vkResetFences", call<PFN_vkResetFences>("vkResetFences")(host_.device, 1, &done_.at(slot)));
        must("vkQueueSubmit", call<PFN_vkQueueSubmit>("vkQueueSubmit")(queue_, 1, &info, done_.at(slot)));
    }

  private:
    template <class Call>
    [[nodiscard]] Call call(const char* name) const {
        return reinterpret_cast<Call>(host_.get_instance_proc_addr(host_.instance, name));
    }
    static void must(const char* name, VkResult result) {
        if (result != VK_SUCCESS)
            throw std::runtime_error(std::string(name) + " failed: " + windrow::vulkan::name_of(result) + ".");
    }

    windrow::vulkan::Host host_;
    VkQueue queue_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    std::array<VkCommandBuffer, k_slots> commands_{};
    std::array<VkFence, k_slots> done_{};
    VkSemaphore signal_ = VK_NULL_HANDLE;
};
