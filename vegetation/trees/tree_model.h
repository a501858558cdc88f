// A tree as triangles at rest, with the part that bears each vertex: what a device draws, in the order in which it thins out.
//
// Indices:  [ coarse trunk | trunk | stems, the thickest first | leaves, by rank ]
// A tree at a distance draws a trunk, the first stems and the first leaves: what it leaves out stands at the end of its list.
// Bearers: the trunk bears all. A limb and its branches are one part: branches are carried by their limb's mesh. Twigs with their
// leaf cards are the third part, held where they leave their branch.
#pragma once

#include "../../coupling/tree.h"
#include "tree_levels.h"
#include "tree_settings.h"

#include <glm/vec4.hpp>
#include <vector>

namespace windrow::vegetation::trees {

/// TreeVertex of vegetation/shaders/trees/tree_parts.glsl (std430).
struct ModelVertex {
    glm::vec4 position{0.0f}; ///< xyz [m] from the trunk's base; w leaves: rank, 0 to 1; wood: radius of its stem [m]
    glm::vec4 normal{0.0f};   ///< xyz unit; w leaves: along the card, 0 to 1; wood: around the stem, 0 to 1 and back
    glm::vec4 centre{0.0f};   ///< xyz [m] what it shrinks to or grows from; w leaves: across, -1 to 1; wood: [m] along the stem
    glm::vec4 open{0.0f};     ///< the fit of crown_light.h
    /// xyz [m] leaves: from its centre to the middle of those it stands for afar; trunk: to the coarse trunk
    glm::vec4 home{0.0f};
    /// x limb, y twig, or TreePartIndices::k_none; z bits of a chance, -1 to 1; w bits of a card's length [m], 0: wood
    glm::uvec4 parts{0u};
};
static_assert(sizeof(ModelVertex) == 96);

/// A windrow::TreePart as shaders have it.
struct ModelPart {
    glm::vec4 root_reach{0.0f};     ///< xyz [m], w [m] its length
    glm::vec4 axis_stiffness{0.0f}; ///< xyz unit, w over its class
};
static_assert(sizeof(ModelPart) == 32);

struct IndexRange {
    std::uint32_t first = 0, count = 0;
};

/// Drawn parts of a tree at a distance.
struct Drawn {
    IndexRange wood{}, more_wood{}, leaves{}; ///< more_wood: stems beside the coarse trunk, where any are left
    std::uint32_t vertices = 0;               ///< that these name
    std::uint32_t parts = 0;                  ///< the first ones, which bear them
};

struct TreeModel {
    std::vector<ModelVertex> vertices{};
    std::vector<std::uint32_t> indices{};
    std::vector<ModelPart> parts{}; ///< 0 the trunk, then limbs, then twigs in the order in which leaves need them
    IndexRange coarse_trunk{}, trunk{}, stems{}, leaves{};
    std::vector<float> stem_radii{};            ///< [m] one a stem, in its order
    std::vector<std::uint32_t> stem_ends{};     ///< indices up to the end of each
    std::vector<std::uint32_t> stem_vertices{}; ///< vertices up to the end of each
    std::vector<std::uint32_t> leaf_parts{};    ///< parts that the leaves up to this one need
    glm::vec3 middle{0.0f};                     ///< [m] of the ball that holds the tree at rest
    float radius = 1.0f;                        ///< [m] of that ball
    float wind_reach = 1.0f;                    ///< [m] how far beyond the ball the wind may bend it: its height

    /// Drawn parts at a distance [m] over the tree's size.
    [[nodiscard]] Drawn drawn(const LevelBlock& levels, float distance) const;
    /// As windrow::Tree has them.
    [[nodiscard]] windrow::TreePart part(std::uint32_t index) const;
};

/// The model of a tree. Rejects what `validate` rejects.
[[nodiscard]] windrow::Result<TreeModel> build(const TreeSettings& settings);

} // namespace windrow::vegetation::trees
