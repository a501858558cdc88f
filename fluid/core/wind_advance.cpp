// Time of a wind, top-down: `advance` divides a frame into ticks; a tick is one step of the air at the box's current place.
//
// The air has its own ticks and the renderer its own pace (tick_clock.h, frame_history.h). Motion (motors, the point that the
// box follows) is set per frame and sampled by each tick at its own time (track.h), so the air's states do not depend on the
// frame rate. A shift keeps the cells that stay inside to the bit; exposed cells take the ambient wind without history.
#include "fluid/core/message.h"
#include "fluid/core/wind_core.h"
#include "fluid/core/zone.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <utility>

namespace windrow {
namespace {

constexpr double k_longest_frame = 1e9; // [s] beyond it times cannot be distinguished

// Key of the volume sources among the motors and of the box's place: equal keys have equal S. 0: no source.
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

// Gusts have no component along an axis closed by walls. The ground is the only mirror, and the gusts already include it.
glm::vec3 gust_axes(const Boundaries& boundaries) {
    return {boundaries.has_solid(0) ? 0.0f : 1.0f, boundaries.y_high.solid() ? 0.0f : 1.0f,
            boundaries.has_solid(2) ? 0.0f : 1.0f};
}

} // namespace

Advance WindCore::advance(double dt) {
    if (!(dt >= 0.0) || !std::isfinite(dt))
        return {};
    const detail::Zone zone("windrow advance");
    const double duration = 1.0 / config.ticks.hz, frame = std::min(dt, k_longest_frame);
    if (!has_room({.step = duration, .frames = true}))
        return {.last = {.out_of_memory = true, .times_ms = {}}};
    if (!frames) {
        frames.emplace(now());
        apply(CellChange::Kind::begin_frames);
    }
    motors.begin_frame(frames->clock.lead, frame);
    obstacles.begin_frame(frames->clock.lead, frame);
    frames->follow.begin_frame(frames->clock.lead, frame);
    const TickClock::Due due = frames->clock.spend(frame, config.ticks);
    Advance done{.ticks = due.ticks, .dropped = due.dropped};
    if (due.dropped > 0.0)
        drop(due.dropped);
    bool regridded = false;
    for (int n = 0; n < due.ticks; ++n) {
        done.last = tick(duration, 1.0f / static_cast<float>(due.ticks - n));
        regridded = regridded || done.last.regridded;
    }
    done.last.regridded = regridded;
    // Air that no step has carried is the outer wind's of now, whoever read it.
    if (due.ticks == 0 && outer && cells_.filled() && !sleep.asleep()) {
        apply(CellChange::Kind::fill);
        apply(CellChange::Kind::fill_before);
        cells_.show_air();
    }
    const double factor = frames->clock.factor(config.ticks);
    done.factor = static_cast<float>(factor);
    cells_.show(frames->show(now(), factor));
    note(Advanced{dt});
    return done;
}

Diagnostics WindCore::step(double dt) {
    if (!(dt > 0.0) || !std::isfinite(static_cast<float>(dt)) || static_cast<float>(dt) == 0.0f)
        return {};
    if (!has_room({.step = dt}))
        return {.out_of_memory = true, .times_ms = {}};
    const detail::Zone zone("windrow step");
    double lead = 0.0;
    if (frames) {
        lead = frames->clock.lead;
        follow_now(frames->follow.target());
        frames.reset();
        apply(CellChange::Kind::end_frames);
    }
    motors.begin_frame(lead, dt);
    obstacles.begin_frame(lead, dt);
    if (lead > 0.0) { // motion set since the last tick is part of this step
        motors.squeeze(dt / (lead + dt));
        obstacles.squeeze(dt / (lead + dt));
    }
    const Diagnostics report = step_air(dt);
    note(Stepped{dt});
    return report;
}

bool WindCore::has_room(const CellNeeds& needs) {
    return detail::memory_lasts([&] { cells_.make_room(needs); });
}

// Nothing acts on the air in dropped time, but the rest advances: bodies are at their new places, gusts have passed.
void WindCore::drop(double seconds) {
    (void)motors.tick(seconds, place.window, config.boundaries, config.jump_speed);
    obstacles.pass(seconds);
    (void)frames->follow.tick(seconds);
    if (sleep.asleep() || !ambient.gusting()) {
        drift(seconds);
        return;
    }
    take_ambient_out();
    ambient.advance(seconds);
    put_ambient_in();
}

Diagnostics WindCore::tick(double duration, float outer_way) {
    if (!(sleep.asleep() && frames->before_still))
        apply(CellChange::Kind::keep);
    frames->keep(now());
    (void)frames->follow.tick(duration);
    follow_now(frames->follow.here());
    return step_air(duration, outer_way);
}

// --- The box -----------------------------------------------------------------------------------------------------------------

void WindCore::follow_now(glm::dvec3 point) {
    place.point = point;
    shift_to(place.around(point));
}

void WindCore::shift_to(CellIndex origin_cells) {
    const CellIndex shift = origin_cells - place.window.origin_cells;
    if (shift == CellIndex(0))
        return;
    const bool calm = sleep.calm();
    if (shift.y != 0 && !ambient.uniform())
        sleep.turn_over(); // the reported wind depends on height
    // Gusts keep their height over the ground: where the ground moves, the gusts and their part in the air move with it.
    const bool gusts_move = shift.y != 0 && config.boundaries.y_low.solid() && config.gusts.intensity > 0.0f && !calm;
    if (gusts_move)
        add_ambient(-1.0f);
    place.window.origin_cells = origin_cells;
    renew_ambient();
    const bool beyond = place.leaves(shift);
    if (beyond || calm) {
        if (beyond || outer || !ambient.uniform())
            fill_with_ambient();
        if (frames && !(frames->before_still && ambient.uniform()))
            apply(CellChange::Kind::fill_before);
        return;
    }
    CellChange move = change(CellChange::Kind::shift);
    move.by = shift;
    move.exposed_hold_ambient = !gusts_move;
    move.has_source_flow = source_name != 0;
    apply(move);
    if (gusts_move)
        add_ambient(1.0f);
}

// --- The air -----------------------------------------------------------------------------------------------------------------

Diagnostics WindCore::step_air(double duration, float outer_way) {
    const auto start = std::chrono::steady_clock::now();
    last = {.times_ms = {}};
    run_step(duration, outer_way, last);
    last.times_ms.total = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return last;
}

void WindCore::run_step(double duration, float outer_way, Diagnostics& report) {
    if (outer)
        follow_outer_ambient();
    const bool outer_rests = !outer || outer->diagnostics().asleep;
    std::span<const detail::MotorReach> reached;
    if (config.stages.sources) {
        reached = motors.tick(duration, place.window, config.boundaries, config.jump_speed);
        report.motors_lost = motors.lost(place.window, config.boundaries, place.follow_axes);
    }
    const std::span<const detail::PlacedObstacle> bodies =
        obstacles.tick(duration, place.window, config.boundaries, config.jump_speed);
    report.jumps = motors.jumps() + obstacles.jumps();
    report.fast_turns = obstacles.fast_turns();
    const bool moved = obstacles.take_moved(), wind_meets_bodies = !bodies.empty() && mean_wind() != glm::vec3(0.0f);
    const DragCells plants = config.stages.sources ? drag.cells_in(place.window, config.boundaries) : DragCells{};
    const bool wind_meets_plants = plants.any() && mean_wind() != glm::vec3(0.0f);
    report.regridded = rows && place.stepped.origin_cells.y != place.window.origin_cells.y;
    place.note_step();
    if (sleep.asleep() && outer_rests && reached.empty() && !moved && !wind_meets_bodies && !wind_meets_plants) {
        drift(duration);
        const Diagnostics now = report;
        report = sleep.at_rest;
        report.regridded = now.regridded;
        report.motors_lost = now.motors_lost;
        report.jumps = now.jumps;
        return;
    }
    const bool begins_ambient = sleep.calm() && ambient.uniform(); // which a step leaves as it is
    report.stepped = true;
    report.motors_in_reach = static_cast<int>(reached.size());
    const bool renews_sources = config.stages.projection && renew_sources(reached);
    const CanopyRows canopy = canopy_rows();
    const Sleep::Conditions conditions{.relaxation_time = relaxation_time(config, wind_meets_bodies),
                                       .sleep_speed = config.sleep_speed,
                                       .motors = report.motors_in_reach,
                                       .source_flow = source_name != 0,
                                       .viscous = viscous() || changes_ambient(),
                                       .wind_among_plants =
                                           wind_meets_plants || (canopy.drag > 0.0f && mean_wind() != glm::vec3(0.0f)),
                                       .bodies_act = moved || wind_meets_bodies};
    CellStep step{.duration = duration,
                  .motors = reached,
                  .obstacles = bodies,
                  .obstacles_changed = obstacles.take_changed(),
                  .obstacles_moved = moved,
                  .tile = motors.tile(ambient.tile()),
                  .ambient = &ambient,
                  .window = &place.window,
                  .canopy = canopy,
                  .drag = plants,
                  .drag_change = drag.take_change(),
                  .relaxation_time = conditions.relaxation_time,
                  .renews_sources = renews_sources,
                  .has_source_flow = source_name != 0,
                  .kept = frames.has_value(),
                  .may_rest = Sleep::may_begin(conditions),
                  .outer_way = outer_way,
                  .outer_speed = outer ? outer->diagnostics().max_speed : 0.0f};
    speed.note(cells_.measured());
    speed.note(step, box());
    step.tick = speed.tick();
    sleep.begin_tick(!step.may_rest);
    step.rests = outer_rests && step.may_rest && (begins_ambient || speed.was_still(sleep.undisturbed));
    if (std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.moves(); }))
        step.substeps = speed.substeps(config, duration);
    const bool rests = cells_.step(step, report);
    speed.note(cells_.measured());
    if (!rests)
        return;
    speed.note(change(CellChange::Kind::fill));
    sleep.fall_asleep(report);
}

