#include "vegetation/trees/tree_presets.h"

#include <array>
#include <string>

namespace windrow::vegetation::trees {
namespace {

constexpr std::array<std::string_view, 4> k_names{"oak", "birch", "spruce", "bush"};

TreeKind birch() {
    TreeKind kind;
    kind.tree = {.height = 13.0f,
                 .trunk_radius = 0.13f,
                 .trunk_wander = 0.025f,
                 .crown_base = 0.22f,
                 .form = CrownForm::flame,
                 .limbs = 32,
                 .limb_crowding = 1.0f,
                 .limb_length = 3.6f,
                 .limb_low_deg = 62.0f,
                 .limb_high_deg = 24.0f,
                 .limb_rise = 0.1f,
                 .wander = 0.1f,
                 .branches = 12,
                 .branch_deg = 48.0f,
                 .branch_fraction = 0.45f,
                 .branch_rise = -0.75f,
                 .clusters = 5,
                 .cluster_length = 0.5f,
                 .leaves = 4,
                 .leaf_length = 0.46f,
                 .leaf_width = 0.3f,
                 .leaf_droop = 0.8f,
                 .seed = 11};
    kind.look = {.bark = {0.62f, 0.60f, 0.55f},
                 .furrow = {0.035f, 0.030f, 0.027f},
                 .bark_lines = 1.0f,
                 .leaf = {0.075f, 0.105f, 0.030f},
                 .young = {0.125f, 0.152f, 0.048f},
                 .through = {0.155f, 0.185f, 0.035f},
                 .variation = 0.25f};
    return kind;
}

TreeKind spruce() {
    TreeKind kind;
    kind.tree = {.height = 16.0f,
                 .trunk_radius = 0.21f,
                 .trunk_wander = 0.006f,
                 .crown_base = 0.05f,
                 .form = CrownForm::cone,
                 .limbs = 95,
                 .whorl = 5,
                 .limb_crowding = 1.0f,
                 .limb_length = 3.5f,
                 .limb_low_deg = 104.0f,
                 .limb_high_deg = 42.0f,
                 .limb_rise = 0.18f,
                 .wander = 0.06f,
                 .branches = 11,
                 .branch_deg = 52.0f,
                 .branch_fraction = 0.4f,
                 .branch_rise = -0.12f,
                 .clusters = 2,
                 .cluster_length = 0.34f,
                 .leaves = 3,
                 .leaf_length = 0.85f,
                 .leaf_width = 0.40f,
                 .leaf_droop = 0.35f,
                 .leaf_form = LeafForm::needles,
                 .seed = 21};
    kind.look = {.bark = {0.115f, 0.075f, 0.052f},
                 .furrow = {0.032f, 0.022f, 0.017f},
                 .leaf = {0.034f, 0.064f, 0.028f},
                 .young = {0.068f, 0.108f, 0.042f},
                 .through = {0.030f, 0.050f, 0.012f},
                 .variation = 0.18f,
                 .gloss = 30.0f,
                 .against_light = 1.0f};
    kind.levels = {.near = 60.0f, .growth = 0.37f};
    return kind;
}

TreeKind bush() {
    TreeKind kind;
    kind.tree = {.height = 2.6f,
                 .trunk_radius = 0.04f,
                 .trunk_wander = 0.06f,
                 .crown_base = 0.0f,
                 .form = CrownForm::dome,
                 .limbs = 22,
                 .limb_crowding = 3.2f,
                 .limb_length = 2.1f,
                 .limb_low_deg = 52.0f,
                 .limb_high_deg = 18.0f,
                 .limb_rise = 0.12f,
                 .wander = 0.16f,
                 .branches = 7,
                 .branch_deg = 45.0f,
                 .branch_fraction = 0.38f,
                 .clusters = 3,
                 .cluster_length = 0.26f,
                 .leaves = 4,
                 .leaf_length = 0.32f,
                 .leaf_width = 0.27f,
                 .leaf_droop = 0.2f,
                 .seed = 31};
    kind.look.leaf = {0.060f, 0.100f, 0.024f};
    kind.levels = {.near = 26.0f, .far = 140.0f};
    return kind;
}

} // namespace

std::span<const std::string_view> preset_names() {
    return k_names;
}

windrow::Result<TreeKind> preset(std::string_view name) {
    if (name == "oak")
        return TreeKind{};
    if (name == "birch")
        return birch();
    if (name == "spruce")
        return spruce();
    if (name == "bush")
        return bush();
    std::string known;
    for (const std::string_view each : k_names)
        known += (known.empty() ? "" : ", ") + std::string(each);
    return windrow::Error{"kind is '" + std::string(name.substr(0, 40)) + "'; give one of " + known + "."};
}

} // namespace windrow::vegetation::trees
