#include "cli/device_report/copy_rounds.h"

#include "shader_words/copy_rounds.h"

#include <algorithm>
#include <glm/vec4.hpp>
#include <utility>

namespace windrow::cli {
namespace {

using namespace vulkan;

constexpr std::uint32_t k_copy_group[] = {128};
constexpr std::uint32_t k_groups = 2048; // 262,144 threads: more than any device runs at once

} // namespace

Result<CopyRounds> CopyRounds::create(Device& device, VkDeviceSize bytes) {
    CopyRounds made;
    made.functions_ = &device.functions();
    for (Buffer* const buffer : {&made.from_, &made.to_, &made.nothing_}) {
        const bool nothing = buffer == &made.nothing_;
        auto one = Buffer::create(device, nothing ? sizeof(VkDispatchIndirectCommand) : bytes / 2, MemoryUse::device);
        if (!one)
            return one.failure();
        *buffer = *std::move(one);
    }
    const std::vector<VkDescriptorType> kinds(2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    auto pipeline = Pipeline::create(device, {.code = shader_words::copy_rounds,
                                              .bindings = kinds,
                                              .constants = k_copy_group,
                                              .push_bytes = 2 * sizeof(std::uint32_t),
                                              .name = "copy_rounds"});
    if (!pipeline)
        return pipeline.failure();
    made.pipeline_ = *std::move(pipeline);
    const Sets::Content content{&made.pipeline_,
                                {{.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = made.from_.handle()},
                                 {.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = made.to_.handle()}}};
    auto sets = Sets::create(device, {&content, 1});
    if (!sets)
        return sets.failure();
    made.sets_ = *std::move(sets);
    return made;
}

void CopyRounds::fill(VkCommandBuffer commands) const {
    for (const Buffer* const buffer : {&from_, &to_, &nothing_})
        functions_->vkCmdFillBuffer(commands, buffer->handle(), 0, VK_WHOLE_SIZE, 0);
    barrier(commands);
}

void CopyRounds::bind(VkCommandBuffer commands) const {
    pipeline_.bind(*functions_, commands, sets_.at(0));
    push(commands, 0, 0);
}

void CopyRounds::push(VkCommandBuffer commands, std::uint32_t count, std::uint32_t rounds) const {
    const std::uint32_t values[] = {count, rounds};
    functions_->vkCmdPushConstants(commands, pipeline_.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(values), values);
}

void CopyRounds::launch(VkCommandBuffer commands) const {
    functions_->vkCmdDispatch(commands, 1, 1, 1);
}

void CopyRounds::launch_nothing(VkCommandBuffer commands) const {
    functions_->vkCmdDispatchIndirect(commands, nothing_.handle(), 0);
}

VkDeviceSize CopyRounds::copied(VkDeviceSize bytes) {
    constexpr VkDeviceSize once = VkDeviceSize{k_groups} * k_copy_group[0] * sizeof(glm::vec4);
    return std::max<VkDeviceSize>(1, (bytes + once - 1) / once) * once;
}

void CopyRounds::copy(VkCommandBuffer commands, VkDeviceSize bytes) const {
    constexpr VkDeviceSize once = VkDeviceSize{k_groups} * k_copy_group[0] * sizeof(glm::vec4);
    push(commands, static_cast<std::uint32_t>(from_.bytes() / sizeof(glm::vec4)),
         static_cast<std::uint32_t>(copied(bytes) / once));
    functions_->vkCmdDispatch(commands, k_groups, 1, 1);
}

void CopyRounds::transfer(VkCommandBuffer commands, VkDeviceSize at, VkDeviceSize bytes) const {
    const VkBufferCopy region{.srcOffset = at, .dstOffset = at, .size = bytes};
    functions_->vkCmdCopyBuffer(commands, from_.handle(), to_.handle(), 1, &region);
}

void CopyRounds::barrier(VkCommandBuffer commands) const {
    constexpr VkPipelineStageFlags work =
        VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT | VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT;
    const VkMemoryBarrier all{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                              .pNext = nullptr,
                              .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
                              .dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT |
                                               VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT |
                                               VK_ACCESS_INDIRECT_COMMAND_READ_BIT};
    functions_->vkCmdPipelineBarrier(commands, work, work, 0, 1, &all, 0, nullptr, 0, nullptr);
}

} // namespace windrow::cli
