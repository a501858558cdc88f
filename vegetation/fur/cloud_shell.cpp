#include "vegetation/fur/cloud_shell.h"

#include "fluid/core/validation.h"

namespace windrow::vegetation::fur {

windrow::Result<void> validate(const CloudShellSettings& settings) {
    return windrow::detail::validate_settings(settings, "clouds");
}

void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const CloudShellSettings& settings) {
    windrow::detail::check_value(reasons, {&path, "half_size"}, settings.half_size, {0.01, 1e6, "m"});
    windrow::detail::check_value(reasons, {&path, "height"}, settings.height, {1e-3, 1e5, "m"});
}

CloudShellBlock block(const CloudShellSettings& settings, glm::dvec2 drift, double evolved) {
    CloudShellBlock cloud{};
    cloud.form = {settings.cover, 1.0f / settings.size, settings.base, settings.billow};
    cloud.rim = {settings.half_size.x, settings.half_size.y, settings.fading, settings.round_rim ? 1.0f : 0.0f};
    cloud.drift = glm::vec4(glm::vec2(drift), static_cast<float>(evolved), settings.height);
    cloud.kind = {static_cast<float>(settings.octaves), static_cast<float>(settings.seed), settings.soft, 0.0f};
    return cloud;
}

} // namespace windrow::vegetation::fur
