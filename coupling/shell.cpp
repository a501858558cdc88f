#include "coupling/shell.h"

#include "coupling/checks.h"
#include "coupling/shell_numerics.h"

#include <cmath>

namespace windrow {
using detail::shared;

Result<void> validate(const ShellSettings& settings) {
    detail::Checks checks("shells");
    checks.at_least(".shells", settings.shells, 2, 4096);
    checks.between(".length", settings.length, 1e-6f, 100.0f, "m");
    checks.above_zero(".spacing", settings.spacing, 10.0f, "");
    checks.between(".bias", settings.bias, 0.0f, 1.0f, "");
    checks.between(".push", settings.push, -100.0f, 100.0f, "m");
    checks.above_zero(".push_exponent", settings.push_exponent, 10.0f, "");
    checks.between(".droop", settings.droop, 0.0f, 100.0f, "m");
    checks.between(".droop_shape", settings.droop_shape, 1e-3f, 1e3f, "");
    checks.between(".sag", settings.sag, 0.0f, 1.5707964f, "rad");
    checks.direction(".down", settings.down);
    Drag strand = settings.strand;
    strand.length = Drag{}.length; // it is replaced by the shells' own, which is judged above
    checks.add(validate(strand, "shells.strand"));
    return checks.outcome();
}

Result<Shells> Shells::create(const ShellSettings& settings) {
    if (auto valid = validate(settings); !valid)
        return Error{valid.error()};
    return Shells(settings);
}

Shells::Shells(const ShellSettings& settings) : settings_(settings) {
    settings_.strand.length = settings.length;
    const int divisor = settings.reaches_tip ? settings.shells - 1 : settings.shells;
    block_.form = {settings.length, settings.spacing, settings.bias, static_cast<float>(divisor)};
    block_.push = {settings.push, settings.push_exponent, settings.droop,
                   static_cast<float>(std::log(static_cast<double>(settings.droop_shape)))};
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
