// Shader blocks of a stand of trees, laid out as in vegetation/shaders/trees/tree_parts.glsl.
#pragma once

#include "../../coupling/motion_blocks.h"
#include "../../coupling/tree.h"
#include "tree_levels.h"

#include <glm/vec4.hpp>

namespace windrow::vegetation::trees {

/// A uniform block of std140 layout.
struct StandBlock {
    windrow::TreeBlock wind{};
    LevelBlock levels{};
    windrow::SpringBlock trunk_spring{}, limb_springs[4]{}, twig_springs[4]{};
    windrow::FlutterBlock flutter{};
    glm::uvec4 clock{0u}; ///< x number of the frame, y 1: springs, z samples a pixel, w 1: needles
    glm::vec4 bark{0.0f}, furrow{0.0f}, leaf{0.0f}, young{0.0f}, through{0.0f};
};
static_assert(sizeof(StandBlock) == 48 + 32 + 9 * 32 + 48 + 16 + 5 * 16);

/// A tree's place (std430).
struct PlaceBlock {
    glm::vec4 base{0.0f}; ///< xyz [m] from the anchor; w size
    glm::vec4 turn{0.0f}; ///< x, y cosine and sine of its yaw; z its own chance, -1 to 1
    glm::uvec4 first{0u}; ///< x its model's first part; y its first state; z parts of trunk and limbs
};

/// [rad] How a part of a tree is bent (std430). xyz each.
struct PartState {
    glm::vec4 now{0.0f};      ///< w bits of the number of the frame that made it
    glm::vec4 before{0.0f};   ///< in the last frame; w [m/s] wind of then
    glm::vec4 velocity{0.0f}; ///< [rad/s] of its spring; w [m/s] wind
    glm::vec4 target{0.0f};   ///< what the wind holds
};

} // namespace windrow::vegetation::trees
