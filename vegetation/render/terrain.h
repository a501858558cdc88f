// The ground: a grid of heights as triangles, in light and in shadow, with the waves of grass that is too far to be drawn.
#pragma once

#include "drawable.h"
#include "noise_map.h"
#include "scene.h"
#include "terrain_tiles.h"

#include <array>

namespace windrow::vegetation::render {

class Terrain final : public Drawable {
  public:
    /// Objects of the renderer's. `map_texels` is Quality::ground_texels, `front_first` RenderSettings::draft.
    Terrain(engine::Objects& objects, const DrawTargets& targets, const Scene& scene, int map_texels, bool front_first = false);

    /// The heights, for set 0.
    [[nodiscard]] static engine::Buffer heights(engine::Objects& objects, const Ground& ground);
    Result<void> prepare(const PassContext& context) override;
    void draw(const PassContext& context) override;
    /// What the last prepared frame draws: of the picture, of the near and of the far shadow.
    [[nodiscard]] const std::array<TerrainTiles::Draws, 3>& draws() const { return draws_; }

  private:
    TerrainTiles tiles_;
    NoiseMap map_;
    std::array<TerrainTiles::Draws, 3> draws_{};
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline colour_ = VK_NULL_HANDLE, shadow_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    glm::ivec2 mask_corners_{2};
    bool front_first_;
};

} // namespace windrow::vegetation::render
