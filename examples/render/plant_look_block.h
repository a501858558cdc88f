// How plants look, as shaders have it: PlantLook of shaders/render/plant_look.glsl.
#pragma once

#include "examples/render/scene.h"

#include <glm/vec4.hpp>

namespace render {

/// A std140 block.
struct PlantLookBlock {
    glm::vec4 root{0.0f}, tip{0.0f}, dry{0.0f}, through{0.0f}, size{0.0f};

    PlantLookBlock() = default;
    explicit PlantLookBlock(const PlantLook& look)
        : root(look.root, look.root_light), tip(look.tip, look.variation), dry(look.dry, look.gloss),
          through(look.through, look.against_light), size(0.0f, look.even_from, 0.0f, 0.0f) {}
};
static_assert(sizeof(PlantLookBlock) == 80);

} // namespace render
