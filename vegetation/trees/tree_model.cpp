#include "vegetation/trees/tree_model.h"

#include "vegetation/trees/tree_numerics.h"
#include "vegetation/trees/tree_shape.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::trees {

Drawn TreeModel::drawn(const LevelBlock& levels, float distance) const {
    Drawn made;
    const bool coarse = distance >= coarse_trunk_from(levels);
    std::size_t shown = 0; // stems that have any thickness: the first ones
    while (shown < stem_radii.size() && stem_scale(levels, distance, stem_radii[shown]) > 0.0f)
        ++shown;
    const std::uint32_t stem_count = shown == 0 ? 0u : stem_ends[shown - 1];
    if (coarse) {
        made.wood = coarse_trunk;
        made.more_wood = {stems.first, stem_count};
    } else {
        made.wood = {trunk.first, trunk.count + stem_count}; // stems follow the trunk
    }
    made.vertices = (coarse ? shape::k_coarse_vertices : shape::k_trunk_vertices) + (shown == 0 ? 0u : stem_vertices[shown - 1]);

    const numerics::WindrowTreeLevels shared{levels.leaves, levels.stems};
    const float share = numerics::windrow_tree_drawn(shared, keep(levels, distance));
    const auto all = static_cast<std::uint32_t>(leaf_parts.size());
    // One more than the share, since a device's pow differs from ours in its last digits.
    const std::uint32_t kept = std::min(static_cast<std::uint32_t>(share * static_cast<float>(all)) + 1u, all);
    made.leaves = {leaves.first, 6u * kept};
    made.vertices += 4u * kept;
    made.parts = kept == 0 ? 1u : leaf_parts[kept - 1];
    return made;
}

windrow::TreePart TreeModel::part(std::uint32_t index) const {
    if (index >= parts.size())
        return {};
    const ModelPart& held = parts[index];
    return {.root = glm::vec3(held.root_reach),
            .axis = glm::vec3(held.axis_stiffness),
            .length = held.root_reach.w,
            .stiffness = held.axis_stiffness.w};
}

} // namespace windrow::vegetation::trees
