#include "coupling/ground_config.h"

#include "fluid/core/validation.h"

#include <cmath>

namespace windrow {
namespace {

bool level_finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.z);
}

} // namespace

Result<void> validate(const GroundConfig& config) {
    return detail::validate_settings(config, "ground");
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const GroundConfig& config) {
    const float quarter = 0.25f * static_cast<float>(config.texels) * config.texel_size;
    if (config.blend_width > quarter)
        reasons.add(detail::FieldPath{&path, "blend_width"}, " is ", config.blend_width,
                    " m: give at most a quarter of the window, ", quarter, " m.");
}

Result<void> validate(const GroundWalker& walker) {
    detail::Reasons reasons;
    if (!level_finite(walker.position))
        reasons.add("GroundWalker::position is ", walker.position, ": give finite x and z.");
    if (!level_finite(walker.previous))
        reasons.add("GroundWalker::previous is ", walker.previous, ": give finite x and z.");
    if (!std::isfinite(walker.foot_height))
        reasons.add("GroundWalker::foot_height is ", walker.foot_height, " m: give a finite height.");
    if (!std::isfinite(walker.previous_foot_height))
        reasons.add("GroundWalker::previous_foot_height is ", walker.previous_foot_height, " m: give a finite height.");
    if (!(walker.radius > 0.0f) || !(walker.radius <= 100.0f))
        reasons.add("GroundWalker::radius is ", walker.radius, " m: give more than 0, at most 100.");
    if (!k_fraction_range.holds(walker.weight))
        reasons.add("GroundWalker::weight is ", walker.weight, ": give 0 to 1.");
    return reasons.outcome();
}

} // namespace windrow
