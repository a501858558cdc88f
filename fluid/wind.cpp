#include "fluid/core/message.h"
#include "fluid/core/validation.h"
#include "fluid/cpu/workspace.h"
#include "fluid/grid/halo.h"
#include "fluid/wind_state.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

namespace windrow {

Result<void> validate(const Config& config) {
    return detail::validate_settings(config);
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Config& config) {
    check_rules(reasons, path, Box{config.cells, config.cell_size, {}});
    detail::check_rows(reasons, config);
    if (detail::holds(k_world_range, config.centre) && !detail::can_hold_point(config, config.centre))
        reasons.add("centre is ", config.centre, " m: give finite numbers within 1e12 cells of the origin.");
    if (k_world_range.holds(config.floor) && !detail::can_hold_point(config, {0.0, config.floor, 0.0}))
        reasons.add("floor is ", config.floor, " m: give a finite number within 1e12 cells of the origin.");
    detail::check_follow(reasons, config.follow_axes, config.boundaries, config.rows.has_value());
    if (static_cast<std::size_t>(config.simd) < k_words<Simd>.size() && !runs(config.simd))
        reasons.add("simd is ", name_of(config.simd), ", which this machine does not run: give best or baseline.");
}

Wind::State::State(const Config& config, Workspace workspace, const AmbientWind& ambient, std::shared_ptr<const Wind> outer)
    : core(config, ambient, cells, outer), cells(core, std::move(workspace), outer ? &outer->state().cells : nullptr) {
    core.start();
}

std::unique_ptr<OuterAir> outer_air_of(const Box& box, const Wind& outer) {
    return std::make_unique<cpu::OuterWind>(box, outer.state().cells);
}

namespace detail {

Config config_within(const Config& config, const Wind& outer) {
    Config within = config;
    within.ambient = outer.ambient(); // less what its walls close
    within.profile = outer.config().profile;
    within.gusts = outer.config().gusts;
    within.gusts.tile = outer.ambient_wind().tile() ? outer.ambient_wind().tile() : config.gusts.tile; // for detail alone
    return within;
}

// What it takes of the outer wind it had taken; what that has since it takes in its next step.
Config config_loaded(const Config& config, const Wind& outer) {
    Config loaded = config;
    const auto& tile = outer.ambient_wind().tile();
    if (tile && tile->seed() == config.gusts.seed)
        loaded.gusts.tile = tile;
    return loaded;
}

// A periodic outer wind may be smaller than the box, which then spans it many times.
void check_span(Reasons& reasons, const Config& config, const Wind& outer) {
    constexpr const char* k_axes[3] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        const double spanned =
            (config.cells[axis] + k_halo) * static_cast<double>(config.cell_size) / static_cast<double>(outer.box().cell_size) +
            3.0;
        if (outer.box().boundaries.periodic(axis) && spanned > 2.0 * k_max_axis_cells)
            reasons.add("the box spans ", static_cast<int>(std::min(std::ceil(spanned), 2e9)), " cells of its outer wind along ",
                        k_axes[axis], ": give larger outer cells.");
    }
}

void check_within(Reasons& reasons, const Config& config, const Wind& outer) {
    check_span(reasons, config, outer);
    if (config.ambient != glm::vec3(0.0f) || config.profile || config.gusts.intensity != 0.0f)
        reasons.add("ambient, profile or gusts are given beside an outer wind: leave them out, all levels take those of the "
                    "outermost wind.");
    for (const Config* level : {&config, &outer.config()})
        if (level->scheme != Scheme::second_order || !level->stages.advection)
            reasons.add(
                "an outer wind needs scheme second_order and the advection, of both winds: leave them at their defaults.");
    const Box box = box_of(config); // whose rows the window names
    const WindowHistory place(config, box.rows.get());
    const glm::dvec3 low = place.window.origin(), high = low + place.window.size();
    const Window around = outer.view().window();
    const glm::dvec3 outer_low = around.origin(), outer_high = outer_low + around.size();
    const glm::dvec3 rounding = 1e-6 * static_cast<double>(config.cell_size) + 1e-12 * glm::abs(low);
    constexpr const char* k_axes[3] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        if (outer.box().boundaries.periodic(axis))
            continue;
        const bool beyond_low =
            config.boundaries.at(axis, 0).kind == BoundaryKind::open && low[axis] < outer_low[axis] - rounding[axis];
        const bool beyond_high =
            config.boundaries.at(axis, 1).kind == BoundaryKind::open && high[axis] > outer_high[axis] + rounding[axis];
        if (beyond_low || beyond_high)
            reasons.add("the box reaches from ", low[axis], " to ", high[axis], " m along ", k_axes[axis],
                        ", and its outer wind from ", outer_low[axis], " to ", outer_high[axis],
                        " m: give a smaller box, another centre, or a larger outer wind.");
    }
}

} // namespace detail

