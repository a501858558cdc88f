#include "vegetation/fur/coat_room.h"

#include "shader_words/coat_outside.h"
#include "shader_words/coat_patches.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"
#include "vegetation/vulkan/pipeline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace windrow::vegetation::fur {
namespace {

constexpr std::uint32_t k_group = 64;
constexpr VkDescriptorType k_storage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr engine::Binding k_of_compute{k_storage, VK_SHADER_STAGE_COMPUTE_BIT};
constexpr std::array k_bindings{k_of_compute, k_of_compute, k_of_compute, k_of_compute};

struct Push {
    std::int32_t first;
    std::uint32_t patches, last_cell, narrow;
    float takes, gives;
};

// [s] Relaxation of lean and length: a tuft that the skin stops is seen to move. Back it may take longer: it is outside meanwhile.
constexpr double k_takes = 0.025, k_gives = 0.1;

// 1 after no frame, or after one that nothing is known of.
float followed(double seconds, double relaxation, bool first) {
    return first || seconds <= 0.0 ? 1.0f : static_cast<float>(-std::expm1(-seconds / relaxation));
}

void wait(VkCommandBuffer commands, VkPipelineStageFlags from, VkAccessFlags wrote, VkPipelineStageFlags to,
          VkAccessFlags takes) {
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = wrote;
    barrier.dstAccessMask = takes;
    vkCmdPipelineBarrier(commands, from, to, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

} // namespace

CoatRoom::CoatRoom(engine::Objects& objects, std::span<const VkDescriptorSetLayout, 3> before,
                   std::span<const CoatPatchBlock> patches, std::span<const std::uint32_t> narrow)
    : patches_(static_cast<std::uint32_t>(patches.size())), last_cell_(std::bit_ceil(std::max(2 * patches_, 64u)) - 1),
      narrow_(static_cast<std::uint32_t>(narrow.size())) {
    const VkDescriptorSetLayout own = engine::make_layout(objects, k_bindings);
    const std::array sets{before[0], before[1], before[2], own};
    layout_ = engine::make_pipeline_layout(objects, sets, sizeof(Push));
    place_ = engine::make_compute_pipeline(objects, layout_, windrow::vulkan::shader_words::coat_patches);
    limit_ = engine::make_compute_pipeline(objects, layout_, windrow::vulkan::shader_words::coat_outside);
    constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const engine::Buffer roots = engine::filled(objects, patches, storage);
    const engine::Buffer placed = objects.buffer(engine::Use::work, 2 * sizeof(glm::vec4) * patches.size(), storage);
    const engine::Buffer cells = objects.buffer(engine::Use::work, sizeof(std::uint32_t) * (std::size_t{last_cell_} + 1),
                                                storage | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    const engine::Buffer named = engine::filled(objects, narrow, storage);
    cells_ = cells.buffer;
    engine::make_sets(objects, own, k_bindings, std::span(&set_, 1));
    std::uint32_t binding = 0;
    for (const engine::Buffer& each : {roots, placed, cells, named})
        engine::point(objects.device(), set_, binding++, k_storage, each.buffer);
}

void CoatRoom::record(VkCommandBuffer commands, std::span<const VkDescriptorSet, 3> before, double seconds, bool first) const {
    constexpr VkPipelineStageFlags compute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    constexpr VkAccessFlags reads_and_writes = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
    // The last frame's lists have been read; nothing of them is kept.
    wait(commands, compute, 0, VK_PIPELINE_STAGE_TRANSFER_BIT, 0);
    vkCmdFillBuffer(commands, cells_, 0, VK_WHOLE_SIZE, 0);
    wait(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, compute, reads_and_writes);
    const std::array sets{before[0], before[1], before[2], set_};
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, static_cast<std::uint32_t>(sets.size()),
                            sets.data(), 0, nullptr);
    const Push push{
        first ? 1 : 0, patches_, last_cell_, narrow_, followed(seconds, k_takes, first), followed(seconds, k_gives, first)};
    vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof push, &push);
    const auto run = [&](VkPipeline pipeline, std::uint32_t count) {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
        vkCmdDispatch(commands, (count + k_group - 1) / k_group, 1, 1);
        wait(commands, compute, VK_ACCESS_SHADER_WRITE_BIT, compute, reads_and_writes);
    };
    run(place_, patches_);
    run(limit_, narrow_);
}

} // namespace windrow::vegetation::fur
