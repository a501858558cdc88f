#include "vegetation/vulkan/cpu_wind.h"

#include <vulkan/vulkan.h>

namespace windrow::vegetation::engine {
namespace {

constexpr VkPipelineStageFlags k_reading = VK_PIPELINE_STAGE_ALL_GRAPHICS_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;

struct ImageState {
    VkImageLayout layout;
    VkPipelineStageFlags stages;
    VkAccessFlags access;
};
constexpr ImageState k_copied_to{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_TRANSFER_BIT,
                                 VK_ACCESS_TRANSFER_WRITE_BIT};

void turn(VkCommandBuffer commands, const std::array<Image, 2>& images, const ImageState& from, const ImageState& to) {
    std::array<VkImageMemoryBarrier, 2> barriers{};
    for (std::size_t n = 0; n < barriers.size(); ++n) {
        barriers[n].sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
        barriers[n].srcAccessMask = from.access;
        barriers[n].dstAccessMask = to.access;
        barriers[n].oldLayout = from.layout;
        barriers[n].newLayout = to.layout;
        barriers[n].srcQueueFamilyIndex = barriers[n].dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barriers[n].image = images[n].image;
        barriers[n].subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    }
    vkCmdPipelineBarrier(commands, from.stages, to.stages, 0, 0, nullptr, 0, nullptr, 2, barriers.data());
}

} // namespace

Result<std::unique_ptr<CpuWind>> CpuWind::create(Device& device, const Config& config) {
    auto air = windrow::Wind::create(config);
    if (!air)
        return Error{air.error()};
    return guarded([&] { return std::unique_ptr<CpuWind>(new CpuWind(device, *std::move(air))); });
}

CpuWind::CpuWind(Device& device, windrow::Wind air) : objects_(device), air_(std::move(air)) {
    const Box& box = air_.box();
    for (Image& image : images_)
        image = objects_.image({.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                                .extent = {static_cast<std::uint32_t>(box.cells.x), static_cast<std::uint32_t>(box.cells.y)},
                                .slices = static_cast<std::uint32_t>(box.cells.z),
                                .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    for (Buffer& buffer : staging_)
        buffer =
            objects_.buffer(Use::staging, 2 * sizeof(std::uint16_t) * 4 * box.cell_count(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    tile_ = filled_block(objects_, glm::vec4(0.0f), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT).buffer; // for a wind without gusts
}

void CpuWind::record(VkCommandBuffer commands, int slot) {
    const Box& box = air_.box();
    const std::size_t halves = 4 * box.cell_count();
    const Buffer& staging = staging_[static_cast<std::size_t>(slot)];
    const auto cells = std::span(static_cast<std::uint16_t*>(staging.mapped), 2 * halves);
    must(air_.view().write_vectors(cells.first(halves)));
    must(air_.previous_view().write_vectors(cells.last(halves)));
    record_tile(commands, slot);

    // What the images held need not stay, but shaders of the frame before may still read it.
    turn(commands, images_, {VK_IMAGE_LAYOUT_UNDEFINED, k_reading, 0}, k_copied_to);
    for (std::size_t n = 0; n < images_.size(); ++n) {
        VkBufferImageCopy copy{};
        copy.bufferOffset = n * halves * sizeof(std::uint16_t);
        copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        copy.imageExtent = {static_cast<std::uint32_t>(box.cells.x), static_cast<std::uint32_t>(box.cells.y),
                            static_cast<std::uint32_t>(box.cells.z)};
        vkCmdCopyBufferToImage(commands, staging.buffer, images_[n].image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    }
    turn(commands, images_, k_copied_to, {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, k_reading, VK_ACCESS_SHADER_READ_BIT});
}

void CpuWind::record_tile(VkCommandBuffer commands, int slot) {
    const auto& tile = air_.view().ambient().tile();
    if (!tile || tile == shown_)
        return;
    const auto texels = std::as_bytes(tile->texels()); // of all tiles as many
    if (!shown_) {
        for (Buffer& buffer : tile_staging_)
            buffer = objects_.buffer(Use::staging, texels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
        tile_ = objects_.buffer(Use::work, texels.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)
                    .buffer;
    }
    const Buffer& staging = tile_staging_[static_cast<std::size_t>(slot)];
    std::memcpy(staging.mapped, texels.data(), texels.size());
    const VkBufferCopy copy{0, 0, texels.size()};
    VkMemoryBarrier written{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_TRANSFER_WRITE_BIT, VK_ACCESS_SHADER_READ_BIT};
    vkCmdPipelineBarrier(commands, k_reading, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0, nullptr, 0, nullptr);
    vkCmdCopyBuffer(commands, staging.buffer, tile_, 1, &copy);
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, k_reading, 0, 1, &written, 0, nullptr, 0, nullptr);
    shown_ = tile;
}

} // namespace windrow::vegetation::engine
