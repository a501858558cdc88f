#include "cases/reference/composed_step.h"

#include "fluid/cpu/workspace.h"

#include <algorithm>
#include <new>
#include <utility>

namespace windrow::reference {
namespace {

int sweeps_of(Pressure pressure) {
    switch (pressure) {
    case Pressure::jacobi20:
        return 20;
    case Pressure::jacobi40:
        return 40;
    default:
        return 80;
    }
}

Result<Motors> motors_of(const std::vector<Motor>& list) {
    Motors motors;
    for (const Motor& motor : list)
        if (const auto id = motors.add(motor); !id)
            return Error{id.error()};
    return motors;
}

} // namespace

Result<ComposedStep> ComposedStep::create(const StepSettings& settings) {
    auto work = Workspace::create(
        {.box = settings.box, .ambient = settings.ambient, .simd = settings.simd, .parallel_for = settings.parallel_for});
    if (!work)
        return Error{work.error()};
    return ComposedStep(settings, std::move(*work));
}

ComposedStep::ComposedStep(const StepSettings& settings, Workspace work)
    : settings_(settings), work_(std::move(work)), sources_(settings.box.cells), velocity_(settings.box.cell_count()),
      velocity_old_(velocity_.size()), history_(velocity_.size()), diffused_(settings.viscosity > 0.0f ? velocity_.size() : 0),
      rhs_(velocity_.size()), jacobi_(settings.box, settings.simd), multigrid_(settings.box, settings.simd) {}

Result<void> ComposedStep::start(std::span<const glm::vec4> velocity) {
    auto motors = motors_of(settings_.motors);
    if (!motors)
        return Error{motors.error()};
    motors_ = std::move(*motors);
    std::copy(velocity.begin(), velocity.end(), velocity_.data());
    fresh_ = true;
    return {};
}

void ComposedStep::step(const StepMethod& method, double dt) {
    const Box& box = settings_.box;
    const Window window{.cells = box.cells, .cell_size = box.cell_size, .origin_cells = {}};
    const auto reached = motors_.tick(dt, window, box.boundaries);
    const auto& tile = motors_.tile({});
    sources_.gather(reached, box, velocity_, {tile ? tile->texels().data() : nullptr}, settings_.parallel_for);
    Workspace::State& around = work_.state();
    static_cast<void>(around.survey(&velocity_[0].x)); // the guard
    if (method.scheme == Scheme::second_order)
        advance_second_order(method, static_cast<float>(dt));
    else
        advance_stable_fluids(method, static_cast<float>(dt));
    largest_speed_ = around.survey_with_divergence(&velocity_[0].x, {}).largest_component; // the report
}

std::span<const glm::vec4> ComposedStep::diffuse(float dt) {
    if (diffusion_method(settings_.viscosity, dt, settings_.box.cell_size) == DiffusionMethod::none)
        return velocity_;
    if (!windrow::diffuse(work_, velocity_, settings_.viscosity, dt, diffused_))
        throw std::bad_alloc();
    return diffused_;
}

void ComposedStep::advance_second_order(const StepMethod& method, float dt) {
    if (fresh_) {
        perform(method, dt);
        std::swap(velocity_, velocity_old_);
        for (std::size_t n = 0; n < velocity_.size(); ++n)
            velocity_old_[n] = 2.0f * velocity_[n] - velocity_old_[n];
    }
    perform(method, dt);
}

void ComposedStep::perform(const StepMethod& method, float dt) {
    Transport transport{.carried = diffuse(dt), .velocity = velocity_, .dt = dt, .interpolation = method.interpolation};
    const numerics::WindrowPast past = numerics::windrow_past(fresh_ ? 0.0f : dt / dt_old_);
    if (!fresh_) {
        transport.velocity_old = velocity_old_;
        transport.extrapolation = past.scale;
        transport.history = history_;
        transport.history_scale = past.scale;
    }
    const cpu::Acting acting(sources_, {.cells = settings_.box.cells, .dt = dt, .parallel_for = &settings_.parallel_for});
    const auto departing = [&](std::size_t n, glm::ivec3) { return glm::vec3(transport.carried[n]); };
    if (acting.any()) {
        if (fresh_) {
            std::fill_n(history_.data(), history_.size(), glm::vec4(0.0f));
            transport.history_scale = 1.0f;
        }
        transport.history = history_;
        acting.depart(departing, transport.history_scale, history_);
    }
    advect(work_, transport, velocity_old_);
    if (acting.any())
        acting.arrive([](std::size_t, glm::ivec3) { return glm::vec3(0.0f); }, transport.history_scale, history_, velocity_old_);
    project(method.pressure, velocity_old_, {.field = history_, .weight = past.weight, .kept = past.kept});
    std::swap(velocity_, velocity_old_);
    fresh_ = false;
    dt_old_ = dt;
}

void ComposedStep::advance_stable_fluids(const StepMethod& method, float dt) {
    sources_.drive(velocity_, settings_.parallel_for);
    sources_.add_force_to(velocity_, dt, settings_.parallel_for);
    const Transport transport{
        .carried = diffuse(dt), .velocity = velocity_, .extrapolation = 0.0f, .dt = dt, .interpolation = method.interpolation};
    advect(work_, transport, velocity_old_);
    project(method.pressure, velocity_old_, {});
    std::swap(velocity_, velocity_old_);
}

void ComposedStep::project(Pressure pressure, std::span<glm::vec4> velocity, const GradientNote& note) {
    switch (pressure) {
    case Pressure::direct:
        work_.state().project(velocity, {}, note);
        return;
    case Pressure::multigrid:
        divergence_rows(velocity, multigrid_.source_row(0, 0), static_cast<int>(multigrid_.pitch()));
        multigrid_.solve(k_multigrid_cycles, settings_.parallel_for);
        subtract_gradient(multigrid_.row(0, 0), static_cast<int>(multigrid_.pitch()), velocity, note);
        return;
    default:
        divergence_rows(velocity, rhs_.data(), settings_.box.cells.x);
        jacobi_.solve(rhs_, sweeps_of(pressure), settings_.parallel_for);
        subtract_gradient(jacobi_.row(0, 0), static_cast<int>(jacobi_.pitch()), velocity, note);
    }
}

// Potentials are phi / h, so that no spacing appears in the solves.
void ComposedStep::divergence_rows(std::span<const glm::vec4> velocity, float* rows, int pitch) {
    const Workspace::State& around = work_.state();
    cpu::DivergenceTask task = around.divergence_task(cpu::floats(velocity), 0.5f);
    task.pitch = pitch;
    task.result = rows;
    settings_.parallel_for(settings_.box.cells.z, [&](int plane) { around.kernels->divergence_plane(task, plane); });
}

void ComposedStep::subtract_gradient(const float* rows, int pitch, std::span<glm::vec4> velocity, const GradientNote& note) {
    const Workspace::State& around = work_.state();
    cpu::GradientTask task{};
    for (int axis = 0; axis < 3; ++axis)
        task.cells[axis] = settings_.box.cells[axis];
    std::copy(&around.potential_ghosts[0][0], &around.potential_ghosts[0][0] + 6, &task.ghosts[0][0]);
    task.pitch = pitch;
    task.potential = rows;
    task.scale = 0.5f;
    task.velocity = cpu::floats(velocity);
    task.gradient = cpu::floats(note.field);
    task.weight = note.weight;
    task.kept = note.kept;
    settings_.parallel_for(settings_.box.cells.z, [&](int plane) { around.kernels->gradient_plane(task, plane); });
}

} // namespace windrow::reference
