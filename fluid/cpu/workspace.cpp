#include "fluid/cpu/workspace.h"

#include "fluid/core/message.h"
#include "fluid/grid/box_rules.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace windrow {
namespace {

bool same_kinds(const Boundaries& a, const Boundaries& b) {
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            if (a.at(axis, end).kind != b.at(axis, end).kind)
                return false;
    return true;
}

Workspace::State::Rules rules_of(const Box& box, detail::HostVector<HaloRule> (*of)(const Box&, int)) {
    return {of(box, 0), of(box, 1), of(box, 2)};
}

ColumnRows column_rows(const Box& box) {
    return box.rows ? ColumnRows(*box.rows, box.cell_size) : ColumnRows();
}

cpu::SeparableSolver pressure_of(const Box& box, const cpu::Kernels& kernels, const ParallelFor& parallel_for) {
    cpu::SeparableSolver solver(box.cells, pressure_ends(box.boundaries), kernels, column_rows(box));
    solver.set_shift(0.0, parallel_for);
    return solver;
}

std::array<cpu::SeparableSolver, 3> diffusion_of(const Box& box, const cpu::Kernels& kernels) {
    const auto solver = [&](int component) {
        return cpu::SeparableSolver(box.cells, velocity_ends(box.boundaries, component), kernels, column_rows(box));
    };
    return {solver(0), solver(1), solver(2)};
}

} // namespace

Workspace::State::State(const Settings& settings, const cpu::Kernels& table)
    : box(settings.box), requested_ambient(settings.ambient),
      ambient(admissible_ambient(settings.box.boundaries, settings.ambient)), parallel_for(settings.parallel_for),
      kernels(&table), rules(rules_of(box, windrow::halo_rules)), carried_rules(rules_of(box, windrow::carried_rules)),
      padded_carried(4 * padded_cells()), padded_trace(4 * padded_cells()), pressure(pressure_of(box, table, parallel_for)),
      surveys(static_cast<std::size_t>(box.cells.z)) {
    build_ghosts();
    grow_solver_buffers(pressure);
}

std::size_t Workspace::State::padded_cells() const {
    const glm::ivec3 padded = box.cells + k_halo;
    return static_cast<std::size_t>(padded.x) * static_cast<std::size_t>(padded.y) * static_cast<std::size_t>(padded.z);
}

void Workspace::State::build_ghosts() {
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            velocity_ghosts[axis][end] = velocity_ghost(box, axis, end);
            potential_ghosts[axis][end] = potential_ghost(box, axis, end);
        }
}

void Workspace::State::grow_solver_buffers(const cpu::SeparableSolver& solver) {
    if (potential.size() < solver.buffer_size())
        potential = cpu::Buffer<float>(solver.buffer_size());
    if (scratch.size() < solver.scratch_size())
        scratch = cpu::Buffer<float>(solver.scratch_size());
}

void Workspace::State::reserve_diffusion() {
    if (diffusion)
        return;
    auto made = diffusion_of(box, *kernels);
    for (const auto& component : made)
        grow_solver_buffers(component);
    diffusion = std::move(made);
}

void Workspace::State::set_boundaries(const Boundaries& boundaries) {
    static_assert(std::is_nothrow_move_assignable_v<cpu::SeparableSolver>, "all is made before anything changes");
    Box wanted = box;
    wanted.boundaries = boundaries;
    Rules wanted_rules = rules_of(wanted, windrow::halo_rules), wanted_carried = rules_of(wanted, windrow::carried_rules);
    const bool kinds_changed = !same_kinds(box.boundaries, boundaries);
    if (kinds_changed) {
        auto wanted_pressure = pressure_of(wanted, *kernels, parallel_for);
        grow_solver_buffers(wanted_pressure);
        if (diffusion) {
            auto wanted_diffusion = diffusion_of(wanted, *kernels);
            for (const auto& component : wanted_diffusion)
                grow_solver_buffers(component);
            diffusion = std::move(wanted_diffusion);
        }
        pressure = std::move(wanted_pressure);
    }
    box = wanted;
    rules = std::move(wanted_rules);
    carried_rules = std::move(wanted_carried);
    set_ambient(requested_ambient);
    if (kinds_changed)
        build_ghosts();
}

void Workspace::State::set_ambient(glm::vec3 wind) {
    requested_ambient = wind;
    ambient = admissible_ambient(box.boundaries, wind);
}

std::size_t Workspace::State::memory_bytes() const {
    std::size_t bytes = sizeof(State) + padded_carried.bytes() + padded_trace.bytes() + padded_scalar.bytes() +
                        potential.bytes() + scratch.bytes() + surveys.bytes() + pressure.memory_bytes() + direction.bytes() +
                        correction.bytes();
    for (const auto* each : {&rules, &carried_rules})
        for (const auto& axis : *each)
            bytes += axis.capacity() * sizeof(HaloRule);
    if (diffusion)
        for (const auto& component : *diffusion)
            bytes += component.memory_bytes();
    return bytes;
}

