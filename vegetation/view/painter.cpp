#include "vegetation/view/painter.h"

#include "shader_words/panel_frag.h"
#include "shader_words/panel_vert.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"
#include "vegetation/vulkan/pipeline.h"

#include <algorithm>
#include <cstring>

namespace windrow::vegetation::view {
namespace {

namespace words = windrow::vulkan::shader_words;

constexpr std::array k_vertex_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT}};
constexpr std::array k_image_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_FRAGMENT_BIT}};

void turn_image(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = from == VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL ? VK_ACCESS_TRANSFER_WRITE_BIT : 0;
    barrier.dstAccessMask = to == VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL ? VK_ACCESS_TRANSFER_WRITE_BIT : VK_ACCESS_SHADER_READ_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         to == VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL ? VK_PIPELINE_STAGE_TRANSFER_BIT
                                                                    : VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT,
                         0, 0, nullptr, 0, nullptr, 1, &barrier);
}

} // namespace

Result<std::unique_ptr<Painter>> Painter::create(engine::Device& device, VkFormat format) {
    return engine::guarded([&] { return std::unique_ptr<Painter>(new Painter(device, format)); });
}

Painter::Painter(engine::Device& device, VkFormat format) : device_(device), format_(format), objects_(device) {
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    sampler_ = objects_.sampler(info);
    vertices_layout_ = make_layout(objects_, k_vertex_bindings);
    image_layout_ = make_layout(objects_, k_image_bindings);
    engine::make_sets(objects_, vertices_layout_, k_vertex_bindings, vertex_sets_);
    engine::make_sets(objects_, image_layout_, k_image_bindings, picture_sets_);
    engine::make_sets(objects_, image_layout_, k_image_bindings, std::span(&letter_set_, 1));
    const std::array layouts{vertices_layout_, image_layout_};
    layout_ = make_pipeline_layout(objects_, layouts);
    make_letters();
    make_room(1 << 15, 1 << 16);
}