// Gusts also pass over sleeping air.
void WindCore::drift(double seconds) {
    ambient.advance(seconds); // small-scale detail is advected too
    if (ambient.gusting())
        ++sleep.drift;
}

// True where the volume sources among the motors, or the box around them, have changed.
bool WindCore::renew_sources(std::span<const detail::MotorReach> reached) {
    const std::uint64_t name = name_of_sources(reached, place.window.origin_cells - place.window.shifted);
    return std::exchange(source_name, name) != name;
}

bool WindCore::viscous(float dt) const {
    const float longest = std::max(dt, k_longest_prepared);
    return config.stages.diffusion && diffusion_method(config.viscosity, longest, box().finest()) != DiffusionMethod::none;
}

// Whether the floor makes another wind of the ambient one.
bool WindCore::changes_ambient() const {
    if (!rough() || mean_wind() == glm::vec3(0.0f))
        return false;
    const Roughness& ground = *config.roughness;
    if (config.profile)
        return ground.map || ground.length != config.profile->roughness_length;
    return config.boundaries.y_low.kind == BoundaryKind::free_slip;
}

// Rows of an active canopy; no drag where none reaches the box.
CanopyRows WindCore::canopy_rows() const {
    if (!config.canopy || !config.stages.sources || config.canopy->height <= 0.0f || config.canopy->drag <= 0.0f)
        return {};
    const double h = config.cell_size, low = ambient.ground() - place.window.origin().y;
    const double height = static_cast<double>(config.canopy->height);
    const double ground = rows ? rows->place(low) : low / h, top = rows ? rows->place(low + height) : ground + height / h;
    if (top <= 0.0 || ground >= config.cells.y)
        return {};
    const double farthest = 2.0 * k_max_axis_cells; // no effect beyond the box, and exact in float
    return {.drag = config.canopy->drag,
            .ground = static_cast<float>(std::max(ground, -farthest)),
            .top = static_cast<float>(std::min(top, farthest))};
}

