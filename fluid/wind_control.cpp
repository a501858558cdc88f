// The calls of WindControl, each to the core of a wind, and those of WindReader that follow from its others.
#include "fluid/wind_control.h"

#include "fluid/core/wind_core.h"
#include "fluid/wind_reader.h"

#include <algorithm>

namespace windrow {

Motors& WindControl::motors() {
    return core().motors;
}
const Motors& WindControl::motors() const {
    return core().motors;
}
Obstacles& WindControl::obstacles() {
    return core().obstacles;
}
const Obstacles& WindControl::obstacles() const {
    return core().obstacles;
}
DragField& WindControl::drag() {
    return core().drag;
}
const DragField& WindControl::drag() const {
    return core().drag;
}
Result<void> WindControl::set_ambient(glm::vec3 ambient) {
    return core().set_ambient(ambient);
}
glm::vec3 WindControl::ambient() const {
    return core().mean_wind();
}
Result<void> WindControl::set_gusts(const Gusts& gusts) {
    return core().set_gusts(gusts);
}
Result<void> WindControl::set_boundaries(const Boundaries& boundaries) {
    return core().set_boundaries(boundaries);
}
Result<void> WindControl::follow(glm::dvec3 point) {
    return core().follow(point);
}
Result<void> WindControl::set_floor(double height) {
    return core().set_floor(height);
}
glm::dvec3 WindControl::origin() const {
    return core().window().origin();
}
const Box& WindControl::box() const {
    return core().box();
}
Result<void> WindControl::shift_origin(glm::dvec3 offset) {
    return core().shift_origin(offset);
}
Result<void> WindControl::set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) {
    return core().set_velocity(velocity_at);
}
Result<void> WindControl::set_velocity(std::span<const glm::vec4> field) {
    return core().set_velocity(field);
}
void WindControl::reset() {
    core().reset();
}
void WindControl::record_to(EventLog* log) {
    core().record_to(log);
}
const Config& WindControl::config() const {
    return core().config;
}

const std::shared_ptr<const Wind>& WindControl::outer() const {
    return core().outer;
}

WindReader::~WindReader() = default;

Result<std::span<const glm::vec4>> WindReader::cells() const {
    const auto now = read_view();
    if (!now)
        return now.failure();
    return now->field();
}

void WindReader::velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
    if (const auto now = read_view())
        return now->velocity(positions, velocities);
    std::ranges::transform(positions, velocities.begin(), [&](glm::dvec3 position) { return velocity(position); });
}

} // namespace windrow
