// Settings of a kind of tree: growth, look, and thinning with distance. Plain structs, so that a scene
// file can hold them; tree_presets.h has kinds by name.
//
// Lengths are of a tree of size 1; a place scales all of them. Angles are at the middle of their range: each limb strays by
// chance.
#pragma once

#include "../../coupling/drag.h"

#include <cstdint>
#include <glm/vec3.hpp>

namespace windrow::vegetation::trees {

/// Length of limbs by their height in the crown (Weber & Penn 1995 name these forms).
enum class CrownForm {
    cone,   ///< longest at the crown's base, a fifth at its top
    round,  ///< longest in the middle
    dome,   ///< longest at the base, falling slowly: a broad tree
    column, ///< all alike
    flame   ///< longest below the middle, pointed above
};

/// Picture of a leaf card.
enum class LeafForm {
    broad,  ///< leaves in pairs along a twig
    needles ///< a comb of needles along a twig
};

struct TreeSettings {
    float height = 10.0f;
    float trunk_radius = 0.34f;
    float trunk_wander = 0.03f;
    float crown_base = 0.24f;
    CrownForm form = CrownForm::dome;
    int limbs = 24;
    int whorl = 0;
    float limb_crowding = 1.3f;
    float limb_length = 6.2f;
    float limb_low_deg = 80.0f;
    float limb_high_deg = 30.0f;
    float limb_rise = 0.42f;
    float wander = 0.18f;
    int branches = 15;
    float branch_deg = 55.0f;
    float branch_fraction = 0.38f;
    float branch_rise = 0.1f;
    int clusters = 4;
    float cluster_length = 0.45f;
    int leaves = 5;
    float leaf_length = 0.52f;
    float leaf_width = 0.44f;
    float leaf_droop = 0.25f;
    LeafForm leaf_form = LeafForm::broad;
    float wood = 5e9f;
    std::uint32_t seed = 1;

    static constexpr auto settings() {
        return std::tuple{
            Setting("height", &TreeSettings::height, {0.3, 60.0, "m"}, "Of the tree."),
            Setting("trunk_radius", &TreeSettings::trunk_radius, {0.005, 3.0, "m"},
                    "Above the root's flare, at most a fifth of the height."),
            Setting("trunk_wander", &TreeSettings::trunk_wander, {0.0, 0.2},
                    "Deviation of the trunk from a line, over its height."),
            Setting("crown_base", &TreeSettings::crown_base, {0.0, 0.9}, "Fraction of the height where limbs begin."),
            Setting("form", &TreeSettings::form, "Length of limbs by their height in the crown."),
            Setting("limbs", &TreeSettings::limbs, {1.0, 120.0}, "Along the trunk."),
            Setting("whorl", &TreeSettings::whorl, {0.0, 12.0, "", "each at its own, turned by 137.5 degrees"},
                    "Limbs that leave the trunk at one height."),
            Setting("limb_crowding", &TreeSettings::limb_crowding, {0.3, 5.0},
                    "Above 1 limbs leave the trunk closer together toward the crown's base, 1 evenly."),
            Setting("limb_length", &TreeSettings::limb_length, {0.05, 30.0, "m"}, "Of the longest."),
            Setting("limb_low_deg", &TreeSettings::limb_low_deg, {0.0, 150.0, "deg"},
                    "Angle from straight up at the crown's base."),
            Setting("limb_high_deg", &TreeSettings::limb_high_deg, {0.0, 150.0, "deg"}, "The same at its top."),
            Setting("limb_rise", &TreeSettings::limb_rise, {-1.0, 1.0}, "Turn of limbs along their length, -1 (down) to 1 (up)."),
            Setting("wander", &TreeSettings::wander, k_fraction_range, "Crookedness of limbs and branches."),
            Setting("branches", &TreeSettings::branches, {0.0, 40.0},
                    "On the longest limb; on others in proportion to the form's length."),
            Setting("branch_deg", &TreeSettings::branch_deg, {0.0, 150.0, "deg"}, "Angle from the limb."),
            Setting("branch_fraction", &TreeSettings::branch_fraction, {0.02, 1.0}, "Longest branch over its limb."),
            Setting("branch_rise", &TreeSettings::branch_rise, {-1.0, 1.0}, "As limb_rise."),
            Setting("clusters", &TreeSettings::clusters, {1.0, 20.0},
                    "Clusters of leaves per branch; the wind acts on each separately."),
            Setting("cluster_length", &TreeSettings::cluster_length, {0.02, 3.0, "m"}, "Of the twig that holds a cluster."),
            Setting("leaves", &TreeSettings::leaves, {1.0, 16.0}, "Cards a cluster."),
            Setting("leaf_length", &TreeSettings::leaf_length, {0.01, 3.0, "m"}, "Of a card."),
            Setting("leaf_width", &TreeSettings::leaf_width, {0.005, 3.0, "m"}, "Of a card."),
            Setting("leaf_droop", &TreeSettings::leaf_droop, k_fraction_range, "Droop of twigs and cards."),
            Setting("leaf_form", &TreeSettings::leaf_form, "Picture of a leaf card."),
            Setting("wood", &TreeSettings::wood, {1e8, 5e10, "Pa"},
                    "Young's modulus, within what living trunks and branches have."),
            Setting("seed", &TreeSettings::seed, k_seed_range, "Another number, another tree of the kind."),
        };
    }
};

/// Colours are linear albedo, 0 to 1; leaf and through together at most 0.6 a channel, so that leaves give no more light than
/// they get.
struct TreeLook {
    glm::vec3 bark{0.150f, 0.118f, 0.088f};
    glm::vec3 furrow{0.045f, 0.035f, 0.026f};
    float bark_lines = 0.0f;
    glm::vec3 leaf{0.050f, 0.082f, 0.024f};
    glm::vec3 young{0.098f, 0.130f, 0.040f};
    glm::vec3 through{0.125f, 0.160f, 0.030f};
    float variation = 0.22f;
    float gloss = 18.0f;
    float against_light = 2.5f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("bark", &TreeLook::bark, k_fraction_range, "The bark."),
            Setting("furrow", &TreeLook::furrow, k_fraction_range, "Between the bark's ridges."),
            Setting("bark_lines", &TreeLook::bark_lines, k_fraction_range,
                    "0 furrows along the trunk, 1 marks across it, as a birch has."),
            Setting("leaf", &TreeLook::leaf, k_fraction_range, "The leaves."),
            Setting("young", &TreeLook::young, k_fraction_range, "The leaves at the crown's outer edge."),
            Setting("through", &TreeLook::through, k_fraction_range, "Light that shines through."),
            Setting("variation", &TreeLook::variation, {0.0, 0.9}, "Fraction by which leaves and trees are lighter or darker."),
            Setting("gloss", &TreeLook::gloss, {1.0, 1000.0}, "Exponent of the shine."),
            Setting("against_light", &TreeLook::against_light, {0.0, 20.0},
                    "Additional light that shines through against the sun."),
        };
    }
};

