// One step of the air on the CPU.
//
// Second order (two-time-level semi-implicit semi-Lagrangian, the practice of weather models), du/dt = -grad p + nu L u + f:
//
//   R  = u - s q                              s = min(2, dt / dt_old)      pressure and force of the last step's arrival half
//   xd = departure of x                        SETTLS, advect() in pieces.h
//   w  = R(xd) + (dt/2) f                      half of the force acts at departure (in q), half at arrival
//   u' = w - grad phi,  L phi = div w          project()
//   q' = grad phi - (dt/2) f                   = (dt/2) (grad p - f)
//
// All values at cell centres. Order 2 in time at fixed CFL with one cubic interpolation and one projection a step. Viscosity acts on u before R is
// formed: added after the advection it feeds an instability at CFL 1. A drive acts whole on u before the step, in its exact form.
//
// Stable fluids, the classic split: u' = P(A(D(u + dt f))): every stage whole and one after the other, order 1.
//
// Based on: Temperton & Staniforth 1987, Quarterly Journal 113; Hortal 2002, ECMWF Technical Memorandum 292; Stam 1999, SIGGRAPH.
#include "fluid/wind_state.h"

#include "fluid/cpu/workspace.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace windrow {
namespace {

// Adds the time of a scope to a stage's figure.
class Stopwatch {
  public:
    explicit Stopwatch(double& milliseconds) : milliseconds_(milliseconds), start_(std::chrono::steady_clock::now()) {}
    ~Stopwatch() { milliseconds_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count(); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    double& milliseconds_;
    std::chrono::steady_clock::time_point start_;
};

bool finite(const glm::vec4& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w); }

float settling_factor(const Config& config, float dt) {
    return config.stages.settling && config.settling_time > 0.0f ? 1.0f / (1.0f + dt / config.settling_time) : 1.0f;
}

} // namespace

Diagnostics Wind::State::step(float dt) {
    Diagnostics report;
    report.stepped = true;
    Stopwatch total(report.times_ms.total);
    add_sources(dt, report);
    limit_speeds(dt, report);
    for (int part = 0; part < report.substeps; ++part) {
        const float part_dt = dt / static_cast<float>(report.substeps);
        if (!config.stages.advection)
            advance_in_place(part_dt, report);
        else if (config.scheme == Scheme::second_order)
            advance_second_order(part_dt, report);
        else
            advance_stable_fluids(part_dt, report);
    }
    measure(report);
    previous_origin_cells = std::exchange(stepped_origin_cells, window.origin_cells);
    return report;
}

void Wind::State::advance_second_order(float dt, Diagnostics& report) {
    const ParallelFor& parallel_for = config.parallel_for;
    const std::span<const glm::vec4> carried = diffuse(dt, report);
    Transport transport{.carried = carried, .velocity = air.velocity, .dt = dt, .interpolation = config.interpolation};
    transport.settling = settling_factor(config, dt);
    if (!air.fresh) {
        transport.velocity_old = air.velocity_old;
        transport.extrapolation = std::min(1.0f, dt / air.dt_old);
        transport.history = air.history;
        transport.history_scale = std::min(2.0f, dt / air.dt_old);
    }
    const std::span<glm::vec4> arrived = air.velocity_old;
    {
        Stopwatch watch(report.times_ms.advection);
        advect(work, transport, arrived);
        forces.add_to(arrived, 0.5f * dt, parallel_for);
    }
    Stopwatch watch(report.times_ms.projection);
    if (config.stages.projection)
        project(work, arrived, air.history);
    else
        std::fill_n(air.history.data(), air.history.size(), glm::vec4(0.0f));
    forces.add_to(air.history, -0.5f * dt, parallel_for);
    std::swap(air.velocity, air.velocity_old);
    air.fresh = false;
    air.dt_old = dt;
}

