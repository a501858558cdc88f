#include "coupling/ground_config.h"

#include "fluid/message.h"

#include <cmath>

namespace windrow {
namespace {

template <class Number>
void ask(detail::Reasons& reasons, const char* name, Number value, Number low, Number high, const char* unit) {
    if (!(value >= low) || !(value <= high))
        reasons.add(name, " is ", value, unit, ": give ", low, " to ", high, ".");
}

bool level_finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.z);
}

} // namespace

Result<void> validate(const GroundConfig& config) {
    detail::Reasons reasons;
    ask(reasons, "GroundConfig::texels", config.texels, 8, 512, "");
    ask(reasons, "GroundConfig::texel_size", config.texel_size, 0.01f, 100.0f, " m");
    if (auto spring = validate(config.spring); !spring)
        reasons.add(spring.error());
    ask(reasons, "GroundConfig::push", config.push, 0.0f, 2.5f, " rad");
    ask(reasons, "GroundConfig::trail_share", config.trail_share, 0.0f, 1.0f, "");
    ask(reasons, "GroundConfig::trail_time", config.trail_time, 0.01f, 1e6f, " s");
    ask(reasons, "GroundConfig::trample_time", config.trample_time, 0.01f, 1e6f, " s");
    ask(reasons, "GroundConfig::clearance", config.clearance, 0.001f, 100.0f, " m");
    ask(reasons, "GroundConfig::rim", config.rim, 0.001f, 0.25f * static_cast<float>(config.texels) * config.texel_size, " m");
    ask(reasons, "GroundConfig::longest_stride", config.longest_stride, 0.01f, 1e4f, " m");
    ask(reasons, "GroundConfig::most_walkers", config.most_walkers, 1, 256, "");
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

Result<void> validate(const GroundWalker& walker) {
    detail::Reasons reasons;
    if (!level_finite(walker.position))
        reasons.add("GroundWalker::position is ", walker.position, ": give finite x and z.");
    if (!level_finite(walker.previous))
        reasons.add("GroundWalker::previous is ", walker.previous, ": give finite x and z.");
    if (!std::isfinite(walker.feet))
        reasons.add("GroundWalker::feet is ", walker.feet, " m: give a finite height.");
    if (!std::isfinite(walker.previous_feet))
        reasons.add("GroundWalker::previous_feet is ", walker.previous_feet, " m: give a finite height.");
    if (!(walker.radius > 0.0f) || !(walker.radius <= 100.0f))
        reasons.add("GroundWalker::radius is ", walker.radius, " m: give more than 0, at most 100.");
    ask(reasons, "GroundWalker::weight", walker.weight, 0.0f, 1.0f, "");
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

} // namespace windrow
