// Step of the air on the CPU.
//
// Second order (two-time-level semi-implicit semi-Lagrangian, as in weather models), du/dt = -grad p + nu L u + f:
//
//   R  = u - s q + (dt/2) f                    half of pressure and force act at departure, half at arrival
//   xd = departure of x                        SETTLS, advect() in operators.h
//   w  = R(xd) + (dt/2) f
//   u' = w - grad phi,  L phi = div w          project()
//   q' = (dt/2) grad p                         and s: shaders/numerics/history.glsl
//
// All values at cell centres. Order 2 in time at fixed CFL for any step lengths, with one cubic interpolation and one projection
// a step. Viscosity acts on u before R is formed: added after the advection it feeds an instability at CFL 1. Drives and plants
// act for half of the step at departure and half at arrival (shaders/numerics/splitting.glsl).
//
// Two parts of u may be prescribed. The step then advects and projects the perturbation v = u - u_S - A along the whole wind u:
//
//   dv/dt + u . grad v = -grad p + nu L v + f - (u - A) . grad A
//
// u_S is the flow of volume sources (blasts, vents, suction), which prescribe div u = S. It is the potential flow u_S = grad psi,
// L psi = S. It is projected by itself, around obstacles, when S or they change, and acts at once. The term v . grad u_S is dropped. It is a gradient
// wherever v has no vorticity (a vent in a steady wind comes out exact), otherwise the straining of v's vorticity by the source.
// Advected with v, u_S amplifies its own errors: jets grow out of its middle within a second.
//
// A is the ambient wind while it gusts: a frozen pattern, advected by the mean wind inside the box as outside. A is divergence-
// free except for the part that a wall removes. Walls block v, not A. A solved A would evolve inside but not outside, and each
// shift of the box would cause a jump (0.07 m/s in a wind of 2 m/s). Advection of A by v: kernels/advect.inl, carry_prescribed. It
// is 0 to the bit where v = 0.
//
// Stable fluids, the classic split: u' = P(A(D(u + dt f))): complete stages in sequence, order 1.
//
// Based on: Temperton & Staniforth 1987, Quarterly Journal 113; Hortal 2002, ECMWF Technical Memorandum 292; Stam 1999, SIGGRAPH.
#include "fluid/core/numerics.h"
#include "fluid/core/wind_core.h"
#include "fluid/cpu/acting.h"
#include "fluid/cpu/cells.h"
#include "fluid/cpu/stopwatch.h"
#include "fluid/cpu/workspace.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace windrow::cpu {
namespace {

// For a smaller s the history is negligible, and a division by s would lose the forces to rounding.
constexpr float k_min_scale = 1e-6f;

bool finite(const glm::vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

void add_scaled(std::span<glm::vec4> field, std::span<const glm::vec4> other, float factor) {
    for (std::size_t n = 0; n < field.size(); ++n)
        field[n] += factor * other[n];
}

template <class Visit>
void for_each_cell(const Box& box, const Visit& visit) {
    std::size_t n = 0;
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i, ++n)
                visit(n, i, j, k);
}

} // namespace

