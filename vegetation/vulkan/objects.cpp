#include "vegetation/vulkan/objects.h"

#include "fluid/core/message.h"
#include "vegetation/vulkan/buffer_memory.h"
#include "vegetation/vulkan/calls.h"

#include <algorithm>

namespace windrow::vegetation::engine {
namespace {

// A piece that goes back with its owner.
vulkan::MemoryPiece kept(Objects& objects, BufferMemory& memory, VkDeviceSize bytes, const Result<vulkan::MemoryPiece>& piece) {
    if (!piece)
        throw Failure(detail::message("the renderer needs ", bytes,
                                      " more bytes of device memory: give a smaller picture or fewer plants. (", piece.error(),
                                      ")"));
    objects.at_end([&memory, held = *piece] { memory.release(held); });
    return *piece;
}

} // namespace

Objects::~Objects() {
    for (auto last = destroy_.rbegin(); last != destroy_.rend(); ++last)
        (*last)();
}

Buffer Objects::buffer(Use use, VkDeviceSize bytes, VkBufferUsageFlags usage) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes;
    info.usage = usage;
    Buffer made{.buffer = make(vkCreateBuffer, vkDestroyBuffer, info, "vkCreateBuffer")};
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device_->handle(), made.buffer, &needs);
    BufferMemory& memory = device_->memory();
    const VkDeviceSize before = memory.given();
    const vulkan::MemoryPiece piece = kept(*this, memory, needs.size, memory.allocate(needs, use));
    bytes_ += memory.given() - before;
    must(vkBindBufferMemory(device_->handle(), made.buffer, piece.memory, piece.offset), "vkBindBufferMemory");
    made.mapped = piece.mapped;
    made.memory = piece.memory;
    made.offset = piece.offset;
    made.bytes = bytes;
    return made;
}

VkBuffer Objects::storage(const char* name, const char* fix, VkDeviceSize bytes, VkBufferUsageFlags usage) {
    const std::string what = detail::message(name, " need ", bytes, " bytes in one buffer");
    if (const VkDeviceSize reach = device_->limits().maxStorageBufferRange; bytes > reach)
        throw Failure(detail::message(what, ", of which this device's shaders reach ", reach, ": ", fix, "."));
    try {
        return buffer(Use::work, bytes, usage).buffer;
    } catch (const Failure& failure) {
        throw Failure(what + ": " + fix + ". (" + failure.what() + ")");
    }
}

Buffer Objects::filled(std::span<const std::byte> content, VkBufferUsageFlags usage) {
    Buffer made = buffer(Use::fixed, content.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    if (made.mapped != nullptr) {
        std::memcpy(made.mapped, content.data(), content.size());
    } else {
        at_end([this, to = made.buffer] { device_->forget(to); });
        device_->upload(made, content.data());
    }
    made.mapped = nullptr;
    return made;
}

FrameBuffers Objects::frame_buffers(VkDeviceSize bytes, VkBufferUsageFlags usage) {
    FrameBuffers made;
    for (int slot = 0; slot < k_frames_in_flight; ++slot) {
        Buffer& here = made[static_cast<std::size_t>(slot)];
        here = buffer(Use::frame, bytes, usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
        if (here.mapped == nullptr) {
            const Buffer staged = buffer(Use::staging, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
            at_end([this, to = here.buffer] { device_->forget(to); });
            device_->copy_each_frame(slot, staged, here);
            here.mapped = staged.mapped;
        }
        std::memset(here.mapped, 0, bytes);
    }
    return made;
}

Image Objects::image(const ImageRecipe& recipe) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = recipe.slices > 0 ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
    info.format = recipe.format;
    info.extent = {recipe.extent.width, recipe.extent.height, std::max(recipe.slices, 1u)};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = recipe.samples;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = recipe.usage;
    Image made{.image = make(vkCreateImage, vkDestroyImage, info, "vkCreateImage")};
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device_->handle(), made.image, &needs);
    BufferMemory& memory = device_->memory();
    const VkDeviceSize before = memory.given();
    const vulkan::MemoryPiece piece = kept(*this, memory, needs.size, memory.allocate_image(needs));
    bytes_ += memory.given() - before;
    must(vkBindImageMemory(device_->handle(), made.image, piece.memory, piece.offset), "vkBindImageMemory");
    VkImageViewCreateInfo view_info{};
    view_info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view_info.image = made.image;
    view_info.viewType = recipe.slices > 0 ? VK_IMAGE_VIEW_TYPE_3D : VK_IMAGE_VIEW_TYPE_2D;
    view_info.format = recipe.format;
    view_info.subresourceRange = {recipe.aspect, 0, 1, 0, 1};
    made.view = make(vkCreateImageView, vkDestroyImageView, view_info, "vkCreateImageView");
    return made;
}

VkSampler Objects::sampler(Sampler kind) {
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    if (kind != Sampler::texels)
        info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    if (kind == Sampler::depth) {
        info.compareEnable = VK_TRUE;
        info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    }
    return sampler(info);
}

VkSampler Objects::sampler(const VkSamplerCreateInfo& info) {
    return make(vkCreateSampler, vkDestroySampler, info, "vkCreateSampler");
}

VkQueryPool Objects::queries(VkQueryType type, std::uint32_t count, VkQueryPipelineStatisticFlags statistics) {
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = type;
    info.queryCount = count;
    info.pipelineStatistics = statistics;
    return make(vkCreateQueryPool, vkDestroyQueryPool, info, "vkCreateQueryPool");
}

} // namespace windrow::vegetation::engine