void Painter::make_letters() {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    letter_extent_ = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    letter_bytes_ =
        objects_.filled(std::as_bytes(std::span(pixels, std::size_t{4} * letter_extent_.width * letter_extent_.height)),
                        VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    letters_ = objects_.image({.format = VK_FORMAT_R8G8B8A8_UNORM,
                               .extent = letter_extent_,
                               .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    point(device_, letter_set_, 0, letters_.view, sampler_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    ImGui::GetIO().Fonts->SetTexID(reinterpret_cast<ImTextureID>(std::uintptr_t{1}));
}

void Painter::upload_letters(VkCommandBuffer commands) {
    turn_image(commands, letters_.image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkBufferImageCopy whole{};
    whole.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    whole.imageExtent = {letter_extent_.width, letter_extent_.height, 1};
    vkCmdCopyBufferToImage(commands, letter_bytes_.buffer, letters_.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &whole);
    turn_image(commands, letters_.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    uploaded_ = true;
}

void Painter::make_room(std::size_t vertices, std::size_t indices) {
    if (vertices <= most_vertices_ && indices <= most_indices_)
        return;
    vkDeviceWaitIdle(device_.handle());
    room_ = std::make_unique<engine::Objects>(device_);
    most_vertices_ = std::max(vertices, 2 * most_vertices_);
    most_indices_ = std::max(indices, 2 * most_indices_);
    vertices_ = room_->frame_buffers(most_vertices_ * sizeof(ImDrawVert), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    indices_ = room_->frame_buffers(most_indices_ * sizeof(ImDrawIdx), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    for (std::size_t slot = 0; slot < k_slots; ++slot)
        point(device_, vertex_sets_[slot], 0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, vertices_[slot].buffer);
}

Result<void> Painter::match(VkExtent2D extent) {
    if (extent.width == extent_.width && extent.height == extent_.height)
        return {};
    return engine::guarded([&] {
        vkDeviceWaitIdle(device_.handle());
        auto objects = std::make_unique<engine::Objects>(device_);
        screen_ = objects->image({.format = format_,
                                  .extent = extent,
                                  .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
        const engine::Attachment colour{
            .format = format_, .view = screen_.view, .cleared = true, .end = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
        pass_.emplace(*objects, extent, std::span(&colour, 1));
        if (pipeline_ == VK_NULL_HANDLE)
            pipeline_ = make_pipeline(objects_, {.vertex = words::panel_vert,
                                                 .fragment = words::panel_frag,
                                                 .layout = layout_,
                                                 .target = {pass_->handle(), VK_SAMPLE_COUNT_1_BIT, 1, false},
                                                 .writes_depth = false,
                                                 .blends = true});
        target_objects_ = std::move(objects);
        extent_ = extent;
    });
}

Result<void> Painter::record(const engine::Frame& frame, const ImDrawData& drawn, const engine::Image& picture) {
    return engine::guarded([&] {
        make_room(static_cast<std::size_t>(drawn.TotalVtxCount), static_cast<std::size_t>(drawn.TotalIdxCount));
        const auto slot = static_cast<std::size_t>(frame.slot);
        auto* vertex = static_cast<ImDrawVert*>(vertices_[slot].mapped);
        auto* index = static_cast<ImDrawIdx*>(indices_[slot].mapped);
        for (int n = 0; n < drawn.CmdListsCount; ++n) {
            const ImDrawList& list = *drawn.CmdLists[n];
            vertex = std::copy(list.VtxBuffer.begin(), list.VtxBuffer.end(), vertex);
            index = std::copy(list.IdxBuffer.begin(), list.IdxBuffer.end(), index);
        }
        if (!uploaded_)
            upload_letters(frame.commands);
        turn_image(frame.commands, picture.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        point(device_, picture_sets_[slot], 0, picture.view, sampler_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        draw(frame, drawn);
    });
}

void Painter::draw(const engine::Frame& frame, const ImDrawData& drawn) const {
    const auto slot = static_cast<std::size_t>(frame.slot);
    const VkCommandBuffer commands = frame.commands;
    pass_->begin(commands);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    vkCmdBindIndexBuffer(commands, indices_[slot].buffer, 0,
                         sizeof(ImDrawIdx) == 2 ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32);
    const float push[4] = {2.0f / drawn.DisplaySize.x, 2.0f / drawn.DisplaySize.y,
                           -1.0f - 2.0f * drawn.DisplayPos.x / drawn.DisplaySize.x,
                           -1.0f - 2.0f * drawn.DisplayPos.y / drawn.DisplaySize.y};
    vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof push, push);
    const ImVec2 scale(static_cast<float>(extent_.width) / drawn.DisplaySize.x,
                       static_cast<float>(extent_.height) / drawn.DisplaySize.y);
    std::uint32_t first_index = 0;
    std::int32_t first_vertex = 0;
    for (int n = 0; n < drawn.CmdListsCount; ++n) {
        const ImDrawList& list = *drawn.CmdLists[n];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const ImVec4& clip = command.ClipRect;
            const int x = std::max(0, static_cast<int>((clip.x - drawn.DisplayPos.x) * scale.x));
            const int y = std::max(0, static_cast<int>((clip.y - drawn.DisplayPos.y) * scale.y));
            const int right =
                std::min(static_cast<int>(extent_.width), static_cast<int>((clip.z - drawn.DisplayPos.x) * scale.x));
            const int low = std::min(static_cast<int>(extent_.height), static_cast<int>((clip.w - drawn.DisplayPos.y) * scale.y));
            if (right <= x || low <= y || command.UserCallback != nullptr)
                continue;
            const VkRect2D area{{x, y}, {static_cast<std::uint32_t>(right - x), static_cast<std::uint32_t>(low - y)}};
            vkCmdSetScissor(commands, 0, 1, &area);
            const std::array sets{vertex_sets_[slot], command.TextureId == k_picture ? picture_sets_[slot] : letter_set_};
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 2, sets.data(), 0, nullptr);
            vkCmdDrawIndexed(commands, command.ElemCount, 1, first_index + command.IdxOffset,
                             first_vertex + static_cast<std::int32_t>(command.VtxOffset), 0);
        }
        first_index += static_cast<std::uint32_t>(list.IdxBuffer.Size);
        first_vertex += list.VtxBuffer.Size;
    }
    vkCmdEndRenderPass(commands);
}

} // namespace windrow::vegetation::view