bool Cells::step(const CellStep& step, Diagnostics& report) {
    const auto dt = static_cast<float>(step.duration);
    work.state().obstacles_ms = 0.0;
    sampled_.held = false;
    refill();
    canopy_ = step.canopy;
    const bool plants_differ = step.drag_change.any() || drag_.any() != step.drag.any() ||
                               (step.drag.any() && drag_origin_ != step.window->origin_cells);
    reading_stale_ = reading_stale_ || (plants_differ && reading_maker_.law().acts());
    drag_ = step.drag;
    drag_origin_ = step.window->origin_cells;
    relaxation_time_ = step.relaxation_time;
    materialise_air_alone(config_.parallel_for);
    materialise_before();
    renew_around(*step.ambient, *step.window, config_.parallel_for);
    AmbientWind wind = around_;
    const glm::dvec3 phase = wind.phase();
    if (outer_)
        outer_->begin_step(*step.window, step.outer_way, config_.parallel_for);
    bodies_move_ = std::any_of(step.obstacles.begin(), step.obstacles.end(), [](const auto& body) { return body.moves(); });
    loads.begin(dt);
    // For the first sub-step: volume sources find bodies that move where the air meets them.
    const int places = std::max(step.substeps, 1);
    report.substeps = places;
    const bool others = place_obstacles(step, step.duration * (places - 1) / places, report);
    add_sources(step, others, report);
    limit_speeds(step, report);
    for (int part = 0; part < report.substeps; ++part) {
        const float part_dt = dt / static_cast<float>(report.substeps);
        wind.set_phase(phase);
        wind.advance(step.duration * (part + 1) / report.substeps);
        next_phase_ = wind.phase();
        if (outer_)
            outer_->begin_part(part, report.substeps, config_.parallel_for);
        if (bodies_move_ && part > 0)
            (void)place_obstacles(step, step.duration * (report.substeps - part - 1) / report.substeps, report);
        if (const Solids* const solids = work.state().solids.get())
            report.sealed_rooms = std::max(report.sealed_rooms, solids->squeezed());
        if (!config_.stages.advection)
            advance_in_place(part_dt, report);
        else if (config_.scheme == Scheme::second_order)
            advance_second_order(part_dt, report);
        else
            advance_stable_fluids(part_dt, report);
        inside_is_air_ = false;
    }
    work.state().fastest.reset();
    *step.ambient = around_;
    if (outer_)
        outer_->end_step();
    if (const Solids* const solids = work.state().solids.get())
        report.filling_obstacles = solids->filling();
    measure(report);
    // What forces and pressure have made of the air since.
    if (const float most = fastest_carried(dt);
        config_.stages.advection && report.max_speed > numerics::windrow_speed_rounding * most) {
        cut_speeds(most, report);
        measure(report);
    }
    measured_ = {.tick = step.tick, .largest = report.max_speed, .still = step.may_rest && at_ambient()};
    if (step.rests) {
        fill_air();
        measure(report); // again: the air is ambient now
    }
    report.times_ms.obstacles += work.state().obstacles_ms;
    if (report.repaired_cells > 0 && step.kept) // their kept values are not visible
        keep();
    return step.rests;
}

// In gusts the perturbation is 0 beyond the open boundaries; only trajectories see the whole ambient wind there.
class Cells::Solving {
  public:
    Solving(Cells& cells, Diagnostics& report)
        : workspace_(cells.work.state()), ambient_(workspace_.ambient), mean_cells_(workspace_.mean_cells) {
        if (!cells.around_.gusting())
            return;
        workspace_.ambient = glm::vec3(0.0f);
        workspace_.mean_cells = nullptr;
        cells.foresee_gusts(report);
        const float strength = cells.around_.gust_strength(), still = cells.config_.sleep_speed;
        const glm::vec3 mean = cells.around_.mean();
        workspace_.prescribed = {.now = cells.ambient_field_.data(),
                                 .next = cells.ambient_next_.data(),
                                 .source_flow = cells.has_source_flow() ? &cells.source_flow[0].x : nullptr,
                                 .gusts_squared = strength * strength,
                                 .still_squared = still * still,
                                 .legal = {},
                                 .bends = cells.profile_bends_.empty() ? nullptr : cells.profile_bends_.data(),
                                 .mean = {mean.x, mean.y, mean.z, 0.0f}};
    }
    ~Solving() {
        workspace_.ambient = ambient_;
        workspace_.mean_cells = mean_cells_;
        workspace_.prescribed = {};
    }
    Solving(const Solving&) = delete;
    Solving& operator=(const Solving&) = delete;

  private:
    Workspace::State& workspace_;
    glm::vec3 ambient_;
    const float* mean_cells_;
};

void Cells::advance_second_order(float dt, Diagnostics& report) {
    const bool has_past = !air.fresh;
    if (!has_past && numerics::windrow_rehearses(report.cfl, report.substeps))
        rehearse(dt, report);
    perform(dt, pressure_solves(config_, has_past), report);
}

// The first step of a flow has no pressure q and no u_old to extrapolate from. Without them it would lose energy once, by dt^2.
// So it is done twice, and the first time gives q and u_old = 2 u - u'.
void Cells::rehearse(float dt, Diagnostics& report) {
    const float undiffused = air.undiffused_time;
    const glm::dvec3 phase = around_.phase();
    perform(dt, pressure_solves(config_, false), report);
    loads.forget_pressure();
    std::swap(air.velocity, air.velocity_old);
    for (std::size_t n = 0; n < air.velocity.size(); ++n)
        air.velocity_old[n] = 2.0f * air.velocity[n] - air.velocity_old[n];
    air.undiffused_time = undiffused;
    if (!around_.gusting())
        return;
    around_.set_phase(phase);
    std::swap(ambient_field_, ambient_next_);
    work.state().ambient_cells = ambient_field_.data();
}

