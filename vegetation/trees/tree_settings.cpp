#include "vegetation/trees/tree_settings.h"

#include "fluid/core/validation.h"
#include "vegetation/trees/tree_shape.h"

#include <cmath>
#include <string>

namespace windrow::vegetation::trees {

using windrow::detail::FieldPath, windrow::detail::Reasons, windrow::detail::validate_settings;

double vertex_bound(const TreeSettings& s) {
    double branches = 0.0;
    for (int limb = 0; limb < s.limbs; ++limb)
        branches += shape::branches_of(s, limb);
    return shape::k_trunk_vertices + 1.0 * s.limbs * shape::k_limb_rings * shape::k_limb_sides +
           branches * shape::k_branch_rings * shape::k_branch_sides + 4.0 * branches * s.clusters * s.leaves;
}

windrow::Result<void> validate(const TreeSettings& settings) {
    return validate_settings(settings, "tree");
}
windrow::Result<void> validate(const TreeLook& look) {
    return validate_settings(look, "look");
}
windrow::Result<void> validate(const TreeLevels& levels) {
    return validate_settings(levels, "levels");
}

void check_rules(Reasons& reasons, const FieldPath& path, const TreeSettings& s) {
    if (s.trunk_radius > 0.2f * s.height && s.height > 0.0f)
        reasons.add(FieldPath{&path, "trunk_radius"}, " is ", s.trunk_radius, " m: give at most a fifth of ",
                    FieldPath{&path, "height"}, ", which is ", s.height, " m.");
    if (reasons.empty() && vertex_bound(s) > k_max_vertices)
        reasons.add(path, " has ", static_cast<long>(vertex_bound(s)), " vertices, of ", k_max_vertices, ": give fewer ",
                    FieldPath{&path, "limbs"}, ", branches, clusters or leaves.");
}

void check_rules(Reasons& reasons, const FieldPath& path, const TreeLook& look) {
    for (int channel = 0; channel < 3; ++channel) {
        const float through = look.through[channel] * (1.0f + 0.1f * look.against_light); // leaf_light.glsl says why
        const float together = std::max(look.leaf[channel], look.young[channel]) + through;
        if (together > 0.6f)
            reasons.add(FieldPath{&path, "leaf"}, " or young and through give ", together, " together in channel ",
                        std::string_view("rgb").substr(static_cast<std::size_t>(channel), 1),
                        ": give at most 0.6, by a darker one or a lower against_light.");
    }
}

void check_rules(Reasons& reasons, const FieldPath& path, const TreeLevels& levels) {
    if (!(levels.far > levels.near))
        reasons.add(FieldPath{&path, "far"}, " is ", levels.far, " m: give more than ", FieldPath{&path, "near"}, ", which is ",
                    levels.near, " m.");
}

} // namespace windrow::vegetation::trees