Wind::Wind(std::unique_ptr<State> state) : WindControl(state->core), state_(std::move(state)) {}
Wind::Wind(Wind&&) noexcept = default;
Wind& Wind::operator=(Wind&&) noexcept = default;
Wind::~Wind() = default;

Result<Wind> Wind::create(const Config& config) {
    return create(config, nullptr);
}

Result<Wind> Wind::create(const Config& wanted, std::shared_ptr<const Wind> outer) {
    return detail::where_memory_lasts([&]() -> Result<Wind> {
        if (auto valid = validate(wanted); !valid)
            return valid.failure();
        if (outer) {
            detail::Reasons reasons;
            detail::check_within(reasons, wanted, *outer);
            if (!reasons.empty())
                return Error{reasons.take()};
        }
        return make(wanted, std::move(outer), false);
    });
}

OuterUndo::OuterUndo(std::shared_ptr<const Wind> outer)
    : outer_(outer && !outer->state().cells.keeps_pressure() ? std::move(outer) : nullptr) {}

OuterUndo::~OuterUndo() {
    if (outer_)
        outer_->state().cells.drop_pressure();
}

Result<Wind> Wind::make(const Config& wanted, std::shared_ptr<const Wind> outer, bool loads) {
    return detail::where_memory_lasts([&]() -> Result<Wind> {
        OuterUndo undo(outer);
        const Config config = !outer  ? wanted
                              : loads ? detail::config_loaded(wanted, *outer)
                                      : detail::config_within(wanted, *outer);
        if (loads && outer) {
            detail::Reasons reasons;
            detail::check_span(reasons, config, *outer);
            if (!reasons.empty())
                return Error{reasons.take()};
        }
        auto workspace = Workspace::create(
            {.box = detail::box_of(config), .ambient = config.ambient, .simd = config.simd, .parallel_for = config.parallel_for});
        if (!workspace)
            return workspace.failure();
        auto ambient = AmbientWind::create({.mean = workspace->ambient(), .profile = config.profile, .gusts = config.gusts});
        if (!ambient)
            return ambient.failure();
        if (outer)
            ambient->set_phase(outer->ambient_wind().phase());
        Wind wind(std::make_unique<State>(config, *std::move(workspace), *ambient, std::move(outer)));
        undo.succeed();
        return wind;
    });
}

Advance Wind::advance(double dt) {
    return state_->core.advance(dt);
}

Diagnostics Wind::step(double dt) {
    return state_->core.step(dt);
}

Result<ObstacleForce> Wind::force_on(ObstacleId id) const {
    if (auto known = state_->core.obstacles.check(id); !known)
        return known.failure();
    return state_->cells.loads.force_on(id.slot, id.generation);
}

Result<DragForce> Wind::force_on(DragId id) const {
    const WindCore& core = state_->core;
    if (auto known = core.drag.check(id); !known)
        return known.failure();
    return core.drag.force_on(id, core.window(), core.config.boundaries, field());
}

WindView Wind::view() const {
    return state_->cells.shown_view(false);
}

WindView Wind::previous_view() const {
    return state_->cells.shown_view(true);
}

WindowBlock Wind::window_block(glm::dvec3 anchor) const {
    return state_->core.window_block(anchor, view(), previous_view());
}

FrameBlock Wind::frame_block(glm::dvec3 anchor, const Sampling& sampling) const {
    return state_->core.frame_block(anchor, sampling, view(), previous_view());
}

Result<void> Wind::write_obstacles(std::span<float> cells) const {
    const WindCore& core = state_->core;
    // Bodies that have come into reach of air that sleeps, or of a wind that has not stepped yet, are placed with its next step.
    if (!state_->cells.has_obstacles() || (core.sleep.asleep() && core.obstacles.changed()))
        return core.write_obstacles(cells, core.window());
    if (auto fits = detail::check_room("write_obstacles", cells.size(), box()); !fits)
        return fits;
    state_->cells.write_obstacles(cells);
    return {};
}

Result<void> Wind::write_pressure(std::span<float> cells) {
    if (auto fits = detail::check_room("write_pressure", cells.size(), box()); !fits)
        return fits;
    return detail::where_memory_lasts([&]() -> Result<void> {
        state_->cells.write_pressure(cells);
        return {};
    });
}

std::span<const glm::vec4> Wind::field() const {
    state_->cells.materialise_air();
    return std::as_const(state_->cells.air.velocity);
}

void Wind::set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) {
    (void)WindControl::set_velocity(velocity_at); // the cells have room
}

Diagnostics Wind::diagnostics() const {
    return state_->core.last;
}

std::uint64_t Wind::memory_bytes() const {
    const WindCore& core = state_->core;
    const bool own_tile = core.ambient.tile() && !core.config.gusts.tile;
    return sizeof(State) + state_->cells.memory_bytes() + core.motors.memory_bytes() + core.obstacles.memory_bytes() +
           core.drag.memory_bytes() + (own_tile ? core.ambient.tile()->memory_bytes() : 0);
}

} // namespace windrow
