// All that describes a kind of tree: how it grows, how it looks, how it thins out with distance. Plain structs, so that a scene
// file can hold them; tree_presets.h has kinds by name.
//
// Lengths are of a tree of size 1; a place scales all of them. Angles are at the middle of their range: each limb strays by
// chance.
#pragma once

#include "fluid/result.h"

#include <cstdint>
#include <glm/vec3.hpp>

namespace windrow::vegetation::trees {

/// How long limbs are by their height in the crown (Weber & Penn 1995 name these forms).
enum class CrownForm {
    cone,   ///< longest at the crown's base, a fifth at its top
    round,  ///< longest in the middle
    dome,   ///< longest at the base, falling slowly: a broad tree
    column, ///< all alike
    flame   ///< longest below the middle, pointed above
};

/// What a leaf card shows.
enum class LeafForm {
    broad,  ///< leaves in pairs along a twig
    needles ///< a comb of needles along a twig
};

struct TreeSettings {
    float height = 10.0f;       ///< [m] 0.3 to 60
    float trunk_radius = 0.34f; ///< [m] above the root's flare, 0.005 to 3, at most a fifth of the height
    float trunk_wander = 0.03f; ///< how far the trunk strays from a line, over its height, 0 to 0.2
    float crown_base = 0.24f;   ///< share of the height where limbs begin, 0 to 0.9
    CrownForm form = CrownForm::dome;
    int limbs = 24; ///< 1 to 120, along the trunk
    int whorl = 0;  ///< limbs that leave the trunk at one height, 0 to 12; 0: each at its own, turned by 137.5 degrees
    float limb_crowding = 1.3f;   ///< 0.3 to 5: above 1 limbs leave the trunk closer together toward the crown's base, 1 evenly
    float limb_length = 6.2f;     ///< [m] of the longest, 0.05 to 30
    float limb_low_deg = 80.0f;   ///< angle from straight up at the crown's base, 0 to 150
    float limb_high_deg = 30.0f;  ///< the same at its top, 0 to 150
    float limb_rise = 0.42f;      ///< how limbs turn along their way, -1 (down) to 1 (up)
    float wander = 0.18f;         ///< how crooked limbs and branches are, 0 to 1
    int branches = 15;            ///< on the longest limb, 0 to 40; on others in proportion to the form's length
    float branch_deg = 55.0f;     ///< angle from the limb, 0 to 150
    float branch_share = 0.38f;   ///< longest branch over its limb, 0.02 to 1
    float branch_rise = 0.1f;     ///< as limb_rise
    int clusters = 4;             ///< of leaves, a branch, 1 to 20; each feels its own wind
    float cluster_length = 0.45f; ///< [m] of the twig that holds a cluster, 0.02 to 3
    int leaves = 5;               ///< cards a cluster, 1 to 16
    float leaf_length = 0.52f;    ///< [m] of a card, 0.01 to 3
    float leaf_width = 0.44f;     ///< [m] of a card, 0.005 to 3
    float leaf_droop = 0.25f;     ///< how much twigs and cards hang, 0 to 1
    LeafForm leaf_form = LeafForm::broad;
    float wood = 5e9f;      ///< [Pa] Young's modulus, 1e8 to 5e10. Default: within what living trunks and branches have
    std::uint32_t seed = 1; ///< another number, another tree of the kind
};

/// Colours are linear albedo, 0 to 1; leaf and through together at most 0.6 a channel, so that leaves give no more light than
/// they get.
struct TreeLook {
    glm::vec3 bark{0.150f, 0.118f, 0.088f};
    glm::vec3 furrow{0.045f, 0.035f, 0.026f}; ///< between the bark's ridges
    float bark_lines = 0.0f;                  ///< 0 furrows along the trunk, 1 marks across it, as a birch has
    glm::vec3 leaf{0.050f, 0.082f, 0.024f};
    glm::vec3 young{0.098f, 0.130f, 0.040f};   ///< at the crown's rim
    glm::vec3 through{0.125f, 0.160f, 0.030f}; ///< light that shines through
    float variation = 0.22f;                   ///< share by which leaves and trees are lighter or darker, 0 to 0.9
    float gloss = 18.0f;                       ///< exponent, 1 to 1000
    float against_light = 2.5f;                ///< how much more shines through against the light, 0 to 20
};

/// What a tree costs afar. Distances are for a tree of size 1.
struct TreeLevels {
    float near = 38.0f;  ///< [m] up to which all leaves are drawn, 0.1 to 1e4
    float far = 240.0f;  ///< [m] from which `far_leaves` are, beyond near, up to 1e5
    int far_leaves = 34; ///< 4 to 1000. Default 34: with those that fade, and the trunk, at most 200 vertices
    /// Growth of the leaves that stay, 0.3 to 0.5: at 0.5 all leaves together keep their area; less, since a crown hides most of
    /// its leaves.
    float growth = 0.41f;
    /// [rad] of a branch's radius, below which none is drawn; 1e-5 to 0.1. Default: a pixel's width at 720 lines and 45 degrees.
    float least_angle = 0.0007f;
};

/// Every reason why it cannot be used, a line each: ranges, and more vertices than `k_most_vertices`.
[[nodiscard]] windrow::Result<void> validate(const TreeSettings& settings);
[[nodiscard]] windrow::Result<void> validate(const TreeLook& look);
[[nodiscard]] windrow::Result<void> validate(const TreeLevels& levels);

/// Vertices of a near tree, at most.
inline constexpr int k_most_vertices = 30000;
/// Of a tree beyond TreeLevels::far by the default levels, at most.
inline constexpr int k_most_far_vertices = 200;
/// What such a tree has.
[[nodiscard]] double vertex_bound(const TreeSettings& settings);

} // namespace windrow::vegetation::trees
