// What a shader needs of a wind on the CPU: the cells as a texture, the block that places it, the gust tile, and the set of
// shaders/coupling/windrow_wind.glsl that names them. The CPU's counterpart of vegetation/vulkan/wind_set.h.
//
// What is used here of vegetation/vulkan makes images and mapped buffers, as every engine does.
#pragma once

#include <windrow/fluid/vulkan/textures.h>
#include <windrow/fluid/wind.h>
#include <windrow/vegetation/vulkan/descriptors.h>

#include <vulkan/vulkan.h>

class CpuWindSet {
  public:
    /// For winds with the box and the gust tile of this one.
    CpuWindSet(windrow::vegetation::engine::Objects& objects, const windrow::Wind& wind)
        : objects_(objects), cells_(wind.box().cells),
          image_(objects.image({.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                                .extent = {cells_.x, cells_.y},
                                .slices = cells_.z,
                                .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT})),
          blocks_(objects.frame_buffers(sizeof(windrow::FrameBlock), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT)),
          tile_(tile_of(objects, wind.view().ambient())),
          sampler_(objects.sampler(windrow::vulkan::sampler_info(wind.box().boundaries))) {
        for (auto& buffer : staging_) // a half is two bytes
            buffer = objects.buffer(Use::staging, 2 * 4 * wind.box().cell_count(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
        std::vector<windrow::vegetation::engine::Binding> bindings;
        for (const auto& binding : windrow::vulkan::set_bindings(windrow::vulkan::TextureSet::vectors, k_stages))
            bindings.push_back({binding.descriptorType, binding.stageFlags});
        layout_ = make_layout(objects, bindings);
        make_sets(objects, layout_, bindings, sets_);
    }

    [[nodiscard]] VkDescriptorSetLayout layout() const { return layout_; }

    /// The set of a frame in flight. Writes cells and block into mapped memory, and records the copy of the cells for the shaders that
    /// follow. Outside of a render pass; what was recorded for the slot before is done.
    [[nodiscard]] VkDescriptorSet record(VkCommandBuffer commands, int slot_number, const windrow::Wind& wind,
                                         glm::dvec3 anchor) {
        const auto slot = static_cast<std::size_t>(slot_number);
        const auto& staging = staging_[slot];
        auto* const halves = static_cast<std::uint16_t*>(staging.mapped);
        windrow::vegetation::engine::must(wind.write_vectors({halves, 4 * wind.box().cell_count()}));
        VkBufferImageCopy copy{};
        copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        copy.imageExtent = {cells_.x, cells_.y, cells_.z};
        // What the image held need not stay, but shaders of the frame before may still read it.
        turn(commands, {VK_IMAGE_LAYOUT_UNDEFINED, k_reading, 0}, k_copied_to);
        vkCmdCopyBufferToImage(commands, staging.buffer, image_.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
        turn(commands, k_copied_to, {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, k_reading, VK_ACCESS_SHADER_READ_BIT});

        const windrow::FrameBlock block = wind.frame_block(anchor);
        std::memcpy(blocks_[slot].mapped, &block, sizeof block);
        // A host with motion vectors keeps a second image: `before` is what windrow_velocity_previous samples.
        const windrow::vulkan::Textures textures{.vectors = {image_.image, image_.view}};
        const windrow::vulkan::SetWrites writes(sets_[slot], {.now = textures,
                                                              .before = textures,
                                                              .sampler = sampler_,
                                                              .block = {blocks_[slot].buffer, 0, sizeof block},
                                                              .tile = tile_});
        vkUpdateDescriptorSets(objects_.device().handle(), writes.size(), writes.data(), 0, nullptr);
        return sets_[slot];
    }

  private:
    using Use = windrow::vegetation::engine::Use;
    static constexpr VkShaderStageFlags k_stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
    static constexpr VkPipelineStageFlags k_reading = VK_PIPELINE_STAGE_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;

    struct ImageState {
        VkImageLayout layout;
        VkPipelineStageFlags stages;
        VkAccessFlags access;
    };
    static constexpr ImageState k_copied_to{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_TRANSFER_BIT,
                                            VK_ACCESS_TRANSFER_WRITE_BIT};

    // 4 MiB, made once; a wind without gusts needs 16 bytes.
    static VkBuffer tile_of(windrow::vegetation::engine::Objects& objects, const windrow::AmbientWind& ambient) {
        const glm::vec4 nothing(0.0f);
        const auto texels = ambient.tile() ? ambient.tile()->texels() : std::span(&nothing, 1);
        return objects.filled(std::as_bytes(texels), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT).buffer;
    }

    void turn(VkCommandBuffer commands, const ImageState& from, const ImageState& to) const {
        VkImageMemoryBarrier barrier{};
        barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
        barrier.srcAccessMask = from.access;
        barrier.dstAccessMask = to.access;
        barrier.oldLayout = from.layout;
        barrier.newLayout = to.layout;
        barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.image = image_.image;
        barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdPipelineBarrier(commands, from.stages, to.stages, 0, 0, nullptr, 0, nullptr, 1, &barrier);
    }

    windrow::vegetation::engine::Objects& objects_;
    glm::uvec3 cells_;
    windrow::vegetation::engine::Image image_;
    windrow::vegetation::engine::FrameBuffers blocks_, staging_{};
    VkBuffer tile_;
    VkSampler sampler_;
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    std::array<VkDescriptorSet, windrow::vegetation::engine::k_frames_in_flight> sets_{};
};
