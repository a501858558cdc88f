#include "vegetation/trees/tree_settings.h"

#include "vegetation/render/refusals.h"
#include "vegetation/trees/tree_shape.h"

#include <cmath>
#include <string>

namespace windrow::vegetation::trees {
namespace {

// Bounds as floats, so that a range's own ends are within it.
void range(render::Refusals& refusals, const char* field, float value, float low, float high) {
    refusals.range(field, static_cast<double>(value), static_cast<double>(low), static_cast<double>(high));
}

void colour(render::Refusals& refusals, const char* field, glm::vec3 value) {
    for (int channel = 0; channel < 3; ++channel)
        range(refusals, (std::string(field) + "." + "rgb"[channel]).c_str(), value[channel], 0.0f, 1.0f);
}

} // namespace

double vertex_bound(const TreeSettings& s) {
    double branches = 0.0;
    for (int limb = 0; limb < s.limbs; ++limb)
        branches += shape::branches_of(s, limb);
    return shape::k_trunk_vertices + 1.0 * s.limbs * shape::k_limb_rings * shape::k_limb_sides +
           branches * shape::k_branch_rings * shape::k_branch_sides + 4.0 * branches * s.clusters * s.leaves;
}

windrow::Result<void> validate(const TreeSettings& s) {
    render::Refusals refusals;
    range(refusals, "tree.height", s.height, 0.3f, 60.0f);
    range(refusals, "tree.trunk_radius", s.trunk_radius, 0.005f, 3.0f);
    if (s.trunk_radius > 0.2f * s.height)
        refusals.add("tree.trunk_radius is more than a fifth of tree.height; give a thinner trunk.");
    range(refusals, "tree.trunk_wander", s.trunk_wander, 0.0f, 0.2f);
    range(refusals, "tree.crown_base", s.crown_base, 0.0f, 0.9f);
    if (s.form < CrownForm::cone || s.form > CrownForm::flame)
        refusals.add("tree.form is no CrownForm; give one of its names.");
    refusals.range("tree.limbs", s.limbs, 1, 120);
    refusals.range("tree.whorl", s.whorl, 0, 12);
    range(refusals, "tree.limb_crowding", s.limb_crowding, 0.3f, 5.0f);
    range(refusals, "tree.limb_length", s.limb_length, 0.05f, 30.0f);
    range(refusals, "tree.limb_low_deg", s.limb_low_deg, 0.0f, 150.0f);
    range(refusals, "tree.limb_high_deg", s.limb_high_deg, 0.0f, 150.0f);
    range(refusals, "tree.limb_rise", s.limb_rise, -1.0f, 1.0f);
    range(refusals, "tree.wander", s.wander, 0.0f, 1.0f);
    refusals.range("tree.branches", s.branches, 0, 40);
    range(refusals, "tree.branch_deg", s.branch_deg, 0.0f, 150.0f);
    range(refusals, "tree.branch_share", s.branch_share, 0.02f, 1.0f);
    range(refusals, "tree.branch_rise", s.branch_rise, -1.0f, 1.0f);
    refusals.range("tree.clusters", s.clusters, 1, 20);
    range(refusals, "tree.cluster_length", s.cluster_length, 0.02f, 3.0f);
    refusals.range("tree.leaves", s.leaves, 1, 16);
    range(refusals, "tree.leaf_length", s.leaf_length, 0.01f, 3.0f);
    range(refusals, "tree.leaf_width", s.leaf_width, 0.005f, 3.0f);
    range(refusals, "tree.leaf_droop", s.leaf_droop, 0.0f, 1.0f);
    if (s.leaf_form < LeafForm::broad || s.leaf_form > LeafForm::needles)
        refusals.add("tree.leaf_form is no LeafForm; give one of its names.");
    range(refusals, "tree.wood", s.wood, 1e8f, 5e10f);
    if (refusals.result() && vertex_bound(s) > k_most_vertices)
        refusals.add("tree has " + std::to_string(static_cast<long>(vertex_bound(s))) + " vertices, of " +
                     std::to_string(k_most_vertices) + "; lower tree.limbs, branches, clusters or leaves.");
    return refusals.result();
}

windrow::Result<void> validate(const TreeLook& look) {
    render::Refusals refusals;
    colour(refusals, "look.bark", look.bark);
    colour(refusals, "look.furrow", look.furrow);
    range(refusals, "look.bark_lines", look.bark_lines, 0.0f, 1.0f);
    colour(refusals, "look.leaf", look.leaf);
    colour(refusals, "look.young", look.young);
    colour(refusals, "look.through", look.through);
    for (int channel = 0; channel < 3; ++channel) {
        const float through = look.through[channel] * (1.0f + 0.1f * look.against_light); // leaf_light.glsl says why
        if (std::max(look.leaf[channel], look.young[channel]) + through > 0.6f)
            refusals.add(std::string("look.leaf or look.young and look.through give more than 0.6 together in channel ") +
                         "rgb"[channel] + "; darken one of them or lower look.against_light.");
    }
    range(refusals, "look.variation", look.variation, 0.0f, 0.9f);
    range(refusals, "look.gloss", look.gloss, 1.0f, 1000.0f);
    range(refusals, "look.against_light", look.against_light, 0.0f, 20.0f);
    return refusals.result();
}

windrow::Result<void> validate(const TreeLevels& levels) {
    render::Refusals refusals;
    range(refusals, "levels.near", levels.near, 0.1f, 1e4f);
    range(refusals, "levels.far", levels.far, 0.1f, 1e5f);
    if (!(levels.far > levels.near))
        refusals.add("levels.far is not beyond levels.near; give a larger distance.");
    refusals.range("levels.far_leaves", levels.far_leaves, 4, 1000);
    range(refusals, "levels.growth", levels.growth, 0.3f, 0.5f);
    range(refusals, "levels.least_angle", levels.least_angle, 1e-5f, 0.1f);
    return refusals.result();
}

} // namespace windrow::vegetation::trees