void Cells::perform(float dt, int solves, Diagnostics& report) {
    extend_into_bodies();
    const Solving solving(*this, report);
    const std::span<const glm::vec4> carried = mix(diffuse(without_prescribed(), dt, report), dt, report);
    Transport transport{.carried = carried, .velocity = air.velocity, .dt = dt, .interpolation = config_.interpolation};
    transport.relaxation = relaxation(dt);
    const numerics::WindrowPast past = numerics::windrow_past(air.fresh ? 0.0f : dt / air.dt_old);
    if (!air.fresh) {
        transport.velocity_old = air.velocity_old;
        transport.extrapolation = past.scale;
        transport.history = air.history;
        transport.history_scale = past.scale;
    }
    const Acting acting(sources, {.cells = box().cells,
                                  .dt = dt,
                                  .substeps = report.substeps,
                                  .plants = canopy_,
                                  .deposits = drag_,
                                  .kernels = work.state().kernels,
                                  .parallel_for = &config_.parallel_for});
    const auto prescribed_wind = [&](std::size_t n, glm::ivec3 cell, std::span<glm::vec4> winds) {
        return write_prescribed(n, cell, winds);
    };
    const float left = transport.relaxation;
    const auto departing = [&](std::size_t n, glm::ivec3 cell, std::span<glm::vec4> winds) {
        if (!write_prescribed(n, cell, winds))
            std::fill(winds.begin(), winds.end(), glm::vec4(0.0f));
        for (std::size_t i = 0; i < winds.size(); ++i, ++n, ++cell.x) {
            glm::vec4 u = carried[n];
            if (left != 1.0f) {
                const glm::vec4 rest = rest_at(n, cell.x, cell.y, cell.z);
                u = rest + left * (u - rest);
            }
            winds[i] = u + winds[i];
        }
        return true;
    };
    const bool even = !has_source_flow() && !outer_ && !around_.gusting() && !config_.profile && !work.state().has_solids();
    const Acting::EvenAir departing_evenly{
        .carried = even ? carried.data() : nullptr, .left = left, .rest = left != 1.0f ? mean_at(0, 0, 0) : glm::vec4(0.0f)};
    if (acting.any()) {
        if (!(transport.history_scale > k_min_scale)) {
            std::fill_n(air.history.data(), air.history.size(), glm::vec4(0.0f));
            transport.history_scale = 1.0f;
        }
        transport.history = air.history;
        acting.depart(departing, departing_evenly, transport.history_scale, air.history);
        if (work.state().has_solids()) { // a read beside a body finds air that is pushed too
            const Stopwatch watch("windrow obstacles", work.state().obstacles_ms);
            work.state().solid_flow().extend_history(air.history);
        }
    }
    const std::span<glm::vec4> arrived = air.velocity_old;
    {
        OuterStopwatch watch("windrow advection", report.times_ms.advection, work.state().obstacles_ms);
        advect_among(transport, arrived);
    }
    carry_gusts();
    if (acting.any())
        acting.arrive(prescribed_wind, transport.history_scale, air.history, arrived);
    {
        OuterStopwatch watch("windrow projection", report.times_ms.projection, work.state().obstacles_ms);
        if (config_.stages.projection) {
            const std::optional<OuterWind::Sides> sides = outer_ ? std::optional<OuterWind::Sides>(*outer_) : std::nullopt;
            project_around(arrived, {.field = air.history, .weight = past.weight, .kept = past.kept}, past.scale, solves, report,
                           sides ? &*sides : nullptr);
            note_pressure(dt, past);
        } else {
            std::fill_n(air.history.data(), air.history.size(), glm::vec4(0.0f));
            potential_weight_ = 0.0f;
        }
    }
    add_prescribed(arrived, 1.0f);
    bound_rooms(air.velocity, arrived);
    std::swap(air.velocity, air.velocity_old);
    forget_inside();
    air.fresh = false;
    air.dt_old = dt;
}

void Cells::advance_stable_fluids(float dt, Diagnostics& report) {
    sources.add_force_to(air.velocity, dt, config_.parallel_for);
    extend_into_bodies();
    const Solving solving(*this, report);
    const std::span<const glm::vec4> carried = mix(diffuse(without_prescribed(), dt, report), dt, report);
    Transport transport{
        .carried = carried, .velocity = air.velocity, .extrapolation = 0.0f, .dt = dt, .interpolation = config_.interpolation};
    transport.relaxation = relaxation(dt);
    {
        OuterStopwatch watch("windrow advection", report.times_ms.advection, work.state().obstacles_ms);
        windrow::advect(work, transport, air.velocity_old);
    }
    carry_gusts();
    if (config_.stages.projection) {
        OuterStopwatch watch("windrow projection", report.times_ms.projection, work.state().obstacles_ms);
        project_around(air.velocity_old, {}, 1.0f, pressure_solves(config_, true), report);
    }
    add_prescribed(air.velocity_old, 1.0f);
    bound_rooms(air.velocity, air.velocity_old);
    std::swap(air.velocity, air.velocity_old);
}

