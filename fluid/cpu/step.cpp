// One step of the air on the CPU.
//
// Second order (two-time-level semi-implicit semi-Lagrangian, the practice of weather models), du/dt = -grad p + nu L u + f:
//
//   R  = u - s q + (dt/2) f                    half of pressure and force act at departure, half at arrival
//   xd = departure of x                        SETTLS, advect() in pieces.h
//   w  = R(xd) + (dt/2) f
//   u' = w - grad phi,  L phi = div w          project()
//   q' = (dt/2) grad p                         and s: shaders/numerics/history.glsl
//
// All values at cell centres. Order 2 in time at fixed CFL, whatever the steps' lengths, with one cubic interpolation and one
// projection a step. Viscosity acts on u before R is formed: added after the advection it feeds an instability at CFL 1. Drives
// and plants hold the air for half of the step at departure and half at arrival (shaders/numerics/splitting.glsl).
//
// Two parts of u may be given, not solved; the step then carries and projects the rest, v = u - u_S - A, along the whole wind u:
//
//   dv/dt + u . grad v = -grad p + nu L v + f - (u - A) . grad A
//
// u_S, the flow of sources of air (blasts, vents, suction), which prescribe div u = S: the potential flow u_S = grad psi, L psi =
// S, projected by itself when S changes; it stands at once. What is left out, v . grad u_S, is a gradient wherever v has no
// vorticity (a vent in a steady wind comes out exact), else the straining of v's vorticity by the source. Carried with the rest,
// u_S feeds on its errors: jets grow out of its middle within a second. A, the ambient wind while it gusts: a frozen pattern,
// free of divergence but for what a wall drops of it, that the mean wind carries through the box as it does outside. Walls hold
// back v, not A. Solved, A would evolve inside but not outside, and each shift of the box would be felt as a jolt (0.07 m/s in a
// wind of 2 m/s). What the rest carries of A stands in kernels/advect.inl, carry_given: it is 0 to the bit where nothing else blows.
//
// Stable fluids, the classic split: u' = P(A(D(u + dt f))): every stage whole and one after the other, order 1.
//
// Based on: Temperton & Staniforth 1987, Quarterly Journal 113; Hortal 2002, ECMWF Technical Memorandum 292; Stam 1999, SIGGRAPH.
#include "fluid/cpu/workspace.h"
#include "fluid/numerics.h"
#include "fluid/wind_state.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace windrow {
namespace {

constexpr float k_rounding = 1.00001f; // of a speed that was cut and carried along

// For a smaller s the history is negligible, and a division by s would lose the forces to rounding.
constexpr float k_least_scale = 1e-6f;

// Adds the time of a scope to a stage's figure.
class Stopwatch {
  public:
    explicit Stopwatch(double& milliseconds) : milliseconds_(milliseconds), start_(std::chrono::steady_clock::now()) {}
    ~Stopwatch() {
        milliseconds_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    double& milliseconds_;
    std::chrono::steady_clock::time_point start_;
};

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

float settling_factor(const Config& config, float dt) {
    return config.stages.settling && config.settling_time > 0.0f ? 1.0f / (1.0f + dt / config.settling_time) : 1.0f;
}

} // namespace

void Wind::State::step_cells(double duration, std::span<const detail::MotorReach> reached, Diagnostics& report) {
    const auto dt = static_cast<float>(duration);
    hold_ambient_alone(config.parallel_for);
    hold_before();
    AmbientWind wind = ambient;
    const glm::dvec3 phase = wind.phase();
    add_sources(dt, reached, report);
    limit_speeds(dt, report);
    for (int part = 0; part < report.substeps; ++part) {
        const float part_dt = dt / static_cast<float>(report.substeps);
        wind.set_phase(phase);
        wind.advance(duration * (part + 1) / report.substeps);
        next_phase = wind.phase();
        if (!config.stages.advection)
            advance_in_place(part_dt, report);
        else if (config.scheme == Scheme::second_order)
            advance_second_order(part_dt, report);
        else
            advance_stable_fluids(part_dt, report);
    }
    measure(report);
    // What forces and pressure have made of the air since.
    if (const float most = fastest_carried(dt); config.stages.advection && report.max_speed > k_rounding * most) {
        cut_speeds(most, report);
        measure(report);
    }
}

// While the wind gusts, what is solved is still air beyond the open sides; trajectories alone meet the whole ambient wind there.
class Wind::State::Solving {
  public:
    Solving(State& state, Diagnostics& report)
        : around_(state.work.state()), ambient_(around_.ambient), mean_cells_(around_.mean_cells) {
        if (!state.ambient.gusting())
            return;
        around_.ambient = glm::vec3(0.0f);
        around_.mean_cells = nullptr;
        state.foresee_gusts(report);
        const float strength = state.ambient.gust_strength(), still = state.config.sleep_speed;
        const glm::vec3 mean = state.ambient.mean();
        around_.given = {.now = state.ambient_field.data(),
                         .next = state.ambient_next.data(),
                         .source_flow = state.sources_of_air != 0 ? &state.source_flow[0].x : nullptr,
                         .gusts_squared = strength * strength,
                         .still_squared = still * still,
                         .legal = {},
                         .bends = state.profile_bends.empty() ? nullptr : state.profile_bends.data(),
                         .mean = {mean.x, mean.y, mean.z, 0.0f}};
    }
    ~Solving() {
        around_.ambient = ambient_;
        around_.mean_cells = mean_cells_;
        around_.given = {};
    }
    Solving(const Solving&) = delete;
    Solving& operator=(const Solving&) = delete;

