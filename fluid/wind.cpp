#include "fluid/cpu/workspace.h"
#include "fluid/message.h"
#include "fluid/wind_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace windrow {
namespace {

constexpr double k_farthest_cells = 1e12;
constexpr float k_most_wind = 1e4f;
constexpr float k_longest_prepared = 1.0f; // [s]
constexpr const char* k_axis_names[3] = {"x", "y", "z"};

template <class Vector>
bool finite(const Vector& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool can_follow(const Sides& sides, int axis) {
    return !sides.periodic(axis) && !sides.has_solid(axis);
}

void check_ambient(detail::Reasons& reasons, glm::vec3 ambient) {
    if (!finite(ambient) || std::max({std::abs(ambient.x), std::abs(ambient.y), std::abs(ambient.z)}) > k_most_wind)
        reasons.add("ambient is ", ambient, " m/s: give finite numbers, at most 1e4 m/s in size.");
}

void check_follow(detail::Reasons& reasons, const std::optional<glm::bvec3>& follow, const Sides& sides) {
    for (int axis = 0; axis < 3 && follow; ++axis)
        if ((*follow)[axis] && !can_follow(sides, axis))
            reasons.add("follow_axes asks the box to follow along ", k_axis_names[axis], ", where a side is ",
                        sides.periodic(axis) ? "periodic" : "solid", ": open both sides of that axis or leave it out",
                        axis == 1 ? " (set_floor moves a floor)." : ".");
}

glm::bvec3 axes_that_follow(const std::optional<glm::bvec3>& follow, const Sides& sides) {
    return follow ? *follow : glm::bvec3(can_follow(sides, 0), can_follow(sides, 1), can_follow(sides, 2));
}

bool in_range(const Config& config, glm::dvec3 point) {
    return finite(point) && std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) <=
                                k_farthest_cells * static_cast<double>(config.cell_size);
}
} // namespace

