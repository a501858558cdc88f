// Projection onto divergence-free fields, collocated: L phi = div u - S, u -= grad phi. S is the prescribed divergence, nonzero
// only in volume sources.
//
// Divergence and gradient are central over two cells, L is the compact 7-point Laplacian: an approximate projection. The
// remaining divergence is (L - div grad) phi, which falls as h^2. Everything is dimensionless (phi / h), so no h appears.
#include "fluid/cpu/sources.h"
#include "fluid/cpu/workspace.h"

#include <algorithm>
#include <cassert>

namespace windrow {

cpu::DivergenceTask Workspace::State::divergence_task(const float* velocity, float scale) const {
    cpu::DivergenceTask task{};
    for (int axis = 0; axis < 3; ++axis)
        task.cells[axis] = box.cells[axis];
    task.velocity = velocity;
    std::copy(&velocity_ghosts[0][0], &velocity_ghosts[0][0] + 6, &task.ghosts[0][0]);
    task.scale = scale;
    return task;
}

void Workspace::State::divergence_to_potential(const float* velocity, float scale) {
    cpu::DivergenceTask task = divergence_task(velocity, scale);
    task.pitch = pressure.pitch();
    task.result = potential.data();
    parallel_for(box.cells.z, [&](int plane) { kernels->divergence_plane(task, plane); });
}

void Workspace::State::subtract_from_potential(std::span<const float> field, float factor) {
    parallel_for(box.cells.z, [&](int k) {
        for (int j = 0; j < box.cells.y; ++j) {
            float* const row = potential.data() + (static_cast<std::size_t>(k) * box.cells.y + j) * pressure.pitch();
            const float* const wanted = field.data() + box.index(0, j, k);
            for (int i = 0; i < box.cells.x; ++i)
                row[i] -= factor * wanted[i];
        }
    });
}

// Calls visit(cell, axis, step) where a step leads out of an open boundary.
template <class Visit>
void Workspace::State::for_each_open_end(const Visit& visit) const {
    const glm::ivec3 last = box.cells - 1;
    parallel_for(box.cells.z, [&](int k) {
        for (int j = 0; j <= last.y; ++j) {
            const bool outermost = j == 0 || j == last.y || k == 0 || k == last.z;
            for (int i = 0; i <= last.x; i += outermost ? 1 : std::max(1, last.x)) {
                const glm::ivec3 cell(i, j, k);
                for (int axis = 0; axis < 3; ++axis)
                    for (const int end : {0, 1})
                        if (cell[axis] == end * last[axis] && box.boundaries.at(axis, end).kind == BoundaryKind::open)
                            visit(cell, axis, end);
            }
        }
    });
}

namespace {

// Copies between a caller's dense field and the solver's padded rows, times a factor.
template <class From, class To>
void copy_rows(const Workspace::State& state, const From& from, const To& to, float factor) {
    const glm::ivec3 cells = state.box.cells;
    state.parallel_for(cells.z, [&](int k) {
        for (int j = 0; j < cells.y; ++j) {
            const auto* const source = from(j, k);
            auto* const target = to(j, k);
            for (int i = 0; i < cells.x; ++i)
                target[i] = factor * source[i];
        }
    });
}

auto padded_rows(Workspace::State& state) {
    return [&state](int j, int k) {
        return state.potential.data() + (static_cast<std::size_t>(k) * state.box.cells.y + j) * state.pressure.pitch();
    };
}

template <class T>
auto dense_rows(const Workspace::State& state, std::span<T> field) {
    return [&state, field](int j, int k) { return field.data() + state.box.index(0, j, k); };
}

} // namespace

void divergence(Workspace& work, std::span<const glm::vec4> velocity, std::span<float> result) {
    Workspace::State& state = work.state();
    assert(velocity.size() == state.box.cell_count() && result.size() == velocity.size());
    state.divergence_to_potential(cpu::floats(velocity), 0.5f / state.box.cell_size);
    copy_rows(state, padded_rows(state), dense_rows(state, result), 1.0f);
}

void solve_poisson(Workspace& work, std::span<float> rhs_then_phi) {
    Workspace::State& state = work.state();
    assert(rhs_then_phi.size() == state.box.cell_count());
    copy_rows(state, dense_rows(state, rhs_then_phi), padded_rows(state), state.box.cell_size * state.box.cell_size);
    state.pressure.solve(state.potential.data(), state.scratch.data(), state.parallel_for);
    copy_rows(state, padded_rows(state), dense_rows(state, rhs_then_phi), 1.0f);
}

void project(Workspace& work, std::span<glm::vec4> velocity, std::span<glm::vec4> gradient, std::span<const float> expansion) {
    work.state().project(velocity, expansion, {.field = gradient});
}

void Workspace::State::project(std::span<glm::vec4> velocity, std::span<const float> expansion, const GradientNote& note,
                               const cpu::FreeAir* beyond) {
    assert(velocity.size() == box.cell_count() && (note.field.empty() || note.field.size() == velocity.size()));
    assert(expansion.empty() || expansion.size() == velocity.size());
    divergence_to_potential(cpu::floats(velocity), 0.5f);
    if (!expansion.empty())
        subtract_from_potential(expansion, box.cell_size);
    if (beyond != nullptr)
        for_each_open_end([&](glm::ivec3 cell, int axis, int end) {
            potential[(static_cast<std::size_t>(cell.z) * box.cells.y + cell.y) * pressure.pitch() + cell.x] -=
                beyond->at(cell, axis, end);
        });
    pressure.solve(potential.data(), scratch.data(), parallel_for);

    cpu::GradientTask task{};
    for (int axis = 0; axis < 3; ++axis)
        task.cells[axis] = box.cells[axis];
    task.pitch = pressure.pitch();
    task.potential = potential.data();
    std::copy(&potential_ghosts[0][0], &potential_ghosts[0][0] + 6, &task.ghosts[0][0]);
    task.scale = 0.5f;
    task.velocity = cpu::floats(velocity);
    task.gradient = cpu::floats(note.field);
    task.weight = note.weight;
    task.kept = note.kept;
    parallel_for(box.cells.z, [&](int plane) { kernels->gradient_plane(task, plane); });
    if (beyond != nullptr)
        for_each_open_end([&](glm::ivec3 cell, int axis, int end) {
            velocity[box.index(cell.x, cell.y, cell.z)][axis] -= (end == 0 ? -0.5f : 0.5f) * beyond->at(cell, axis, end);
        });
}

} // namespace windrow
