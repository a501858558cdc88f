#include "fluid/cpu/workspace.h"
#include "fluid/message.h"
#include "fluid/validation.h"
#include "fluid/wind_state.h"

#include <algorithm>
#include <utility>

namespace windrow {
namespace {

Result<void> check_room(const char* call, std::size_t values, const Box& box) {
    if (values == box.cell_count())
        return {};
    return Error{detail::message(call, " got room for ", values, " cells, but the box has ", box.cell_count(),
                                 ": give one array of box().cell_count().")};
}

} // namespace

Result<void> validate(const Config& config) {
    return detail::validate_settings(config);
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Config& config) {
    check_rules(reasons, path, Box{config.cells, config.cell_size, {}});
    detail::check_rows(reasons, config);
    if (detail::holds(k_world_range, config.centre) && !detail::can_hold_point(config, config.centre))
        reasons.add("centre is ", config.centre, " m: give finite numbers within 1e12 cells of the origin.");
    detail::check_follow(reasons, config.follow_axes, config.boundaries, config.rows.has_value());
    if (static_cast<std::size_t>(config.simd) < k_words<Simd>.size() && !runs(config.simd))
        reasons.add("simd is ", name_of(config.simd), ", which this machine does not run: give best or baseline.");
}

Wind::State::State(const Config& config, Workspace workspace, const AmbientWind& ambient)
    : core(config, ambient, cells), cells(core, std::move(workspace)) {
    core.start();
}

Wind::Wind(std::unique_ptr<State> state) : state_(std::move(state)) {}
Wind::Wind(Wind&&) noexcept = default;
Wind& Wind::operator=(Wind&&) noexcept = default;
Wind::~Wind() = default;

Result<Wind> Wind::create(const Config& config) {
    return detail::where_memory_lasts([&]() -> Result<Wind> {
        if (auto valid = validate(config); !valid)
            return Error{valid.error()};
        auto workspace = Workspace::create(
            {.box = detail::box_of(config), .ambient = config.ambient, .simd = config.simd, .parallel_for = config.parallel_for});
        if (!workspace)
            return Error{workspace.error()};
        auto ambient = AmbientWind::create({.mean = workspace->ambient(), .profile = config.profile, .gusts = config.gusts});
        if (!ambient)
            return Error{ambient.error()};
        return Wind(std::make_unique<State>(config, *std::move(workspace), *ambient));
    });
}

Motors& Wind::motors() {
    return state_->core.motors;
}
const Motors& Wind::motors() const {
    return state_->core.motors;
}
Obstacles& Wind::obstacles() {
    return state_->core.obstacles;
}
const Obstacles& Wind::obstacles() const {
    return state_->core.obstacles;
}
Result<ObstacleForce> Wind::force_on(ObstacleId id) const {
    if (auto known = state_->core.obstacles.check(id); !known)
        return Error{known.error()};
    return state_->cells.loads.force_on(id.slot, id.generation);
}
Result<void> Wind::set_ambient(glm::vec3 ambient) {
    return state_->core.set_ambient(ambient);
}
Result<void> Wind::set_gusts(const Gusts& gusts) {
    return state_->core.set_gusts(gusts);
}
glm::vec3 Wind::ambient() const {
    return state_->core.mean_wind();
}
Result<void> Wind::set_boundaries(const Boundaries& boundaries) {
    return state_->core.set_boundaries(boundaries);
}
Result<void> Wind::follow(glm::dvec3 point) {
    return state_->core.follow(point);
}
Result<void> Wind::set_floor(double height) {
    return state_->core.set_floor(height);
}

glm::dvec3 Wind::origin() const {
    return state_->core.window().origin();
}
const Box& Wind::box() const {
    return state_->cells.box();
}

WindView Wind::view() const {
    const auto& frames = state_->core.frames;
    return frames ? state_->cells.view(state_->cells.frames.shown, frames->shown) : state_->cells.air_view();
}

WindView Wind::previous_view() const {
    const auto& frames = state_->core.frames;
    return frames ? state_->cells.view(state_->cells.frames.shown_before, frames->shown_before) : state_->cells.air_view();
}

WindowBlock Wind::window_block(glm::dvec3 anchor) const {
    return state_->core.window_block(anchor, view(), previous_view());
}

FrameBlock Wind::frame_block(glm::dvec3 anchor, const Sampling& sampling) const {
    return state_->core.frame_block(anchor, sampling, view(), previous_view());
}

Result<void> Wind::write_obstacles(std::span<float> cells) const {
    if (auto fits = check_room("write_obstacles", cells.size(), box()); !fits)
        return fits;
    const WindCore& core = state_->core;
    if (!core.sleep.asleep() || !core.obstacles.changed()) {
        state_->cells.write_obstacles(cells);
        return {};
    }
    // Bodies that have come into reach of air that sleeps are placed when it wakes.
    return detail::where_memory_lasts([&]() -> Result<void> {
        cpu::Solids found(box(), box().cells.x);
        found.place(core.obstacles.in_reach());
        std::fill(cells.begin(), cells.end(), 0.0f);
        for (const cpu::Solids::InsideCell& cell : found.inside())
            cells[cell.cell] = 1.0f;
        return {};
    });
}

Result<void> Wind::write_pressure(std::span<float> cells) {
    if (auto fits = check_room("write_pressure", cells.size(), box()); !fits)
        return fits;
    return detail::where_memory_lasts([&]() -> Result<void> {
        state_->cells.write_pressure(cells);
        return {};
    });
}

std::span<const glm::vec4> Wind::field() const {
    state_->cells.hold_air();
    return std::as_const(state_->cells.air.velocity);
}

void Wind::set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) {
    state_->cells.hold_air(); // the gusts of now
    auto& velocity = state_->cells.air.velocity;
    const Box& box = this->box();
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i)
                velocity[box.index(i, j, k)] = glm::vec4(velocity_at(state_->core.window().centre(i, j, k)), 0.0f);
    (void)state_->core.set_velocity(velocity); // cells are set in place, which needs no memory
}

Result<void> Wind::set_velocity(std::span<const glm::vec4> field) {
    return state_->core.set_velocity(field);
}

void Wind::reset() {
    state_->core.reset();
    if (state_->core.frames)
        state_->cells.show_air();
}

void Wind::record_to(EventLog* log) {
    state_->core.record_to(log);
}

const Config& Wind::config() const {
    return state_->core.config;
}

std::size_t Wind::memory_bytes() const {
    const WindCore& core = state_->core;
    const bool own_tile = core.ambient.tile() && !core.config.gusts.tile;
    return sizeof(State) + state_->cells.memory_bytes() + core.motors.memory_bytes() + core.obstacles.memory_bytes() +
           (own_tile ? core.ambient.tile()->memory_bytes() : 0);
}

} // namespace windrow
