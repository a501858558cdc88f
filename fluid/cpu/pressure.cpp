// Projection onto divergence-free fields, collocated: L phi = div u - S, u -= grad phi. S is the prescribed divergence, nonzero
// only in volume sources.
//
// Divergence and gradient are central over two cells, L is the compact 7-point Laplacian: an approximate projection. The
// remaining divergence is (L - div grad) phi, which falls as h^2. Everything is dimensionless (phi / h), so no h appears.
// Based on, around obstacles: Buzbee, Dorr, George & Golub 1971, SIAM Journal on Numerical Analysis 8 (a direct solver's box around an
// irregular domain), here with conjugate gradients on its surface.
#include "fluid/cpu/sources.h"
#include "fluid/cpu/stopwatch.h"
#include "fluid/cpu/workspace.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace windrow {

cpu::DivergenceTask Workspace::State::divergence_task(const float* velocity, float scale) const {
    cpu::DivergenceTask task{};
    for (int axis = 0; axis < 3; ++axis)
        task.cells[axis] = box.cells[axis];
    task.velocity = velocity;
    std::copy(&velocity_ghosts[0][0], &velocity_ghosts[0][0] + 6, &task.ghosts[0][0]);
    task.scale = scale;
    task.row_scales = row_scales();
    return task;
}

void Workspace::State::divergence_to(float* rows, int pitch, const float* velocity, float scale) {
    cpu::DivergenceTask task = divergence_task(velocity, scale);
    task.pitch = pitch;
    task.result = rows;
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

constexpr int k_most_solves = 64;             // of project() as an operator, which has no guess
constexpr float k_rounding = 1e-6f;           // residual that floats reach
constexpr float k_operator_tolerance = 1e-4f; // of its residual

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

template <class State>
auto padded_rows(State& state) {
    return [&state](int j, int k) {
        return state.potential.data() + (static_cast<std::size_t>(k) * state.box.cells.y + j) * state.pressure.pitch();
    };
}

template <class T>
auto dense_rows(const Workspace::State& state, std::span<T> field) {
    return [&state, field](int j, int k) { return field.data() + state.box.index(0, j, k); };
}

} // namespace

void Workspace::State::copy_potential(std::span<float> field, float factor) const {
    copy_rows(*this, padded_rows(*this), dense_rows(*this, field), factor);
}

void Workspace::State::set_potential(std::span<const float> field) {
    copy_rows(*this, dense_rows(*this, field), padded_rows(*this), 1.0f);
    if (has_solids())
        solid_flow().closed_slopes(potential.data(), closed_slopes);
}

void divergence(Workspace& work, std::span<const glm::vec4> velocity, std::span<float> result) {
    Workspace::State& state = work.state();
    assert(velocity.size() == state.box.cell_count() && result.size() == velocity.size());
    state.divergence_to_potential(cpu::floats(velocity), 0.5f / state.box.cell_size);
    state.copy_potential(result, 1.0f);
    if (state.has_solids())
        state.solid_flow().find_divergence(velocity, state.residual_terms, result);
}

void solve_poisson(Workspace& work, std::span<float> rhs_then_phi) {
    Workspace::State& state = work.state();
    assert(rhs_then_phi.size() == state.box.cell_count());
    copy_rows(state, dense_rows(state, rhs_then_phi), padded_rows(state), state.box.cell_size * state.box.cell_size);
    state.pressure.solve(state.potential.data(), state.scratch.data(), state.parallel_for);
    state.copy_potential(rhs_then_phi, 1.0f);
}

void project(Workspace& work, std::span<glm::vec4> velocity, std::span<glm::vec4> gradient, std::span<const float> expansion) {
    work.state().project(velocity, expansion, {.field = gradient});
}

