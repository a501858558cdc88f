// How plants look, as shaders have it: PlantLook of vegetation/shaders/render/plant_look.glsl.
#pragma once

#include "vegetation/render/scene.h"

#include <cmath>
#include <glm/vec4.hpp>

namespace windrow::vegetation::render {

/// A std140 block.
struct PlantLookBlock {
    glm::vec4 root{0.0f}, tip{0.0f}, dry{0.0f}, through{0.0f}, size{0.0f}, second{0.0f}, head{0.0f}, soil{0.0f}, shape{0.0f};

    PlantLookBlock() = default;
    explicit PlantLookBlock(const PlantLook& look)
        : root(look.root, look.root_light), tip(look.tip, look.variation), dry(look.dry, look.gloss),
          through(look.through, look.against_light), size(0.0f, look.even_from, look.dryness, look.wave),
          second(look.second, std::tan(look.fold)), head(look.head, look.head_from), soil(look.soil, 0.0f),
          shape(0.5f * look.head_width, look.self_shade, look.midrib, look.soften) {}
};
static_assert(sizeof(PlantLookBlock) == 144);

} // namespace windrow::vegetation::render