namespace {

cpu::PlaneSurvey sum_of(const cpu::Buffer<cpu::PlaneSurvey>& planes) {
    cpu::PlaneSurvey whole{};
    for (std::size_t n = 0; n < planes.size(); ++n)
        add(planes[n], whole);
    return whole;
}

} // namespace

// Rows of unequal thickness count by it.
void Workspace::State::survey_rows(const float* velocity, int plane, int first, int end, cpu::PlaneSurvey& found) const {
    const int at_once = box.rows ? 1 : end - first;
    for (int row = first; row < end; row += at_once) {
        cpu::PlaneSurvey part =
            kernels->survey(velocity + 4 * box.index(0, row, plane), static_cast<std::size_t>(at_once) * box.cells.x);
        if (box.rows)
            part.squares /= static_cast<double>(box.row_scale(row));
        add(part, found);
    }
}

cpu::PlaneSurvey Workspace::State::survey(const float* velocity) {
    parallel_for(box.cells.z, [&](int plane) {
        surveys[plane] = {};
        survey_rows(velocity, plane, 0, box.cells.y, surveys[plane]);
    });
    return sum_of(surveys);
}

// A few rows at a time, so that the reduction reads rows that the divergence has just brought into cache.
cpu::PlaneSurvey Workspace::State::survey_with_divergence(const float* velocity, std::span<const float> expansion) {
    constexpr int k_cells_at_once = 256;
    const int rows_at_once = std::max(1, k_cells_at_once / box.cells.x);
    const cpu::DivergenceTask task = divergence_task(velocity, 0.5f / box.cell_size);
    const float* const wanted = expansion.empty() ? nullptr : expansion.data();
    parallel_for(box.cells.z, [&](int plane) {
        cpu::PlaneSurvey found{};
        for (int row = 0; row < box.cells.y; row += rows_at_once) {
            const int end = std::min(row + rows_at_once, box.cells.y);
            found.divergence_squares += kernels->divergence_squares(task, wanted, plane, row, end);
            survey_rows(velocity, plane, row, end, found);
        }
        surveys[plane] = found;
    });
    return sum_of(surveys);
}

Workspace::Workspace(std::unique_ptr<State> state) : state_(std::move(state)) {}
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;
Workspace::~Workspace() = default;

Result<Workspace> Workspace::create(const Settings& settings) {
    detail::Reasons reasons;
    if (auto box = validate(settings.box); !box)
        reasons.add(box.error());
    if (!(std::isfinite(settings.ambient.x) && std::isfinite(settings.ambient.y) && std::isfinite(settings.ambient.z)))
        reasons.add("ambient is ", settings.ambient, " m/s: give finite numbers.");
    const cpu::Kernels* const kernels = cpu::kernels_for(settings.simd);
    if (kernels == nullptr)
        reasons.add("simd is ", name_of(settings.simd), ", which this machine does not run: give best or baseline.");
    if (!reasons.empty())
        return Error{reasons.take()};
    return detail::where_memory_lasts(
        [&]() -> Result<Workspace> { return Workspace(std::make_unique<State>(settings, *kernels)); });
}

Result<void> Workspace::set_boundaries(const Boundaries& boundaries) {
    Box wanted = box();
    wanted.boundaries = boundaries;
    if (auto valid = validate(wanted); !valid)
        return valid;
    return detail::where_memory_lasts([&]() -> Result<void> {
        std::vector<PlacedObstacle> bodies;
        if (state_->solids)
            bodies.assign(state_->solids->bodies().begin(), state_->solids->bodies().end());
        state_->set_boundaries(boundaries);
        if (bodies.empty())
            return {};
        try { // other boundaries make other images and rooms, in arrays of another pitch
            state_->set_obstacles(bodies);
        } catch (...) {
            state_->solids.reset();
            throw;
        }
        return {};
    });
}

void Workspace::set_ambient(glm::vec3 ambient) {
    state_->set_ambient(ambient);
}
Result<void> Workspace::set_obstacles(std::span<const PlacedObstacle> obstacles) {
    constexpr std::size_t k_most = 65535;
    if (obstacles.size() > k_most)
        return Error{detail::message("there are ", obstacles.size(), " obstacles: give at most 65535.")};
    return detail::where_memory_lasts([&]() -> Result<void> {
        state_->set_obstacles(obstacles);
        return {};
    });
}
const Solids* Workspace::solids() const {
    return state_->has_solids() ? state_->solids.get() : nullptr;
}

glm::vec3 Workspace::impulse_on(std::size_t obstacle) const {
    if (!state_->has_solids())
        return glm::vec3(0.0f);
    return glm::vec3(state_->solid_flow().push_on(obstacle, state_->potential.data()).impulse);
}
const Box& Workspace::box() const {
    return state_->box;
}
glm::vec3 Workspace::ambient() const {
    return state_->ambient;
}
std::size_t Workspace::memory_bytes() const {
    return state_->memory_bytes();
}
Result<void> reserve_diffusion(Workspace& work) {
    return detail::where_memory_lasts([&]() -> Result<void> {
        work.state().reserve_diffusion();
        return {};
    });
}

} // namespace windrow