void Workspace::State::solve_around(std::span<const glm::vec4> velocity, SolidSolve& around, const GradientNote& note) {
    const cpu::SolidFlow flow = solid_flow();
    const std::span<const Solids::SurfaceCell> cells = solids->surface();
    // Over the volume, in which the operator is symmetric.
    const auto sum = [&](const auto& term) {
        double total = 0.0;
        for (std::size_t n = 0; n < cells.size(); ++n)
            total += static_cast<double>(cells[n].volume) * term(n);
        return total;
    };
    // In shut cells no value matters, and none is solved for: their part of A is that of a box without an opening, in whose constants
    // the search would get lost.
    const auto leave_out_shut = [&](std::vector<float>& terms) {
        for (std::size_t n = 0; n < cells.size(); ++n)
            if (cells[n].shut)
                terms[n] = 0.0f;
    };
    const auto norm = [&](const auto& term) {
        return std::sqrt(sum([&](std::size_t n) {
            const auto value = static_cast<double>(term(n));
            return cells[n].shut ? 0.0 : value * value;
        }));
    };
    std::optional<cpu::Stopwatch> watch(std::in_place, "windrow obstacles", obstacles_ms);
    const float guess = around.guess_scale;
    flow.close_divergence(velocity, around.prescribed, around.bodies_move, solid_terms, guess, potential.data(), masked_terms);
    const double wanted = norm([&](std::size_t n) {
        return std::exchange(potential[cells[n].potential], potential[cells[n].potential] + masked_terms[n]);
    });
    watch.reset();
    pressure.solve(potential.data(), scratch.data(), parallel_for);
    watch.emplace("windrow obstacles", obstacles_ms);
    flow.find_residual(potential.data(), solid_terms, guess, closed_slopes, residual_terms);
    leave_out_shut(residual_terms);
    flow.balance(residual_terms);
    const auto residual = [&] { return norm([&](std::size_t n) { return residual_terms[n]; }); };

    around.solved = 1;
    double left = residual(), squares_before = 1.0;
    watch.reset();
    bool searched = false;
    while (around.solved < around.solves && left > static_cast<double>(std::max(around.tolerance, k_rounding)) * wanted) {
        searched = true;
        std::fill_n(correction.data(), correction.size(), 0.0f);
        for (std::size_t n = 0; n < cells.size(); ++n)
            correction[cells[n].potential] = residual_terms[n];
        pressure.solve(correction.data(), scratch.data(), parallel_for);
        const double squares = sum([&](std::size_t n) {
            return static_cast<double>(residual_terms[n]) * static_cast<double>(correction[cells[n].potential]);
        });
        const bool first = around.solved == 1;
        const float beta = first ? 0.0f : static_cast<float>(squares / squares_before);
        squares_before = squares;
        if (!first)
            add_to_rows(correction, direction, beta);
        std::swap(direction, correction);
        // A d: L d is known, since d is made of solutions.
        for (std::size_t n = 0; n < cells.size(); ++n)
            applied_terms[n] = first ? residual_terms[n] : residual_terms[n] + beta * applied_terms[n];
        flow.closed_slopes(direction.data(), closed_slopes);
        std::copy(applied_terms.begin(), applied_terms.end(), masked_terms.begin());
        flow.add_masked(closed_slopes, -1.0f, masked_terms);
        leave_out_shut(masked_terms);
        const double bent = sum([&](std::size_t n) {
            return static_cast<double>(direction[cells[n].potential]) * static_cast<double>(masked_terms[n]);
        });
        if (!(bent < 0.0))
            break;
        const auto alpha = static_cast<float>(squares / bent);
        add_to_rows(potential, direction, alpha);
        for (std::size_t n = 0; n < cells.size(); ++n)
            residual_terms[n] -= alpha * masked_terms[n];
        flow.balance(residual_terms);
        left = residual();
        ++around.solved;
    }
    watch.emplace("windrow obstacles", obstacles_ms);
    flow.level(potential.data());
    if (searched || !solids->sealed_parts().empty())
        flow.closed_slopes(potential.data(), closed_slopes);
    around.residual = wanted > 0.0 ? static_cast<float>(left / wanted) : 0.0f;
    if (around.keeps_terms)
        for (std::size_t n = 0; n < solid_terms.size(); ++n)
            solid_terms[n] = note.weight * closed_slopes[n] + note.kept * solid_terms[n];
}

// a += factor * b over the rows of the direct solve.
void Workspace::State::add_to_rows(cpu::Buffer<float>& a, const cpu::Buffer<float>& b, float factor) {
    const std::size_t plane = static_cast<std::size_t>(pressure.pitch()) * box.cells.y;
    parallel_for(box.cells.z, [&](int k) {
        const std::size_t first = plane * static_cast<std::size_t>(k);
        for (std::size_t n = first; n < first + plane; ++n)
            a[n] += factor * b[n];
    });
}

void Workspace::State::set_obstacles(std::span<const PlacedObstacle> obstacles, glm::ivec3 shift) {
    if (!solids && obstacles.empty())
        return;
    if (!solids || !(solids->boundaries() == box.boundaries)) { // other boundaries make other images and rooms
        solids = std::make_unique<Solids>(box, pressure.pitch());
        direction = cpu::Buffer<float>(potential.size());
        correction = cpu::Buffer<float>(potential.size());
    }
    solid_keys.swap(keys_before);
    solid_terms.swap(terms_before);
    solids->place(obstacles, shift);
    const std::span<const ClosedFace> faces = solids->faces();
    const auto empty = [](std::vector<float>& terms, std::size_t count) {
        detail::make_room(terms, count);
        terms.assign(count, 0.0f);
    };
    for (std::vector<float>* terms : {&closed_slopes, &solid_terms})
        empty(*terms, faces.size());
    for (std::vector<float>* terms : {&residual_terms, &applied_terms, &masked_terms})
        empty(*terms, solids->surface().size());
    solids->name_faces(solid_keys);
    solids->find_origins(keys_before, shift, face_origins);
    for (std::size_t n = 0; n < faces.size(); ++n)
        if (face_origins[n] >= 0)
            solid_terms[n] = terms_before[static_cast<std::size_t>(face_origins[n])];
}