Result<void> validate(const Config& config) {
    detail::Reasons reasons;
    if (auto box = validate(Box{config.cells, config.cell_size, config.sides}); !box)
        reasons.add(box.error());
    if (!finite(config.centre) || (config.cell_size > 0.0f && !in_range(config, config.centre)))
        reasons.add("centre is ", config.centre, " m: give finite numbers within 1e12 cells of the origin.");
    check_follow(reasons, config.follow_axes, config.sides);
    check_ambient(reasons, config.ambient);
    if (config.profile)
        if (auto profile = validate(*config.profile); !profile)
            reasons.add(profile.error());
    if (auto gusts = validate(config.gusts); !gusts)
        reasons.add(gusts.error());
    if (!(config.rim >= 0.0f && config.rim <= 64.0f))
        reasons.add("rim is ", config.rim, " cells: give 0 (none) to 64.");
    if (!(config.sleep_speed >= 0.0f && config.sleep_speed <= k_most_wind))
        reasons.add("sleep_speed is ", config.sleep_speed, " m/s: give 0 (never) to 1e4.");
    if (!(config.ticks.hz >= 1.0 && config.ticks.hz <= 1e4))
        reasons.add("ticks.hz is ", config.ticks.hz, ": give 1 to 10000.");
    if (config.ticks.most < 1 || config.ticks.most > 1000)
        reasons.add("ticks.most is ", config.ticks.most, ": give 1 to 1000.");
    if (!(config.viscosity >= 0.0f && config.viscosity <= 1e9f))
        reasons.add("viscosity is ", config.viscosity, " m2/s: give 0 to 1e9.");
    if (!(config.settling_time >= 0.0f && config.settling_time <= 1e9f))
        reasons.add("settling_time is ", config.settling_time, " s: give 0 (never) to 1e9.");
    if (!(config.max_cfl > 0.0f && config.max_cfl <= 1e6f))
        reasons.add("max_cfl is ", config.max_cfl, ": give a number above 0, at most 1e6; 2 is accurate.");
    if (config.max_substeps < 1 || config.max_substeps > 64)
        reasons.add("max_substeps is ", config.max_substeps, ": give 1 to 64.");
    if (!runs(config.simd))
        reasons.add("simd is ", name_of(config.simd), ", which this machine does not run: give best or baseline.");
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

Wind::State::State(const Config& settings, Workspace workspace, const AmbientWind& wind_around)
    : config(settings), follow_axes(axes_that_follow(settings.follow_axes, settings.sides)),
      work(std::move(workspace)), window{settings.cells, settings.cell_size, {}}, follow_point(settings.centre),
      ambient(wind_around), air(work.box().cell_count()), sources(settings.cells) {
    window.origin_cells = window.centred_on(config.centre);
    previous_origin_cells = stepped_origin_cells = window.origin_cells;
    previous_point = stepped_point = follow_point;
    renew_ambient();
    fill_with_ambient();
    // A step of up to k_longest_prepared allocates nothing: what its viscosity needs is made here.
    const DiffusionMethod method = diffusion_method(config.viscosity, k_longest_prepared, config.cell_size);
    if (method != DiffusionMethod::none)
        diffused = cpu::Buffer<glm::vec4>(air.velocity.size());
    if (method == DiffusionMethod::implicit)
        reserve_diffusion(work);
}

Wind::Wind(std::unique_ptr<State> state) : state_(std::move(state)) {}
Wind::Wind(Wind&&) noexcept = default;
Wind& Wind::operator=(Wind&&) noexcept = default;
Wind::~Wind() = default;

Result<Wind> Wind::create(const Config& config) {
    if (auto valid = validate(config); !valid)
        return Error{valid.error()};
    auto workspace = Workspace::create({.box = {config.cells, config.cell_size, config.sides},
                                        .ambient = config.ambient,
                                        .simd = config.simd,
                                        .parallel_for = config.parallel_for});
    if (!workspace)
        return Error{workspace.error()};
    auto ambient = AmbientWind::create({.mean = workspace->ambient(), .profile = config.profile, .gusts = config.gusts});
    if (!ambient)
        return Error{ambient.error()};
    return Wind(std::make_unique<State>(config, *std::move(workspace), *ambient));
}

Diagnostics Wind::step(double dt) {
    if (!(dt > 0.0) || !std::isfinite(static_cast<float>(dt)) || static_cast<float>(dt) == 0.0f)
        return {};
    double lead = 0.0;
    if (state_->frames) {
        lead = state_->frames->lead;
        state_->follow(state_->frames->follow.target());
        state_->frames.reset();
    }
    state_->motors.begin_frame(lead, dt);
    if (lead > 0.0) // what was told since the last tick happens in this step too
        state_->motors.squeeze(dt / (lead + dt));
    const Diagnostics report = state_->step(dt);
    if (state_->log != nullptr)
        state_->log->note(Stepped{dt});
    return report;
}

Advance Wind::advance(double dt) {
    if (!(dt >= 0.0) || !std::isfinite(dt))
        return {};
    const Advance done = state_->advance(dt);
    if (state_->log != nullptr)
        state_->log->note(Advanced{dt});
    return done;
}

Motors& Wind::motors() {
    return state_->motors;
}
const Motors& Wind::motors() const {
    return state_->motors;
}

Result<void> Wind::set_ambient(glm::vec3 ambient) {
    detail::Reasons reasons;
    check_ambient(reasons, ambient);
    if (!reasons.empty())
        return Error{reasons.take()};
    state_->config.ambient = ambient;
    state_->change_ambient(ambient);
    if (state_->log != nullptr)
        state_->log->note(AmbientSet{ambient});
    return {};
}

Result<void> Wind::set_gusts(const Gusts& gusts) {
    State& state = *state_;
    Gusts wanted = gusts;
    if (!wanted.tile && state.ambient.tile() && state.ambient.tile()->seed() == gusts.seed)
        wanted.tile = state.ambient.tile();
    auto renewed = AmbientWind::create({.mean = state.work.ambient(), .profile = state.config.profile, .gusts = wanted});
    if (!renewed)
        return Error{renewed.error()};
    renewed->set_phase(state.ambient.phase());
    state.exchange_ambient([&] {
        state.config.gusts = gusts;
        state.ambient = *std::move(renewed);
    });
    if (state.log != nullptr)
        state.log->note(
            GustsSet{gusts.intensity, gusts.length, gusts.tile ? gusts.tile->seed() : gusts.seed, gusts.tile != nullptr});
    return {};
}

glm::vec3 Wind::ambient() const {
    return state_->work.ambient();
}

Result<void> Wind::set_sides(const Sides& sides) {
    detail::Reasons reasons;
    if (auto valid = validate(sides); !valid)
        reasons.add(valid.error());
    check_follow(reasons, state_->config.follow_axes, sides);
    if (!reasons.empty())
        return Error{reasons.take()};
    bool same_kinds = true;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            same_kinds = same_kinds && sides.at(axis, end).kind == state_->config.sides.at(axis, end).kind;
    if (!same_kinds) {
        state_->air.fresh = true;
        if (state_->sources_of_air != 0)
            state_->sources_of_air = 2; // names no set of sources: their flow is made anew
    }
    state_->config.sides = sides;
    state_->follow_axes = axes_that_follow(state_->config.follow_axes, sides);
    if (auto set = state_->work.set_sides(sides); !set)
        return set;
    state_->renew_ambient();
    state_->asleep = state_->calm = false;
    if (state_->log != nullptr)
        state_->log->note(SidesSet{sides});
    return {};
}

Result<void> Wind::follow(glm::dvec3 point) {
    if (!in_range(state_->config, point))
        return Error{detail::message("follow point is ", point, " m: give finite numbers within 1e12 cells of the origin.")};
    if (state_->frames)
        state_->frames->follow.move_to(point);
    else
        state_->follow(point);
    if (state_->log != nullptr)
        state_->log->note(Followed{point});
    return {};
}

Result<void> Wind::set_floor(double height) {
    const Side& floor = state_->config.sides.y_low;
    if (!floor.solid())
        return Error{"set_floor needs a solid low y side: set sides.y_low to free_slip or no_slip, or use follow."};
    if (!in_range(state_->config, {0.0, height, 0.0}))
        return Error{detail::message("floor height is ", height, " m: give a finite number within 1e12 cells of the origin.")};
    CellIndex origin = state_->window.origin_cells;
    origin.y = static_cast<std::int64_t>(std::floor(height / static_cast<double>(state_->config.cell_size) + 0.5));
    state_->shift_to(origin);
    state_->follow_point.y = height + 0.5 * static_cast<double>(state_->config.cell_size) * state_->window.cells.y;
    if (state_->log != nullptr)
        state_->log->note(FloorSet{height});
    return {};
}

glm::dvec3 Wind::origin() const {
    return state_->window.origin();
}
const Box& Wind::box() const {
    return state_->box();
}

WindView Wind::view() const {
    if (!state_->frames)
        return state_->air_view();
    const Frame& frame = state_->frames->shown;
    return {state_->box(), frame.window, state_->rim(frame.rim_point), frame.ambient, frame.field};
}

WindView Wind::previous_view() const {
    if (!state_->frames)
        return state_->air_view();
    const Frame& frame = state_->frames->shown_before;
    return {state_->box(), frame.window, state_->rim(frame.rim_point), frame.ambient, frame.field};
}

WindView Wind::State::air_view() const {
    return {work.box(), window, rim(follow_point), ambient, air.velocity};
}

std::span<const glm::vec4> Wind::field() const {
    return std::as_const(state_->air.velocity);
}

WindowBlock Wind::window_block(glm::dvec3 anchor) const {
    WindowBlock block = view().block(anchor);
    if (state_->frames) {
        const WindowBlock before = previous_view().block(anchor);
        block.cells_and_factor.w = static_cast<float>(state_->frames->lead * state_->config.ticks.hz);
        block.previous_origin = glm::vec4(glm::vec3(before.origin_and_cell_size), 0.0f);
        block.previous_rim_point = glm::vec4(glm::vec3(before.rim_point), 0.0f);
    } else {
        const double h = state_->box().cell_size;
        block.previous_origin = {glm::vec3(glm::dvec3(state_->previous_origin_cells) * h - anchor), 0.0f};
        block.previous_rim_point = {glm::vec3(state_->previous_point - anchor), 0.0f};
    }
    return block;
}

void Wind::set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) {
    const Box& box = state_->box();
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i)
                state_->air.velocity[box.index(i, j, k)] = glm::vec4(velocity_at(state_->window.centre(i, j, k)), 0.0f);
    state_->air.fresh = true;
    state_->asleep = state_->calm = false;
    if (state_->log != nullptr)
        state_->log->note(VelocitySet{{field().begin(), field().end()}});
}

