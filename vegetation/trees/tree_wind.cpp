#include "vegetation/trees/tree_wind.h"

#include "vegetation/trees/tree_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace windrow::vegetation::trees {
namespace {

constexpr float k_mean_radius = 0.56f;      // of a taper to an eighth, over that at the root
constexpr float k_foliage_fraction = 0.24f; // width of a limb's foliage over its length: windrow::branch()'s 0.6 m of 2.5
constexpr float k_limb_wood = 0.5f; // of the trunk's modulus: Cannell & Morgan 1987, as coupling/plant_classes.h cites them

float class_radius(const TreeSettings& s) {
    return s.trunk_radius * std::pow(s.limb_length / s.height, 1.2f);
}

} // namespace

windrow::TreeClasses wind_classes(const TreeSettings& s) {
    windrow::TreeClasses classes;
    // The crown as the wind sees it: a band as wide as its limbs reach, by the form's mean.
    float form = 0.0f;
    for (int n = 0; n < 8; ++n)
        form += shape::form_length(s.form, (static_cast<float>(n) + 0.5f) / 8.0f) / 8.0f;
    const float spread = std::max(std::sin(glm::radians(0.5f * (s.limb_low_deg + s.limb_high_deg))), 0.2f);
    const float crown = 2.0f * s.limb_length * form * spread * (1.0f - s.crown_base);
    classes.trunk.length = s.height;
    classes.trunk.width = std::clamp(crown + 2.0f * s.trunk_radius * s.crown_base, 1e-3f, 100.0f);
    classes.trunk.rigidity = std::clamp(windrow::rod_rigidity(s.wood, 2.0f * k_mean_radius * s.trunk_radius), 1e-6f, 1e12f);
    classes.branch.length = s.limb_length;
    classes.branch.width = k_foliage_fraction * s.limb_length;
    classes.branch.rigidity =
        std::clamp(windrow::rod_rigidity(k_limb_wood * s.wood, 2.0f * k_mean_radius * class_radius(s)), 1e-9f, 1e12f);
    // Twigs of any length are of one form, as stiff against the wind as the library's.
    classes.leaf = windrow::twig();
    return classes;
}

float limb_stiffness(const TreeSettings& s, float length, float radius) {
    const float slender = (s.limb_length / std::max(length, 1e-3f)) * (radius / class_radius(s));
    return std::clamp(slender * slender * slender * slender, 0.05f, 1e4f);
}

} // namespace windrow::vegetation::trees
