// Moving solid bodies, such as a person or a fan. Each has a shape and, per frame, a placement of each of its parts.
//
//     auto bodies = render::Bodies::create(device, renderer->draw_targets(), std::array{render::fan_blades(0.8f)});
//     renderer->add(**bodies);
//     (*bodies)->place(0, glm::translate(glm::mat4(1.0f), feet));      // before the renderer's recording, each frame
#pragma once

#include "../vulkan/frames.h"
#include "drawable.h"
#include "solids.h"

#include <array>

namespace windrow::vegetation::render {

class Bodies final : public Drawable {
  public:
    /// `copies` bodies of each shape, one after another; at least one triangle in all. They stand at the anchor until they are placed.
    [[nodiscard]] static Result<std::unique_ptr<Bodies>> create(engine::Device& device, const DrawTargets& targets,
                                                                std::span<const Solid> shapes, std::size_t copies = 1);

    /// From the shape's own positions to positions relative to the anchor, from the next frame on; motion vectors are taken
    /// from the place before.
    void place(std::size_t body, const glm::mat4& placed) { place(body, 0, placed); }
    /// The same for one part of the shape (SolidVertex::position).
    void place(std::size_t body, std::size_t part, const glm::mat4& placed);
    Result<void> prepare(const PassContext& context) override;
    void draw(const PassContext& context) override;

  private:
    /// SolidPlace of vegetation/shaders/render/solid.glsl.
    struct Place {
        glm::mat4 now{1.0f}, before{1.0f};
    };
    struct Indices {
        std::uint32_t first = 0, count = 0;
        std::uint32_t first_place = 0;
    };

    Bodies(engine::Device& device, const DrawTargets& targets, std::span<const Solid> shapes, std::size_t copies);

    engine::Objects objects_;
    std::vector<Indices> ranges_{};
    std::vector<Place> places_{}; ///< of all parts, body by body
    std::vector<bool> placed_{};
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline colour_ = VK_NULL_HANDLE, shadow_ = VK_NULL_HANDLE;
    std::array<VkDescriptorSet, engine::k_frames_in_flight> sets_{};
    engine::FrameBuffers blocks_{};
};

} // namespace windrow::vegetation::render