void Wind::State::advance_stable_fluids(float dt, Diagnostics& report) {
    forces.add_to(air.velocity, dt, config.parallel_for);
    const std::span<const glm::vec4> carried = diffuse(dt, report);
    Transport transport{.carried = carried, .velocity = air.velocity, .extrapolation = 0.0f, .dt = dt, .interpolation = config.interpolation};
    transport.settling = settling_factor(config, dt);
    {
        Stopwatch watch(report.times_ms.advection);
        advect(work, transport, air.velocity_old);
    }
    Stopwatch watch(report.times_ms.projection);
    if (config.stages.projection)
        project(work, air.velocity_old);
    std::swap(air.velocity, air.velocity_old);
}

// Without transport there is no trajectory to centre anything on: each stage acts whole on u.
void Wind::State::advance_in_place(float dt, Diagnostics& report) {
    const ParallelFor& parallel_for = config.parallel_for;
    forces.add_to(air.velocity, dt, parallel_for);
    if (const float factor = settling_factor(config, dt); factor != 1.0f)
        for (glm::vec4& u : std::span<glm::vec4>(air.velocity))
            u = ambient() + factor * (u - ambient());
    if (const auto carried = diffuse(dt, report); carried.data() != air.velocity.data())
        std::copy(carried.begin(), carried.end(), air.velocity.data());
    Stopwatch watch(report.times_ms.projection);
    if (config.stages.projection)
        project(work, air.velocity);
    air.fresh = true;
}

void Wind::State::add_sources(float dt, Diagnostics& report) {
    Stopwatch watch(report.times_ms.sources);
    if (config.stages.sources)
        report.motors_in_reach = cpu::apply_motors(motors, window, dt, air.velocity, forces, config.parallel_for);
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
    report.cfl = (found.largest_component + dt * forces.largest()) * dt / box().cell_size;
    if (!config.stages.advection || report.cfl <= config.max_cfl)
        return;
    const float wanted = std::ceil(report.cfl / config.max_cfl);
    report.substeps_capped = wanted > static_cast<float>(config.max_substeps);
    report.substeps = report.substeps_capped ? config.max_substeps : static_cast<int>(wanted);
    if (!report.substeps_capped)
        return;
    const float most = config.max_cfl * static_cast<float>(report.substeps) * box().cell_size / dt;
    for (glm::vec4& u : std::span<glm::vec4>(air.velocity)) {
        const float largest = std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)});
        if (largest > most) {
            u *= most / largest;
            ++report.limited_cells;
        }
    }
}

void Wind::State::repair_broken_cells() {
    for (std::size_t n = 0; n < air.velocity.size(); ++n)
        if (!finite(air.velocity[n])) {
            air.velocity[n] = ambient();
            air.velocity_old[n] = ambient();
            air.history[n] = glm::vec4(0.0f);
        }
}

// The velocity after diffusion: itself where viscosity asks for nothing.
std::span<const glm::vec4> Wind::State::diffuse(float dt, Diagnostics& report) {
    const DiffusionMethod method = config.stages.diffusion ? diffusion_method(config.viscosity, dt, box().cell_size) : DiffusionMethod::none;
    report.diffusion = method;
    if (method == DiffusionMethod::none)
        return air.velocity;
    Stopwatch watch(report.times_ms.diffusion);
    if (diffused.empty())
        diffused = cpu::Buffer<glm::vec4>(air.velocity.size());
    windrow::diffuse(work, air.velocity, config.viscosity, dt, diffused);
    return diffused;
}

void Wind::State::measure(Diagnostics& report) {
    Stopwatch watch(report.times_ms.report);
    Workspace::State& state = work.state();
    const float h = box().cell_size;
    const cpu::PlaneSurvey found = state.survey(&air.velocity[0].x);
    report.max_speed = found.largest_component;
    report.energy = 0.5 * found.squares * h * h * h;
    if (config.stages.projection)
        report.divergence_rms = state.divergence_rms(&air.velocity[0].x);
}

} // namespace windrow