/// Levels of detail. Distances are for a tree of size 1.
struct TreeLevels {
    float near = 38.0f;
    float far = 240.0f;
    int far_leaves = 34;
    float growth = 0.41f;
    float min_angle = 0.0007f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("near", &TreeLevels::near, {0.1, 1e4, "m"}, "Up to which all leaves are drawn."),
            Setting("far", &TreeLevels::far, {0.1, 1e5, "m"}, "From which far_leaves are, beyond near."),
            Setting("far_leaves", &TreeLevels::far_leaves, {4.0, 1000.0},
                    "With those of 34 that fade, and the trunk, at most 200 vertices."),
            Setting("growth", &TreeLevels::growth, {0.3, 0.5},
                    "Of the leaves that stay. At 0.5 all leaves together keep their area; less, since a crown hides most of its "
                    "leaves."),
            Setting("min_angle", &TreeLevels::min_angle, {1e-5, 0.1, "rad"},
                    "Of a branch's radius, below which none is drawn: a pixel's width at 720 lines and 45 degrees."),
        };
    }
};

/// Every reason why it cannot be used, a line each: ranges, and more vertices than `k_max_vertices`.
[[nodiscard]] windrow::Result<void> validate(const TreeSettings& settings);
[[nodiscard]] windrow::Result<void> validate(const TreeLook& look);
[[nodiscard]] windrow::Result<void> validate(const TreeLevels& levels);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const TreeSettings& settings);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const TreeLook& look);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const TreeLevels& levels);

/// Vertices of a near tree, at most.
inline constexpr int k_max_vertices = 30000;
/// Of a tree beyond TreeLevels::far by the default levels, at most.
inline constexpr int k_max_far_vertices = 200;
/// Figures of such a tree.
[[nodiscard]] double vertex_bound(const TreeSettings& settings);

} // namespace windrow::vegetation::trees

template <>
inline constexpr std::array<const char*, 5> windrow::k_words<windrow::vegetation::trees::CrownForm>{"cone", "round", "dome",
                                                                                                    "column", "flame"};
template <>
inline constexpr std::array<const char*, 2> windrow::k_words<windrow::vegetation::trees::LeafForm>{"broad", "needles"};
