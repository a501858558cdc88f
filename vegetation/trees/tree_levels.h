// The levels of a kind of tree, as shaders have them.
#pragma once

#include "tree_settings.h"

#include <glm/vec4.hpp>

namespace windrow::vegetation::trees {

/// WindrowTreeLevels of vegetation/shaders/numerics/tree_levels.glsl, a std140 block.
struct LevelBlock {
    glm::vec4 leaves{1.0f, 1.0f, 1.0f, 0.25f};
    glm::vec4 stems{1e-3f, 1.0f, 0.5f, 0.9f};
};
static_assert(sizeof(LevelBlock) == 32);

/// Of valid levels, for trees with so many leaf cards, at least 1.
[[nodiscard]] LevelBlock level_block(const TreeLevels& levels, int leaves);
/// Fraction of the leaves at full size at a distance [m].
[[nodiscard]] float keep(const LevelBlock& levels, float distance);
/// A leaf's size by its rank, and a stem's thickness, over that of the near tree; the trunk, a radius below 0, stays.
[[nodiscard]] float leaf_scale(const LevelBlock& levels, float distance, float rank);
[[nodiscard]] float stem_scale(const LevelBlock& levels, float distance, float radius);
/// [m] Where the coarse trunk takes over: by then the fine one has become the same surface.
[[nodiscard]] float coarse_trunk_from(const LevelBlock& levels);
/// Blend factor from the fine trunk to the coarse one, 0 to 1.
[[nodiscard]] float trunk_morph(const LevelBlock& levels, float distance);

} // namespace windrow::vegetation::trees