// --- The wind around the box -------------------------------------------------------------------------------------------------
//
// It is the mean wind, the same everywhere or by its profile, and gusts.

void WindCore::renew_ambient() {
    ambient.set_gust_axes(gust_axes(config.boundaries) * (outer ? outer->ambient_wind().gust_axes() : glm::vec3(1.0f)));
    (void)ambient.set_mean(mean_wind());
    const Window& window = place.window; // without a floor height 0 moves with the world's origin
    (void)ambient.set_ground(config.boundaries.y_low.solid() ? window.origin().y
                                                             : window.units().y * static_cast<double>(window.shifted.y));
}

CellChange WindCore::change(CellChange::Kind kind) const {
    return {.kind = kind, .ambient = ambient, .window = place.window, .kept = frames.has_value()};
}

void WindCore::add_ambient(float factor) {
    CellChange wind = change(CellChange::Kind::add_wind);
    wind.factor = factor;
    apply(wind);
}

void WindCore::fill_with_ambient() {
    apply(CellChange::Kind::fill);
    source_name = 0;
    sleep.fill();
}

void WindCore::take_ambient_out() {
    if (!sleep.calm())
        add_ambient(-1.0f);
}

void WindCore::put_ambient_in() {
    renew_ambient();
    if (sleep.calm()) {
        fill_with_ambient();
        if (frames)
            apply(CellChange::Kind::fill_before);
    } else {
        add_ambient(1.0f);
    }
    sleep.stir();
}

} // namespace windrow
