#include "vegetation/fur/cloud_shell.h"

#include "vegetation/render/refusals.h"

namespace windrow::vegetation::fur {

windrow::Result<void> validate(const CloudShellSettings& settings) {
    render::Refusals refusals;
    const auto range = [&](const char* field, float value, double low, double high) { refusals.range(field, value, low, high); };
    range("clouds.cover", settings.cover, 0.0, 1.0);
    range("clouds.size", settings.size, 0.01, 1e5);
    range("clouds.base", settings.base, 0.01, 1.0);
    range("clouds.billow", settings.billow, 0.0, 1.0);
    refusals.range("clouds.octaves", settings.octaves, 1.0, 8.0);
    refusals.range("clouds.seed", settings.seed, 0.0, 1e6);
    range("clouds.half_size.x", settings.half_size.x, 0.01, 1e6);
    range("clouds.half_size.y", settings.half_size.y, 0.01, 1e6);
    range("clouds.fading", settings.fading, 0.01, 1e6);
    range("clouds.height", settings.height, 1e-3, 1e5);
    return refusals.result();
}

CloudShellBlock block(const CloudShellSettings& settings, glm::dvec2 drift, double evolved) {
    CloudShellBlock cloud{};
    cloud.form = {settings.cover, 1.0f / settings.size, settings.base, settings.billow};
    cloud.rim = {settings.half_size.x, settings.half_size.y, settings.fading, settings.round_rim ? 1.0f : 0.0f};
    cloud.drift = glm::vec4(glm::vec2(drift), static_cast<float>(evolved), settings.height);
    cloud.kind = {static_cast<float>(settings.octaves), static_cast<float>(settings.seed), 0.0f, 0.0f};
    return cloud;
}

} // namespace windrow::vegetation::fur
