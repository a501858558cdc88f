#include "fluid/wind_host.h"

#include "fluid/message.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <utility>

namespace windrow {
namespace {

constexpr double k_farthest_cells = 1e12;
constexpr float k_most_wind = 1e4f;
constexpr const char* k_axis_names[3] = {"x", "y", "z"};

template <class Vector>
bool finite(const Vector& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool can_follow(const Sides& sides, int axis) {
    return !sides.periodic(axis) && !sides.has_solid(axis);
}

glm::bvec3 axes_that_follow(const std::optional<glm::bvec3>& follow, const Sides& sides) {
    return follow ? *follow : glm::bvec3(can_follow(sides, 0), can_follow(sides, 1), can_follow(sides, 2));
}

// Names the sources of air among the motors, and where the box lies: the same name, the same S.
std::uint64_t name_of_sources(std::span<const detail::MotorReach> reached, CellIndex origin) {
    constexpr std::uint64_t k_prime = 0x100000001b3;
    std::uint64_t name = 0xcbf29ce484222325; // FNV-1a
    bool any = false;
    const auto mix = [&](const auto& value) {
        for (const std::byte byte : std::as_bytes(std::span(&value, 1)))
            name = (name ^ static_cast<std::uint64_t>(byte)) * k_prime;
    };
    for (const detail::MotorReach& motor : reached)
        if (motor.law == detail::MotorReach::Law::source) {
            any = true;
            mix(motor);
        }
    if (!any)
        return 0;
    for (int axis = 0; axis < 3; ++axis)
        mix(origin[axis]);
    return name | 1;
}

} // namespace

namespace detail {

bool can_hold_point(const Config& config, glm::dvec3 point) {
    if (!finite(point))
        return false;
    const double farthest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    // A cell size that is none is told by itself.
    return !(config.cell_size > 0.0f) || farthest <= k_farthest_cells * static_cast<double>(config.cell_size);
}

void check_ambient(Reasons& reasons, glm::vec3 ambient) {
    if (!finite(ambient) || std::max({std::abs(ambient.x), std::abs(ambient.y), std::abs(ambient.z)}) > k_most_wind)
        reasons.add("ambient is ", ambient, " m/s: give finite numbers, at most 1e4 m/s in size.");
}

void check_follow(Reasons& reasons, const std::optional<glm::bvec3>& follow, const Sides& sides) {
    for (int axis = 0; axis < 3 && follow; ++axis)
        if ((*follow)[axis] && !can_follow(sides, axis))
            reasons.add("follow_axes asks the box to follow along ", k_axis_names[axis], ", where a side is ",
                        sides.periodic(axis) ? "periodic" : "solid", ": open both sides of that axis or leave it out",
                        axis == 1 ? " (set_floor moves a floor)." : ".");
}

} // namespace detail

WindHost::WindHost(const Config& settings, const AmbientWind& wind_around)
    : config(settings),
      follow_axes(axes_that_follow(settings.follow_axes, settings.sides)), window{settings.cells, settings.cell_size, {}},
      follow_point(settings.centre), ambient(wind_around) {
    window.origin_cells = window.centred_on(config.centre);
    previous_origin_cells = stepped_origin_cells = window.origin_cells;
    previous_point = stepped_point = follow_point;
}

Diagnostics WindHost::step(double dt) {
    if (!(dt > 0.0) || !std::isfinite(static_cast<float>(dt)) || static_cast<float>(dt) == 0.0f)
        return {};
    if (!detail::memory_lasts([&] { make_room(dt); }))
        return {.out_of_memory = true, .times_ms = {}};
    double lead = 0.0;
    if (frames) {
        lead = frames->lead;
        follow_now(frames->follow.target());
        frames.reset();
    }
    motors.begin_frame(lead, dt);
    if (lead > 0.0) // what was told since the last tick happens in this step too
        motors.squeeze(dt / (lead + dt));
    const Diagnostics report = tick_air(dt);
    if (log != nullptr)
        log->note(Stepped{dt});
    return report;
}

Advance WindHost::advance(double dt) {
    if (!(dt >= 0.0) || !std::isfinite(dt))
        return {};
    const bool has_room = detail::memory_lasts([&] {
        make_room(1.0 / config.ticks.hz);
        if (!frames)
            begin_ticks();
    });
    if (!has_room)
        return {.last = {.out_of_memory = true, .times_ms = {}}};
    const Advance done = run_ticks(dt);
    if (log != nullptr)
        log->note(Advanced{dt});
    return done;
}

Result<void> WindHost::set_ambient(glm::vec3 wind) {
    detail::Reasons reasons;
    detail::check_ambient(reasons, wind);
    if (!reasons.empty())
        return Error{reasons.take()};
    if (!has_room_around(config.gusts))
        return detail::out_of_memory();
    change_ambient(wind);
    if (log != nullptr)
        log->note(AmbientSet{wind});
    return {};
}

Result<void> WindHost::set_gusts(const Gusts& gusts) {
    Gusts wanted = gusts;
    if (!wanted.tile && ambient.tile() && ambient.tile()->seed() == gusts.seed)
        wanted.tile = ambient.tile();
    auto renewed = AmbientWind::create({.mean = mean_wind(), .profile = config.profile, .gusts = wanted});
    if (!renewed)
        return Error{renewed.error()};
    if (!has_room_around(gusts))
        return detail::out_of_memory();
    renewed->set_phase(ambient.phase());
    take_ambient_out();
    config.gusts = gusts;
    ambient = *std::move(renewed);
    put_ambient_in();
    if (log != nullptr)
        log->note(GustsSet{gusts.intensity, gusts.length, gusts.tile ? gusts.tile->seed() : gusts.seed, gusts.tile != nullptr});
    return {};
}

Result<void> WindHost::set_sides(const Sides& sides) {
    detail::Reasons reasons;
    if (auto valid = validate(sides); !valid)
        reasons.add(valid.error());
    detail::check_follow(reasons, config.follow_axes, sides);
    if (!reasons.empty())
        return Error{reasons.take()};
    if (!has_room_around(config.gusts))
        return detail::out_of_memory();
    bool same_kinds = true;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            same_kinds = same_kinds && sides.at(axis, end).kind == config.sides.at(axis, end).kind;
    if (auto changed = change_sides(sides, !same_kinds); !changed)
        return changed;
    config.sides = sides;
    if (!same_kinds && sources_of_air != 0)
        sources_of_air = 2; // names no set of sources: their flow is made anew
    follow_axes = axes_that_follow(config.follow_axes, sides);
    renew_ambient();
    asleep = calm = false;
    if (log != nullptr)
        log->note(SidesSet{sides});
    return {};
}

Result<void> WindHost::follow(glm::dvec3 point) {
    if (!detail::can_hold_point(config, point))
        return Error{detail::message("follow point is ", point, " m: give finite numbers within 1e12 cells of the origin.")};
    if (!has_room_around(config.gusts))
        return detail::out_of_memory();
    if (frames)
        frames->follow.move_to(point);
    else
        follow_now(point);
    if (log != nullptr)
        log->note(Followed{point});
    return {};
}

Result<void> WindHost::set_floor(double height) {
    const Side& floor = config.sides.y_low;
    if (!floor.solid())
        return Error{"set_floor needs a solid low y side: set sides.y_low to free_slip or no_slip, or use follow."};
    if (!detail::can_hold_point(config, {0.0, height, 0.0}))
        return Error{detail::message("floor height is ", height, " m: give a finite number within 1e12 cells of the origin.")};
    if (!has_room_around(config.gusts))
        return detail::out_of_memory();
    CellIndex origin = window.origin_cells;
    origin.y = static_cast<std::int64_t>(std::floor(height / static_cast<double>(config.cell_size) + 0.5));
    shift_to(origin);
    follow_point.y = height + 0.5 * static_cast<double>(config.cell_size) * window.cells.y;
    if (log != nullptr)
        log->note(FloorSet{height});
    return {};
}

bool WindHost::has_room_around(const Gusts& gusts) {
    return detail::memory_lasts([&] { make_room_around(gusts); });
}

void WindHost::record_to(EventLog* to) {
    log = to;
    motors.record_to(to);
}

WindowBlock WindHost::window_block(glm::dvec3 anchor, const WindView& view, const WindView& previous_view) const {
    anchor = detail::usable_anchor(anchor);
    WindowBlock block = view.block(anchor);
    if (frames) {
        const WindowBlock before = previous_view.block(anchor);
        block.cells_and_factor.w = static_cast<float>(frames->lead * config.ticks.hz);
        block.previous_origin = glm::vec4(glm::vec3(before.origin_and_cell_size), 0.0f);
        block.previous_rim_point = glm::vec4(glm::vec3(before.rim_point), 0.0f);
    } else {
        const double h = config.cell_size;
        block.previous_origin = {glm::vec3(glm::dvec3(previous_origin_cells) * h - anchor), 0.0f};
        block.previous_rim_point = {glm::vec3(previous_point - anchor), 0.0f};
    }
    return block;
}

FrameBlock WindHost::frame_block(glm::dvec3 anchor, const Sampling& sampling, const WindView& view,
                                 const WindView& previous_view) const {
    return {.window = window_block(anchor, view, previous_view),
            .ambient = view.ambient().block(anchor, sampling),
            .previous_ambient = previous_view.ambient().block(anchor, sampling)};
}

// --- A step, but for its cells ---------------------------------------------------------------------------------------------

Diagnostics WindHost::tick_air(double duration) {
    const auto start = std::chrono::steady_clock::now();
    Diagnostics report;
    run_step(duration, report);
    report.times_ms.total = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return report;
}

void WindHost::run_step(double duration, Diagnostics& report) {
    std::span<const detail::MotorReach> reached;
    if (config.stages.sources)
        reached = motors.tick(duration, window, config.sides);
    previous_origin_cells = std::exchange(stepped_origin_cells, window.origin_cells);
    previous_point = std::exchange(stepped_point, follow_point);
    if (asleep && reached.empty()) {
        ambient.advance(duration); // small-scale detail is carried on too
        if (ambient.gusting())
            gusts_passed();
        report = at_rest;
        return;
    }
    asleep = calm = false;
    report.stepped = true;
    report.motors_in_reach = static_cast<int>(reached.size());
    step_cells(duration, reached, report);
    fall_asleep_if_settled(report);
}

bool WindHost::viscous(float dt) const {
    const float longest = std::max(dt, k_longest_prepared);
    return config.stages.diffusion && diffusion_method(config.viscosity, longest, config.cell_size) != DiffusionMethod::none;
}

std::optional<cpu::CanopyRows> WindHost::canopy_rows() const {
    if (!config.canopy || !config.stages.sources || config.canopy->height <= 0.0f || config.canopy->drag <= 0.0f)
        return std::nullopt;
    const double h = config.cell_size;
    const double ground = (ambient.ground() - window.origin().y) / h,
                 top = ground + static_cast<double>(config.canopy->height) / h;
    if (top <= 0.0 || ground >= config.cells.y)
        return std::nullopt;
    const double farthest = 2.0 * k_max_axis_cells; // beyond the box it matters no more, and floats hold it
    return cpu::CanopyRows{.drag = config.canopy->drag,
                           .ground = static_cast<float>(std::max(ground, -farthest)),
                           .top = static_cast<float>(std::min(top, farthest))};
}

bool WindHost::renew_sources(std::span<const detail::MotorReach> reached) {
    const std::uint64_t name = name_of_sources(reached, window.origin_cells);
    return std::exchange(sources_of_air, name) != name;
}

void WindHost::fall_asleep_if_settled(Diagnostics& report) {
    const bool may = config.stages.settling && config.settling_time > 0.0f && config.sleep_speed > 0.0f &&
                     report.motors_in_reach == 0 && sources_of_air == 0 && !viscous() &&
                     !(canopy_rows() && mean_wind() != glm::vec3(0.0f)); // a wind among plants does not come to rest
    if (!may || !at_ambient())
        return;
    fill_with_ambient();
    asleep = report.asleep = true;
    measure(report); // again: the air is ambient now
    at_rest = {.stepped = true,
               .max_speed = report.max_speed,
               .divergence_rms = report.divergence_rms,
               .energy = report.energy,
               .asleep = true,
               .times_ms = {}};
}

} // namespace windrow
