#include "cli/bench/vulkan/plain_passes.h"

#include "shader_words/plain_stencil.h"

#include <glm/vec4.hpp>
#include <utility>

namespace windrow::cli {
namespace {

using namespace vulkan;

// As long along x as a row of memory likes; 128 invocations, which every device has.
constexpr std::array<std::uint32_t, 3> k_group = {32, 4, 1};

} // namespace

Result<PlainPasses> PlainPasses::create(Device& device, glm::ivec3 cells) {
    PlainPasses plain;
    plain.functions_ = &device.functions();
    plain.cells_ = cells;
    for (std::size_t axis = 0; axis < 3; ++axis)
        plain.groups_[axis] = (static_cast<std::uint32_t>(cells[static_cast<int>(axis)]) + k_group[axis] - 1) / k_group[axis];
    if (auto fits = device.check({.groups = plain.groups_, .local_size = k_group, .name = "plain_stencil"}); !fits)
        return fits.failure();
    const auto bytes = sizeof(glm::vec4) * static_cast<VkDeviceSize>(cells.x) * static_cast<VkDeviceSize>(cells.y) *
                       static_cast<VkDeviceSize>(cells.z);
    for (Buffer& field : plain.fields_) {
        auto made = Buffer::create(device, bytes, MemoryUse::device);
        if (!made)
            return made.failure();
        field = *std::move(made);
    }
    const std::vector<VkDescriptorType> kinds(2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    auto pipeline = Pipeline::create(device, {.code = shader_words::plain_stencil,
                                              .bindings = kinds,
                                              .constants = k_group,
                                              .push_bytes = 4 * sizeof(std::int32_t),
                                              .name = "plain_stencil"});
    if (!pipeline)
        return pipeline.failure();
    plain.pipeline_ = *std::move(pipeline);
    std::vector<Sets::Content> contents;
    for (const int from : {0, 1})
        contents.push_back({&plain.pipeline_,
                            {{.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = plain.fields_[from].handle()},
                             {.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = plain.fields_[from ^ 1].handle()}}});
    auto sets = Sets::create(device, contents);
    if (!sets)
        return sets.failure();
    plain.sets_ = *std::move(sets);
    return plain;
}

void PlainPasses::fill(VkCommandBuffer commands) const {
    constexpr std::uint32_t k_one = 0x3f800000u; // 1.0f
    for (const Buffer& field : fields_)
        functions_->vkCmdFillBuffer(commands, field.handle(), 0, VK_WHOLE_SIZE, k_one);
    barrier(commands);
}

void PlainPasses::stencil(VkCommandBuffer commands) {
    const std::int32_t push[4] = {cells_.x, cells_.y, cells_.z, 0};
    pipeline_.bind(*functions_, commands, sets_.at(static_cast<std::size_t>(from_)));
    functions_->vkCmdPushConstants(commands, pipeline_.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(push), push);
    functions_->vkCmdDispatch(commands, groups_[0], groups_[1], groups_[2]);
    barrier(commands);
    from_ ^= 1;
}

void PlainPasses::copy(VkCommandBuffer commands) {
    const VkBufferCopy region{.srcOffset = 0, .dstOffset = 0, .size = fields_[0].bytes()};
    functions_->vkCmdCopyBuffer(commands, fields_[from_].handle(), fields_[from_ ^ 1].handle(), 1, &region);
    barrier(commands);
    from_ ^= 1;
}

void PlainPasses::barrier(VkCommandBuffer commands) const {
    constexpr VkPipelineStageFlags work = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
    const VkMemoryBarrier all{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                              .pNext = nullptr,
                              .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
                              .dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT |
                                               VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT};
    functions_->vkCmdPipelineBarrier(commands, work, work, 0, 1, &all, 0, nullptr, 0, nullptr);
}

} // namespace windrow::cli