Result<void> Wind::set_velocity(std::span<const glm::vec4> field) {
    auto& velocity = state_->air.velocity;
    if (field.size() != velocity.size())
        return Error{detail::message("set_velocity got ", field.size(), " cells, but the box has ", velocity.size(),
                                     ": give box().cell_count().")};
    std::transform(field.begin(), field.end(), velocity.data(), [](glm::vec4 u) { return glm::vec4(u.x, u.y, u.z, 0.0f); });
    state_->air.fresh = true;
    state_->asleep = state_->calm = false;
    if (state_->log != nullptr)
        state_->log->note(VelocitySet{{field.begin(), field.end()}});
    return {};
}

void Wind::reset() {
    state_->fill_with_ambient();
    if (state_->frames)
        for (auto* field : {&state_->frames->before, &state_->frames->shown.field, &state_->frames->shown_before.field})
            std::copy_n(state_->air.velocity.data(), field->size(), field->data());
    if (state_->log != nullptr)
        state_->log->note(WindReset{});
}

void Wind::record_to(EventLog* log) {
    state_->log = log;
    state_->motors.record_to(log);
}

const Config& Wind::config() const {
    return state_->config;
}

std::size_t Wind::memory_bytes() const {
    return sizeof(State) + state_->work.memory_bytes() + state_->air.memory_bytes() + state_->diffused.bytes() +
           state_->motors.memory_bytes() + state_->sources.memory_bytes() + state_->mean_field.memory_bytes() +
           state_->ambient_field.memory_bytes() + state_->source_flow.bytes() + state_->solved.bytes() +
           (state_->frames ? state_->frames->memory_bytes() : 0) +
           (state_->ambient.tile() && !state_->config.gusts.tile ? state_->ambient.tile()->memory_bytes() : 0);
}

} // namespace windrow
