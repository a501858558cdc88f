// Draws Dear ImGui's lists, and the scene's picture among them, into an image of the window's size.
//
//     auto painter = view::Painter::create(device, window.format());
//     ImGui::GetBackgroundDrawList()->AddImage(view::k_picture, {0, 0}, ImGui::GetIO().DisplaySize);
//     ImGui::Render();
//     (void)(*painter)->record(frame, *ImGui::GetDrawData(), extent, picture);
//     window.copy(frame.commands, target, (*painter)->screen());
//
// By our own calls of Vulkan: ImGui's backend links the loader, which this project opens at run time.
#pragma once

#include "vegetation/vulkan/frames.h"
#include "vegetation/vulkan/render_pass.h"

#include <imgui.h>
#include <memory>
#include <optional>

namespace windrow::vegetation::view {

/// ImGui's name of the scene's picture.
inline const ImTextureID k_picture = reinterpret_cast<ImTextureID>(std::uintptr_t{2});

class Painter {
  public:
    /// Of the current ImGui context, whose letters it takes.
    [[nodiscard]] static Result<std::unique_ptr<Painter>> create(engine::Device& device, VkFormat format);

    /// Makes the image of this size where it has another. Nothing is in flight then.
    [[nodiscard]] Result<void> match(VkExtent2D extent);
    /// Outside of a render pass. `picture` is in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, as the renderer leaves it, and remains
    /// readable by shaders.
    [[nodiscard]] Result<void> record(const engine::Frame& frame, const ImDrawData& drawn, const engine::Image& picture);
    /// In VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL.
    [[nodiscard]] VkImage screen() const { return screen_.image; }

  private:
    Painter(engine::Device& device, VkFormat format);
    void make_letters();
    void upload_letters(VkCommandBuffer commands);
    void make_room(std::size_t vertices, std::size_t indices);
    void draw(const engine::Frame& frame, const ImDrawData& drawn) const;

    static constexpr std::size_t k_slots = engine::k_frames_in_flight;

    engine::Device& device_;
    VkFormat format_;
    VkExtent2D extent_{};
    engine::Objects objects_;
    std::unique_ptr<engine::Objects> target_objects_{}, room_{};
    engine::Image screen_{}, letters_{};
    engine::Buffer letter_bytes_{};
    VkExtent2D letter_extent_{};
    bool uploaded_ = false;
    std::optional<engine::RenderPass> pass_{};
    VkSampler sampler_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout vertices_layout_ = VK_NULL_HANDLE, image_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
    std::array<VkDescriptorSet, k_slots> vertex_sets_{}, picture_sets_{};
    VkDescriptorSet letter_set_ = VK_NULL_HANDLE;
    engine::FrameBuffers vertices_{}, indices_{};
    std::size_t most_vertices_ = 0, most_indices_ = 0;
};

} // namespace windrow::vegetation::view
