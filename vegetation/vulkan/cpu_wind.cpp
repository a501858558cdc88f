#include "vegetation/vulkan/cpu_wind.h"

#include "fluid/core/message.h"
#include "vegetation/vulkan/calls.h"

#include <glm/common.hpp>

namespace windrow::vegetation::engine {
namespace {

constexpr VkPipelineStageFlags k_reading = VK_PIPELINE_STAGE_ALL_GRAPHICS_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
constexpr std::size_t k_halves = 4; // of a texel

struct ImageState {
    VkImageLayout layout;
    VkPipelineStageFlags stages;
    VkAccessFlags access;
};
constexpr ImageState k_copied_to{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_TRANSFER_BIT,
                                 VK_ACCESS_TRANSFER_WRITE_BIT};

void turn(VkCommandBuffer commands, const Image& image, const ImageState& from, const ImageState& to) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = from.access;
    barrier.dstAccessMask = to.access;
    barrier.oldLayout = from.layout;
    barrier.newLayout = to.layout;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(commands, from.stages, to.stages, 0, 0, nullptr, 0, nullptr, 1, &barrier);
}

} // namespace

Result<std::unique_ptr<CpuWind>> CpuWind::create(Device& device, const Config& config) {
    auto air = windrow::Wind::create(config);
    if (!air)
        return air.failure();
    return create(device, *std::move(air));
}

Result<std::unique_ptr<CpuWind>> CpuWind::create(Device& device, windrow::Wind air) {
    const glm::ivec3 cells = air.box().cells;
    const int most = glm::max(glm::max(cells.x, cells.y), cells.z), limit = static_cast<int>(device.limits().maxImageDimension3D);
    if (most > limit)
        return Error{detail::message("the box has ", most, " cells along an axis, and this device's textures have at most ",
                                     limit, "; give fewer cells.")};
    return guarded([&] { return std::unique_ptr<CpuWind>(new CpuWind(device, std::move(air))); });
}

CpuWind::CpuWind(Device& device, windrow::Wind air) : objects_(device), air_(std::move(air)), cells_(air_.box().cells) {
    const glm::uvec3 cells(cells_);
    for (Image& image : images_)
        image = objects_.image({.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                                .extent = {cells.x, cells.y},
                                .slices = cells.z,
                                .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    for (Buffer& buffer : staging_)
        buffer = objects_.buffer(Use::staging, sizeof(std::uint16_t) * k_halves * air_.box().cell_count(),
                                 VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    shown_ = air_.view().ambient().tile();
    const glm::vec4 nothing(0.0f); // 16 bytes for a wind without gusts
    tile_ = objects_.filled(std::as_bytes(shown_ ? shown_->texels() : std::span(&nothing, 1)), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)
                .buffer;
}

Result<void> CpuWind::record(VkCommandBuffer commands, int slot_number) {
    if (slot_number < 0 || slot_number >= k_frames_in_flight)
        return Error{detail::message("slot is ", slot_number, "; give 0 to ", k_frames_in_flight - 1, ".")};
    if (air_.box().cells != cells_)
        return Error{"the air has other cells than the one that this was made for; make another CpuWind for it."};
    return guarded([&] {
        const auto slot = static_cast<std::size_t>(slot_number);
        record_tile(commands, slot);
        must(air_.view().write_vectors(
            std::span(static_cast<std::uint16_t*>(staging_[slot].mapped), k_halves * air_.box().cell_count())));
        now_ = 1 - now_;
        copy_cells(commands, staging_[slot].buffer, now_);
        if (!begun_) // the frame before the first is as the first
            copy_cells(commands, staging_[slot].buffer, 1 - now_);
        begun_ = true;
    });
}

void CpuWind::copy_cells(VkCommandBuffer commands, VkBuffer from, std::size_t image) {
    // What the image held need not stay, but shaders of the frame before may still read it.
    turn(commands, images_[image], {VK_IMAGE_LAYOUT_UNDEFINED, k_reading, 0}, k_copied_to);
    const glm::uvec3 cells(cells_);
    VkBufferImageCopy copy{};
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = {cells.x, cells.y, cells.z};
    vkCmdCopyBufferToImage(commands, from, images_[image].image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    turn(commands, images_[image], k_copied_to, {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, k_reading, VK_ACCESS_SHADER_READ_BIT});
}

void CpuWind::record_tile(VkCommandBuffer commands, std::size_t slot) {
    const auto& tile = air_.view().ambient().tile();
    if (!tile || tile == shown_)
        return;
    const auto texels = std::as_bytes(tile->texels()); // of all tiles as many
    if (tile_staging_[0].buffer == VK_NULL_HANDLE) {
        for (Buffer& buffer : tile_staging_)
            buffer = objects_.buffer(Use::staging, texels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
        tile_ = objects_.buffer(Use::work, texels.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)
                    .buffer;
    }
    std::memcpy(tile_staging_[slot].mapped, texels.data(), texels.size());
    const VkBufferCopy copy{0, 0, texels.size()};
    const VkMemoryBarrier written{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_TRANSFER_WRITE_BIT,
                                  VK_ACCESS_SHADER_READ_BIT};
    vkCmdPipelineBarrier(commands, k_reading, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0, nullptr, 0, nullptr);
    vkCmdCopyBuffer(commands, tile_staging_[slot].buffer, tile_, 1, &copy);
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, k_reading, 0, 1, &written, 0, nullptr, 0, nullptr);
    shown_ = tile;
}

} // namespace windrow::vegetation::engine
