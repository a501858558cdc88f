// Map of what the clouds leave of the sun about the eye, drawn once a frame for all that is lit (shaders/render/cloud_map.glsl).
#pragma once

#include "drawn_map.h"
#include "frame_block.h"

namespace windrow::vegetation::render {

class CloudMap {
  public:
    /// [1] Cells of the noise along the map: twice the size of the largest lumps to each side of the eye, 1400 m by default.
    static constexpr float k_cells = 4.0f;

    /// A map of `texels` a side; of 0: a texel that nothing reads.
    CloudMap(engine::Objects& objects, int texels);
    /// Once the frame's layouts are made. Set 0 is the frame's.
    void make(engine::Objects& objects, VkPipelineLayout layout);

    /// ViewBlock::cloud_map about an eye. The map's texels stay where they are in the clouds: nothing swims as the eye moves.
    [[nodiscard]] glm::vec4 block(const CloudBlock& clouds, const SkyBlock& sky, glm::vec3 eye) const;
    /// Drawn before all that is lit.
    [[nodiscard]] const DrawnMap& map() const { return map_; }

  private:
    int texels_ = 0;
    DrawnMap map_;
};

} // namespace windrow::vegetation::render