// Without advection there are no trajectories to centre on: each stage acts whole on u.
void Cells::advance_in_place(float dt, Diagnostics& report) {
    extend_into_bodies();
    const Solving solving(*this, report);
    const ParallelFor& parallel_for = config_.parallel_for;
    sources.add_force_to(air.velocity, dt, parallel_for);
    if (const auto carried = mix(diffuse(without_prescribed(), dt, report), dt, report); carried.data() != air.velocity.data())
        std::copy(carried.begin(), carried.end(), air.velocity.data());
    if (const float factor = relaxation(dt); factor != 1.0f)
        for_each_cell(box(), [&](std::size_t n, int i, int j, int k) {
            const glm::vec4 rest = rest_at(n, i, j, k);
            air.velocity[n] = rest + factor * (air.velocity[n] - rest);
        });
    carry_gusts();
    if (config_.stages.projection) {
        OuterStopwatch watch("windrow projection", report.times_ms.projection, work.state().obstacles_ms);
        project_around(air.velocity, {}, 1.0f, pressure_solves(config_, true), report);
    }
    add_prescribed(air.velocity, 1.0f);
    air.fresh = true;
}

// `other_obstacles`: they were placed again in this step.
void Cells::add_sources(const CellStep& step, bool other_obstacles, Diagnostics& report) {
    OuterStopwatch watch("windrow sources", report.times_ms.sources, work.state().obstacles_ms);
    const glm::vec4* const eddies = step.tile ? step.tile->texels().data() : nullptr;
    sources.gather(step.motors, box(), air.velocity, {eddies}, config_.parallel_for, inside_bodies());
    seal_sources(step.motors, report);
    if (acts_whole())
        act_whole(static_cast<float>(step.duration));
    if (step.renews_sources || (other_obstacles && has_source_flow()))
        renew_source_flow(step.motors);
}

bool Cells::acts_whole() const {
    return config_.scheme == Scheme::stable_fluids || !config_.stages.advection;
}

// The classic split: drives and drag of the whole step before the advection.
void Cells::act_whole(float dt) {
    sources.drive(air.velocity, config_.parallel_for);
    const DragRows rows{canopy_, drag_, box().cells};
    if (!rows.any())
        return;
    config_.parallel_for(box().cells.z, [&](int k) {
        for (int j = 0; j < box().cells.y; ++j) {
            const DragRows::Row drag = rows.at(j, k);
            glm::vec4* const row = &air.velocity[box().index(0, j, k)];
            for (int i = drag.low; i < drag.high; ++i)
                row[i] = glm::vec4(numerics::windrow_canopy_slowed(glm::vec3(row[i]), dt * drag.of(i)), row[i].w);
        }
    });
}

void Cells::foresee_gusts(Diagnostics& report) {
    Stopwatch watch("windrow ambient", report.times_ms.ambient);
    AmbientWind next = around_;
    next.set_phase(next_phase_);
    ambient_next_.fill(next, wind_.window(), config_.parallel_for);
}

void Cells::carry_gusts() {
    around_.set_phase(next_phase_);
    if (!around_.gusting())
        return;
    std::swap(ambient_field_, ambient_next_);
    work.state().ambient_cells = ambient_field_.data();
}

// Updates the flow of the sources. u_old takes the same change: the trajectories extrapolate u - u_old, which must stay
// continuous.
void Cells::renew_source_flow(std::span<const detail::MotorReach> reached) {
    if (source_flow.empty()) // no source added or removed
        return;
    const auto add_to_air = [&](float factor) {
        add_scaled(air.velocity, source_flow, factor);
        if (!air.fresh)
            add_scaled(air.velocity_old, source_flow, factor);
    };
    add_to_air(-1.0f);
    std::fill_n(source_flow.data(), source_flow.size(), glm::vec4(0.0f));
    if (!has_source_flow())
        return loads.end_sources();
    const bool in_free_air = config_.boundaries.in_free_air();
    if (in_free_air)
        free_air_.gather(reached, box(), open_parts(reached), config_.parallel_for);
    project_sources(in_free_air ? &free_air_ : nullptr);
    add_to_air(1.0f);
}

