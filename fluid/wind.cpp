#include "fluid/cpu/workspace.h"
#include "fluid/validation.h"
#include "fluid/wind_state.h"

#include <algorithm>
#include <utility>

namespace windrow {

Result<void> validate(const Config& config) {
    return detail::validate_settings(config);
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Config& config) {
    check_rules(reasons, path, Box{config.cells, config.cell_size, {}});
    if (detail::holds(k_world_range, config.centre) && !detail::can_hold_point(config, config.centre))
        reasons.add("centre is ", config.centre, " m: give finite numbers within 1e12 cells of the origin.");
    detail::check_follow(reasons, config.follow_axes, config.sides);
    if (static_cast<std::size_t>(config.simd) < k_words<Simd>.size() && !runs(config.simd))
        reasons.add("simd is ", name_of(config.simd), ", which this machine does not run: give best or baseline.");
}

Wind::State::State(const Config& settings, Workspace workspace, const AmbientWind& wind_around)
    : WindHost(settings, wind_around), work(std::move(workspace)), air(work.box().cell_count()), sources(settings.cells) {
    renew_ambient();
    fill_with_ambient();
    // A step of up to k_longest_prepared allocates nothing: what its viscosity needs is made here.
    const DiffusionMethod method = diffusion_method(config.viscosity, k_longest_prepared, config.cell_size);
    if (method != DiffusionMethod::none)
        diffused = cpu::Buffer<glm::vec4>(air.velocity.size());
    if (method == DiffusionMethod::implicit)
        work.state().reserve_diffusion();
}

Wind::Wind(std::unique_ptr<State> state) : state_(std::move(state)) {}
Wind::Wind(Wind&&) noexcept = default;
Wind& Wind::operator=(Wind&&) noexcept = default;
Wind::~Wind() = default;

Result<Wind> Wind::create(const Config& config) {
    if (auto valid = validate(config); !valid)
        return Error{valid.error()};
    return detail::where_memory_lasts([&]() -> Result<Wind> {
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
    });
}

Diagnostics Wind::step(double dt) {
    return state_->step(dt);
}
Advance Wind::advance(double dt) {
    return state_->advance(dt);
}
Motors& Wind::motors() {
    return state_->motors;
}
const Motors& Wind::motors() const {
    return state_->motors;
}
Result<void> Wind::set_ambient(glm::vec3 ambient) {
    return state_->set_ambient(ambient);
}
Result<void> Wind::set_gusts(const Gusts& gusts) {
    return state_->set_gusts(gusts);
}
glm::vec3 Wind::ambient() const {
    return state_->mean_wind();
}
Result<void> Wind::set_sides(const Sides& sides) {
    return state_->set_sides(sides);
}
Result<void> Wind::follow(glm::dvec3 point) {
    return state_->follow(point);
}
Result<void> Wind::set_floor(double height) {
    return state_->set_floor(height);
}

glm::dvec3 Wind::origin() const {
    return state_->window.origin();
}
const Box& Wind::box() const {
    return state_->work.box();
}

WindView Wind::view() const {
    if (!state_->frames)
        return state_->air_view();
    return state_->frame_view(state_->frames->shown);
}

WindView Wind::previous_view() const {
    if (!state_->frames)
        return state_->air_view();
    return state_->frame_view(state_->frames->shown_before);
}

WindView Wind::State::air_view() {
    hold_ambient();
    return {work.box(), window, rim(follow_point), ambient, air.velocity};
}

WindView Wind::State::frame_view(Frame& frame) {
    hold_frame(frame);
    return {work.box(), frame.window, rim(frame.rim_point), frame.ambient, frame.field};
}

WindowBlock Wind::window_block(glm::dvec3 anchor) const {
    return state_->window_block(anchor, view(), previous_view());
}

FrameBlock Wind::frame_block(glm::dvec3 anchor, const Sampling& sampling) const {
    return state_->frame_block(anchor, sampling, view(), previous_view());
}

std::span<const glm::vec4> Wind::field() const {
    state_->hold_ambient();
    return std::as_const(state_->air.velocity);
}

void Wind::set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) {
    state_->hold_ambient(); // what the gusts are now
    const Box& box = this->box();
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i)
                state_->air.velocity[box.index(i, j, k)] = glm::vec4(velocity_at(state_->window.centre(i, j, k)), 0.0f);
    state_->begin_anew();
    if (state_->log != nullptr)
        state_->log->note_velocity(field());
}

Result<void> Wind::set_velocity(std::span<const glm::vec4> field) {
    auto& velocity = state_->air.velocity;
    if (field.size() != velocity.size())
        return Error{detail::message("set_velocity got ", field.size(), " cells, but the box has ", velocity.size(),
                                     ": give box().cell_count().")};
    state_->hold_ambient();
    std::transform(field.begin(), field.end(), velocity.data(), [](glm::vec4 u) { return glm::vec4(u.x, u.y, u.z, 0.0f); });
    state_->begin_anew();
    if (state_->log != nullptr)
        state_->log->note_velocity(field);
    return {};
}

// The cells were set from outside: they have no past, and show at once.
void Wind::State::begin_anew() {
    held = before_held = true;
    air.fresh = true;
    air.owed_diffusion = 0.0f;
    asleep = calm = false;
    if (!frames)
        return;
    frames->before_still = false;
    std::copy_n(air.velocity.data(), frames->before.size(), frames->before.data());
}

void Wind::reset() {
    state_->fill_with_ambient();
    if (state_->frames) {
        state_->hold_ambient();
        state_->frames->shown.held = state_->frames->shown_before.held = true;
        for (auto* field : {&state_->frames->before, &state_->frames->shown.field, &state_->frames->shown_before.field})
            std::copy_n(state_->air.velocity.data(), field->size(), field->data());
    }
    if (state_->log != nullptr)
        state_->log->note(WindReset{});
}

void Wind::record_to(EventLog* log) {
    state_->record_to(log);
}

const Config& Wind::config() const {
    return state_->config;
}

std::size_t Wind::memory_bytes() const {
    return sizeof(State) + state_->work.memory_bytes() + state_->air.memory_bytes() + state_->diffused.bytes() +
           state_->motors.memory_bytes() + state_->sources.memory_bytes() + state_->mean_field.memory_bytes() +
           state_->ambient_field.memory_bytes() + state_->ambient_next.memory_bytes() +
           state_->profile_bends.size() * sizeof(float) + state_->source_flow.bytes() + state_->free_air.memory_bytes() +
           state_->solved.bytes() + (state_->frames ? state_->frames->memory_bytes() : 0) +
           (state_->ambient.tile() && !state_->config.gusts.tile ? state_->ambient.tile()->memory_bytes() : 0);
}

} // namespace windrow