// velocity -= grad phi; of what closed faces pass, `closed_slopes`.
void Workspace::State::take_gradient(const cpu::Potential& solved, std::span<glm::vec4> velocity, const GradientNote& note) {
    cpu::GradientTask task{};
    for (int axis = 0; axis < 3; ++axis)
        task.cells[axis] = box.cells[axis];
    task.pitch = solved.pitch;
    task.potential = solved.rows;
    std::copy(&potential_ghosts[0][0], &potential_ghosts[0][0] + 6, &task.ghosts[0][0]);
    task.scale = 0.5f;
    task.row_scales = row_scales();
    task.velocity = cpu::floats(velocity);
    task.gradient = cpu::floats(note.field);
    task.weight = note.weight;
    task.kept = note.kept;
    parallel_for(box.cells.z, [&](int plane) { kernels->gradient_plane(task, plane); });
    if (!has_solids())
        return;
    const cpu::Stopwatch watch("windrow obstacles", obstacles_ms);
    solid_flow().open_gradient(closed_slopes, velocity, note.field, note.weight);
}

void Workspace::State::project(std::span<glm::vec4> velocity, std::span<const float> expansion, const GradientNote& note,
                               const cpu::Beyond* beyond, SolidSolve* around) {
    assert(velocity.size() == box.cell_count() && (note.field.empty() || note.field.size() == velocity.size()));
    assert(expansion.empty() || expansion.size() == velocity.size());
    // Of what L takes from a neighbour's value.
    const auto link = [&](glm::ivec3 cell, int axis, int end) {
        return axis == 1 && box.rows ? box.row_scale(cell.y) * box.rows->links()[static_cast<std::size_t>(cell.y + end)] : 1.0f;
    };
    // Of a central difference, what the ghost's value has in it.
    const auto half_step = [&](glm::ivec3 cell, int axis, int end) {
        return (end == 0 ? -0.5f : 0.5f) * (axis == 1 ? box.row_scale(cell.y) : 1.0f);
    };
    const bool exchanged = other_solve != nullptr && expansion.empty() && beyond == nullptr && !has_solids();
    if (exchanged)
        divergence_to(other_solve->rhs, other_solve->pitch, cpu::floats(velocity), 0.5f);
    else
        divergence_to_potential(cpu::floats(velocity), 0.5f);
    if (!expansion.empty())
        subtract_from_potential(expansion, box.cell_size);
    if (beyond != nullptr)
        for_each_open_end([&](glm::ivec3 cell, int axis, int end) {
            potential[(static_cast<std::size_t>(cell.z) * box.cells.y + cell.y) * pressure.pitch() + cell.x] +=
                half_step(cell, axis, end) * beyond->rise(cell, axis, end) -
                link(cell, axis, end) * beyond->potential(cell, axis, end);
        });
    SolidSolve alone{.solves = k_most_solves, .tolerance = k_operator_tolerance};
    cpu::Potential solved{potential.data(), pressure.pitch()};
    if (exchanged)
        solved = other_solve->solve();
    else if (has_solids())
        solve_around(velocity, around != nullptr ? *around : alone, note);
    else
        pressure.solve(potential.data(), scratch.data(), parallel_for);

    take_gradient(solved, velocity, note);
    if (has_solids()) {
        const cpu::Stopwatch watch("windrow obstacles", obstacles_ms);
        solid_flow().hold_bodies((around != nullptr ? *around : alone).prescribed, around == nullptr || around->bodies_move,
                                 velocity);
    }
    if (beyond != nullptr)
        for_each_open_end([&](glm::ivec3 cell, int axis, int end) {
            if (has_solids() && solids->inside(static_cast<std::uint32_t>(box.index(cell.x, cell.y, cell.z))))
                return; // the body's own velocity
            const std::size_t n = box.index(cell.x, cell.y, cell.z);
            const float slope = half_step(cell, axis, end) * beyond->potential(cell, axis, end);
            velocity[n][axis] -= slope;
            if (!note.field.empty())
                note.field[n][axis] += note.weight * slope;
        });
}

} // namespace windrow
