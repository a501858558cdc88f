// The ground: a grid of heights as triangles, in light and in shadow, with the waves of grass that is too far to be drawn.
#pragma once

#include "drawable.h"
#include "scene.h"

namespace windrow::vegetation::render {

class Terrain final : public Drawable {
  public:
    /// Objects of the renderer's.
    Terrain(engine::Objects& objects, const DrawTargets& targets, const Scene& scene);

    /// The heights, for set 0.
    [[nodiscard]] static engine::Buffer heights(engine::Objects& objects, const Ground& ground);
    void draw(const PassContext& context) override;

  private:
    std::uint32_t cells_x_ = 0, cells_z_ = 0;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline colour_ = VK_NULL_HANDLE, shadow_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    glm::ivec2 mask_corners_{2};
};

} // namespace windrow::vegetation::render