  private:
    Workspace::State& around_;
    glm::vec3 ambient_;
    const float* mean_cells_;
};

void Wind::State::advance_second_order(float dt, Diagnostics& report) {
    if (air.fresh && numerics::windrow_rehearses(report.cfl, report.substeps))
        rehearse(dt, report);
    perform(dt, report);
}

// The first step of a flow has no pressure q and no u_old to extrapolate from. Without them it would lose energy once, by dt^2; so
// it is done twice, and the first time gives q and u_old = 2 u - u'.
void Wind::State::rehearse(float dt, Diagnostics& report) {
    const float undiffused = air.owed_diffusion;
    const glm::dvec3 phase = ambient.phase();
    perform(dt, report);
    std::swap(air.velocity, air.velocity_old);
    for (std::size_t n = 0; n < air.velocity.size(); ++n)
        air.velocity_old[n] = 2.0f * air.velocity[n] - air.velocity_old[n];
    air.owed_diffusion = undiffused;
    if (!ambient.gusting())
        return;
    ambient.set_phase(phase);
    std::swap(ambient_field, ambient_next);
    work.state().ambient_cells = ambient_field.data();
}

void Wind::State::perform(float dt, Diagnostics& report) {
    const Solving solving(*this, report);
    const std::span<const glm::vec4> carried = diffuse(without_given_flow(), dt, report);
    Transport transport{.carried = carried, .velocity = air.velocity, .dt = dt, .interpolation = config.interpolation};
    transport.settling = settling_factor(config, dt);
    const numerics::WindrowPast past = numerics::windrow_past(air.fresh ? 0.0f : dt / air.dt_old);
    if (!air.fresh) {
        transport.velocity_old = air.velocity_old;
        transport.extrapolation = past.scale;
        transport.history = air.history;
        transport.history_scale = past.scale;
    }
    const cpu::Acting acting(sources, {.cells = box().cells,
                                       .dt = dt,
                                       .substeps = report.substeps,
                                       .plants = canopy_rows().value_or(cpu::CanopyRows{}),
                                       .parallel_for = &config.parallel_for});
    const bool gusting = ambient.gusting();
    const auto given = [&](std::size_t n, glm::ivec3 cell) {
        glm::vec3 u(0.0f);
        if (sources_of_air != 0)
            u += glm::vec3(source_flow[n]);
        if (gusting)
            u += glm::vec3(ambient_at(cell.x, cell.y, cell.z));
        return u;
    };
    const auto departing = [&](std::size_t n, glm::ivec3 cell) {
        glm::vec3 u(carried[n]);
        if (transport.settling != 1.0f) {
            const glm::vec3 rest = gusting ? glm::vec3(0.0f) : glm::vec3(mean_at(cell.x, cell.y, cell.z));
            u = rest + transport.settling * (u - rest);
        }
        return u + given(n, cell);
    };
    if (acting.any()) {
        if (!(transport.history_scale > k_least_scale)) {
            std::fill_n(air.history.data(), air.history.size(), glm::vec4(0.0f));
            transport.history_scale = 1.0f;
        }
        transport.history = air.history;
        acting.depart(departing, transport.history_scale, air.history);
    }
    const std::span<glm::vec4> arrived = air.velocity_old;
    {
        Stopwatch watch(report.times_ms.advection);
        advect(work, transport, arrived);
    }
    carry_gusts();
    if (acting.any())
        acting.arrive(given, transport.history_scale, air.history, arrived);
    {
        Stopwatch watch(report.times_ms.projection);
        if (config.stages.projection)
            work.state().project(arrived, {}, {.field = air.history, .weight = past.weight, .kept = past.kept});
        else
            std::fill_n(air.history.data(), air.history.size(), glm::vec4(0.0f));
    }
    add_given_flow(arrived, 1.0f);
    std::swap(air.velocity, air.velocity_old);
    air.fresh = false;
    air.dt_old = dt;
}

void Wind::State::advance_stable_fluids(float dt, Diagnostics& report) {
    const Solving solving(*this, report);
    sources.add_force_to(air.velocity, dt, config.parallel_for);
    const std::span<const glm::vec4> carried = diffuse(without_given_flow(), dt, report);
    Transport transport{
        .carried = carried, .velocity = air.velocity, .extrapolation = 0.0f, .dt = dt, .interpolation = config.interpolation};
    transport.settling = settling_factor(config, dt);
    {
        Stopwatch watch(report.times_ms.advection);
        advect(work, transport, air.velocity_old);
    }
    if (config.stages.projection) {
        Stopwatch watch(report.times_ms.projection);
        project(work, air.velocity_old);
    }
    carry_gusts();
    add_given_flow(air.velocity_old, 1.0f);
    std::swap(air.velocity, air.velocity_old);
}

// Without transport there is no trajectory to centre anything on: each stage acts whole on u.
void Wind::State::advance_in_place(float dt, Diagnostics& report) {
    const Solving solving(*this, report);
    const ParallelFor& parallel_for = config.parallel_for;
    sources.add_force_to(air.velocity, dt, parallel_for);
    add_given_flow(air.velocity, -1.0f);
    if (const auto carried = diffuse(air.velocity, dt, report); carried.data() != air.velocity.data())
        std::copy(carried.begin(), carried.end(), air.velocity.data());
    if (const float factor = settling_factor(config, dt); factor != 1.0f)
        for_each_cell(box(), [&](std::size_t n, int i, int j, int k) {
            const glm::vec4 rest = ambient.gusting() ? glm::vec4(0.0f) : mean_at(i, j, k);
            air.velocity[n] = rest + factor * (air.velocity[n] - rest);
        });
    if (config.stages.projection) {
        Stopwatch watch(report.times_ms.projection);
        project(work, air.velocity);
    }
    carry_gusts();
    add_given_flow(air.velocity, 1.0f);
    air.fresh = true;
}

void Wind::State::add_sources(float dt, std::span<const detail::MotorReach> reached, Diagnostics& report) {
    Stopwatch watch(report.times_ms.sources);
    const auto& tile = motors.tile(ambient.tile());
    sources.gather(reached, box().cell_size, air.velocity, {tile ? tile->texels().data() : nullptr}, config.parallel_for);
    if (acts_whole())
        hold_whole(dt);
    if (config.stages.projection)
        let_air_in(reached);
}

bool Wind::State::acts_whole() const {
    return config.scheme == Scheme::stable_fluids || !config.stages.advection;
}

// The classic split: drives and drag of the whole step before the advection.
void Wind::State::hold_whole(float dt) {
    sources.drive(air.velocity, config.parallel_for);
    const auto plants = canopy_rows();
    if (!plants)
        return;
    const glm::ivec3 cells = box().cells;
    config.parallel_for(cells.z, [&](int k) {
        for (int j = 0; j < cells.y; ++j) {
            const float way = dt * plants->drag_of(j);
            if (!(way > 0.0f))
                continue;
            glm::vec4* const row = &air.velocity[box().index(0, j, k)];
            for (int i = 0; i < cells.x; ++i)
                row[i] = glm::vec4(numerics::windrow_canopy_slowed(glm::vec3(row[i]), way), 0.0f);
        }
    });
}

void Wind::State::foresee_gusts(Diagnostics& report) {
    Stopwatch watch(report.times_ms.ambient);
    AmbientWind next = ambient;
    next.set_phase(next_phase);
    ambient_next.fill(next, window, config.parallel_for);
}

void Wind::State::carry_gusts() {
    ambient.set_phase(next_phase);
    if (!ambient.gusting())
        return;
    std::swap(ambient_field, ambient_next);
    work.state().ambient_cells = ambient_field.data();
}

// Brings the flow of the sources up to date. u_old takes the same change: the trajectories extrapolate u - u_old, which must not
// see a jump.
void Wind::State::let_air_in(std::span<const detail::MotorReach> reached) {
    if (!renew_sources(reached))
        return;
    if (source_flow.empty()) // none came and none went
        return;
    const auto add_to_air = [&](float factor) {
        add_scaled(air.velocity, source_flow, factor);
        if (!air.fresh)
            add_scaled(air.velocity_old, source_flow, factor);
    };
    add_to_air(-1.0f);
    std::fill_n(source_flow.data(), source_flow.size(), glm::vec4(0.0f));
    if (sources_of_air == 0)
        return;
    const bool in_free_air = config.sides.in_free_air();
    if (in_free_air)
        free_air.gather(reached, box(), config.parallel_for);
    work.state().project(source_flow, sources.expansion(), {}, in_free_air ? &free_air : nullptr);
    add_to_air(1.0f);
}

void Wind::State::make_room(double dt) {
    if (config.stages.sources && config.stages.projection && motors.has_volume_source()) {
        if (source_flow.empty())
            source_flow = cpu::Buffer<glm::vec4>(air.velocity.size());
        reserve_solved();
        if (config.sides.in_free_air())
            free_air.make_room(box());
    }
    const auto duration = static_cast<float>(dt);
    if (!viscous(duration))
        return;
    const DiffusionMethod method = diffusion_method(config.viscosity, air.owed_diffusion + duration, config.cell_size);
    if (method != DiffusionMethod::none && diffused.empty())
        diffused = cpu::Buffer<glm::vec4>(air.velocity.size());
    if (method == DiffusionMethod::implicit)
        work.state().reserve_diffusion();
}

void Wind::State::reserve_solved() {
    if (solved.empty())
        solved = cpu::Buffer<glm::vec4>(air.velocity.size());
}

// v; the velocity itself where nothing is given.
std::span<const glm::vec4> Wind::State::without_given_flow() {
    if (sources_of_air == 0 && !ambient.gusting())
        return air.velocity;
    std::copy_n(air.velocity.data(), air.velocity.size(), solved.data());
    add_given_flow(solved, -1.0f);
    return solved;
}

void Wind::State::add_given_flow(std::span<glm::vec4> field, float factor) const {
    if (sources_of_air != 0)
        add_scaled(field, source_flow, factor);
    if (ambient.gusting())
        add_ambient(field, factor);
}

// The guard reads every cell before anything spreads it; the CFL number is taken after the sources, in the largest component.
void Wind::State::limit_speeds(float dt, Diagnostics& report) {
    Stopwatch watch(report.times_ms.sources);
    cpu::PlaneSurvey found = work.state().survey(&air.velocity[0].x);
    if (found.broken_cells > 0) {
        repair_broken_cells();
        report.repaired_cells = found.broken_cells;
        found = work.state().survey(&air.velocity[0].x);
    }
    report.substeps = 1;
    const float largest = acts_whole() ? found.largest_component : std::max(found.largest_component, sources.largest_driven());
    report.cfl = (largest + dt * sources.largest_force()) * dt / box().cell_size;
    if (!config.stages.advection || report.cfl <= config.max_cfl)
        return;
    const float wanted = std::ceil(report.cfl / config.max_cfl);
    report.substeps_capped = wanted > static_cast<float>(config.max_substeps);
    report.substeps = report.substeps_capped ? config.max_substeps : static_cast<int>(wanted);
    if (!report.substeps_capped)
        return;
    sources.limit_drives(fastest_carried(dt));
    cut_speeds(fastest_carried(dt), report);
}

float Wind::State::fastest_carried(float dt) const {
    return config.max_cfl * static_cast<float>(config.max_substeps) * box().cell_size / dt;
}

// The flow of volume sources is scaled by the same factor as the wind that contains it.
void Wind::State::cut_speeds(float most, Diagnostics& report) {
    for (std::size_t n = 0; n < air.velocity.size(); ++n) {
        glm::vec4& u = air.velocity[n];
        const float largest = std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)});
        if (largest <= most)
            continue;
        u *= most / largest;
        if (sources_of_air != 0)
            source_flow[n] *= most / largest;
        ++report.limited_cells;
    }
}

