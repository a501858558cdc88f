#include "coupling/shell.h"

#include "coupling/shell_numerics.h"
#include "fluid/core/validation.h"

#include <cmath>

namespace windrow {
using detail::shared;

Result<void> validate(const ShellSettings& settings) {
    return detail::validate_settings(settings, "shells");
}

void check_settings(detail::Reasons& reasons, const detail::FieldPath& path, const ShellSettings& settings) {
    ShellSettings judged = settings;
    judged.strand.length = Drag{}.length;
    detail::check_settings(reasons, path, judged);
}

Result<Shells> Shells::create(const ShellSettings& settings) {
    if (auto valid = validate(settings); !valid)
        return valid.failure();
    return Shells(settings);
}

Shells::Shells(const ShellSettings& settings) : settings_(settings) {
    settings_.strand.length = settings.length;
    const int divisor = settings.reaches_tip ? settings.shells - 1 : settings.shells;
    block_.form = {settings.length, settings.spacing, settings.bias, static_cast<float>(divisor)};
    block_.push = {settings.push, settings.push_exponent, settings.droop, numerics::log(settings.droop_shape)};
    block_.sag = glm::vec4(glm::vec3(glm::normalize(glm::dvec3(settings.down))), settings.sag);
    block_.drag = windrow::block(settings_.strand);
}

float Shells::height(int shell) const {
    return numerics::windrow_shell_height(shared(block_), static_cast<float>(shell));
}

glm::vec3 Shells::load(glm::vec3 normal, float map, glm::vec3 wind) const {
    return numerics::windrow_shell_load(shared(block_), normal, map, wind);
}

glm::vec3 Shells::bent(glm::vec3 position, glm::vec3 normal, float h, float map, glm::vec3 load) const {
    return numerics::windrow_shell_bent(shared(block_), position, normal, h, map, load);
}

glm::vec3 Shells::translated(glm::vec3 position, glm::vec3 normal, float h, float map, glm::vec3 direction) const {
    return numerics::windrow_shell_translated(shared(block_), position, normal, h, map, direction);
}

} // namespace windrow