// v; the velocity itself where nothing is prescribed.
std::span<const glm::vec4> Cells::without_prescribed() {
    if (!has_source_flow() && !around_.gusting())
        return air.velocity;
    std::copy_n(air.velocity.data(), air.velocity.size(), solved.data());
    add_prescribed(solved, -1.0f);
    if (work.state().has_solids()) {
        const Stopwatch watch("windrow obstacles", work.state().obstacles_ms);
        work.state().solid_flow().extend(solved, prescribed());
    }
    return solved;
}

void Cells::add_prescribed(std::span<glm::vec4> field, float factor) {
    if (has_source_flow())
        add_scaled(field, source_flow, factor);
    if (around_.gusting())
        add_ambient(field, factor);
}

// The guard reads every cell before anything spreads it; the CFL number is taken after the sources, in the largest component.
void Cells::limit_speeds(const CellStep& step, Diagnostics& report) {
    const auto dt = static_cast<float>(step.duration);
    Stopwatch watch("windrow sources", report.times_ms.sources);
    PlaneSurvey found = work.state().survey(&air.velocity[0].x);
    if (found.nonfinite_cells > 0) {
        repair_cells();
        report.repaired_cells = found.nonfinite_cells;
        found = work.state().survey(&air.velocity[0].x);
    }
    const float largest = acts_whole() ? found.largest_component : std::max(found.largest_component, sources.largest_driven());
    work.state().fastest = largest + dt * sources.largest_force(); // as the device counts them: reads reach equally far
    if (box().rows && work.state().has_solids())
        work.state().fastest =
            work.state().fastest_by_rows(&air.velocity[0].x) + dt * sources.largest_force() * box().cell_size / box().finest();
    report.cfl = numerics::windrow_courant(largest, sources.largest_force(), dt, box().cell_size);
    report.substeps = std::max(step.substeps, 1);
    if (!config_.stages.advection || report.cfl <= config_.max_cfl)
        return;
    const float wanted = numerics::windrow_wanted_substeps(report.cfl, config_.max_cfl);
    report.substeps_capped =
        wanted > static_cast<float>(config_.max_substeps) && (step.substeps == 0 || step.substeps == config_.max_substeps);
    if (step.substeps == 0)
        report.substeps = numerics::windrow_substeps(wanted, config_.max_substeps);
    if (!report.substeps_capped)
        return;
    sources.limit_drives(fastest_carried(dt));
    cut_speeds(fastest_carried(dt), report);
}

float Cells::fastest_carried(float dt) const {
    return numerics::windrow_fastest_carried(config_.max_cfl, config_.max_substeps, box().cell_size, dt);
}

// The flow of volume sources is scaled by the same factor as the wind that contains it.
void Cells::cut_speeds(float most, Diagnostics& report) {
    for (std::size_t n = 0; n < air.velocity.size(); ++n) {
        glm::vec4& u = air.velocity[n];
        const float largest = std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)});
        if (largest <= most)
            continue;
        u *= most / largest;
        if (has_source_flow())
            source_flow[n] *= most / largest;
        ++report.limited_cells;
    }
}

void Cells::repair_cells() {
    for_each_cell(box(), [&](std::size_t n, int i, int j, int k) {
        if (finite(air.velocity[n]))
            return;
        air.velocity[n] = air.velocity_old[n] = around_at(n, i, j, k);
        air.history[n] = glm::vec4(0.0f);
    });
}

void Cells::measure(Diagnostics& report) {
    materialise_air_alone(config_.parallel_for);
    OuterStopwatch watch("windrow report", report.times_ms.report, work.state().obstacles_ms);
    Workspace::State& state = work.state();
    const float h = box().cell_size;
    const float* const velocity = &air.velocity[0].x;
    PlaneSurvey found =
        config_.stages.projection ? state.survey_with_divergence(velocity, sources.expansion()) : state.survey(velocity);
    if (state.has_solids()) {
        const Stopwatch at_bodies("windrow obstacles", state.obstacles_ms);
        const double more = state.solid_flow().correct_divergence(air.velocity, sources.expansion(), state.residual_terms);
        found.divergence_squares = std::max(found.divergence_squares + more, 0.0);
    }
    report.max_speed = found.largest_component;
    report.energy = 0.5 * found.squares * h * h * h;
    report.divergence_rms = std::sqrt(found.divergence_squares / static_cast<double>(box().cell_count()));
}

} // namespace windrow::cpu