void Wind::State::repair_broken_cells() {
    for_each_cell(box(), [&](std::size_t n, int i, int j, int k) {
        if (finite(air.velocity[n]))
            return;
        air.velocity[n] = air.velocity_old[n] = ambient_at(i, j, k);
        air.history[n] = glm::vec4(0.0f);
    });
}

// The velocity after diffusion: itself where viscosity asks for nothing. What a sub-step is too short for is owed: left out, it
// would be left out for good, however many sub-steps follow.
std::span<const glm::vec4> Wind::State::diffuse(std::span<const glm::vec4> field, float dt, Diagnostics& report) {
    if (!viscous(dt))
        return field;
    air.owed_diffusion += dt;
    const DiffusionMethod method = diffusion_method(config.viscosity, air.owed_diffusion, box().cell_size);
    report.diffusion = method;
    if (method == DiffusionMethod::none)
        return field;
    Stopwatch watch(report.times_ms.diffusion);
    (void)windrow::diffuse(work, field, config.viscosity, std::exchange(air.owed_diffusion, 0.0f), diffused);
    return diffused;
}

void Wind::State::measure(Diagnostics& report) {
    hold_ambient_alone(config.parallel_for);
    Stopwatch watch(report.times_ms.report);
    Workspace::State& state = work.state();
    const float h = box().cell_size;
    const float* const velocity = &air.velocity[0].x;
    const cpu::PlaneSurvey found =
        config.stages.projection ? state.survey_with_divergence(velocity, sources.expansion()) : state.survey(velocity);
    report.max_speed = found.largest_component;
    report.energy = 0.5 * found.squares * h * h * h;
    report.divergence_rms = std::sqrt(found.divergence_squares / static_cast<double>(box().cell_count()));
}

// Looks no further than the first cell that still moves: it costs next to nothing until the air has settled.
bool Wind::State::at_ambient() const {
    const glm::ivec3 cells = window.cells;
    std::size_t n = 0;
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i, ++n) {
                const glm::vec4 apart = air.velocity[n] - ambient_at(i, j, k);
                if (!(std::abs(apart.x) < config.sleep_speed && std::abs(apart.y) < config.sleep_speed &&
                      std::abs(apart.z) < config.sleep_speed))
                    return false;
            }
    return true;
}

} // namespace windrow
