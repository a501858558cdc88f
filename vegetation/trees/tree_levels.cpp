#include "vegetation/trees/tree_levels.h"

#include "vegetation/trees/tree_numerics.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::trees {
namespace {

constexpr float k_band = 0.25f; // share of the kept leaves that are shrinking beside them

constexpr float k_coarse_from = 0.9f; // of `far`, where the bound on vertices holds

numerics::WindrowTreeLevels shared(const LevelBlock& block) {
    return {block.leaves, block.stems};
}

} // namespace

LevelBlock level_block(const TreeLevels& levels, int leaves) {
    const float least = std::min(static_cast<float>(levels.far_leaves) / static_cast<float>(leaves), 1.0f);
    const float power = least < 1.0f ? std::log(1.0f / least) / std::log(levels.far / levels.near) : 0.0f;
    return {.leaves = {levels.near, power, least, k_band},
            .stems = {levels.min_angle, levels.far, levels.growth, k_coarse_from * levels.far}};
}

float keep(const LevelBlock& levels, float distance) {
    return numerics::windrow_tree_keep(shared(levels), distance);
}

float leaf_scale(const LevelBlock& levels, float distance, float rank) {
    return numerics::windrow_leaf_scale(shared(levels), keep(levels, distance), rank);
}

float stem_scale(const LevelBlock& levels, float distance, float radius) {
    return numerics::windrow_stem_scale(shared(levels), distance, radius);
}

float coarse_trunk_from(const LevelBlock& levels) {
    return levels.stems.w;
}

float trunk_morph(const LevelBlock& levels, float distance) {
    return numerics::windrow_trunk_morph(shared(levels), distance);
}

} // namespace windrow::vegetation::trees
