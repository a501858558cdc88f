// Diffusion of the velocity, du/dt = nu L u, by the ratio r = nu dt / h^2. First order in time, second in space.
//
//   r < 1e-4            nothing: below the round-off of an advection
//   r <= 1/12           u + r L u: at 1/6 the shortest wave's factor would already be -1
//   above               backward Euler, (1 - r L) u' = u: one direct solve a component, about the ambient wind, so that a
//                       uniform wind stays as it is; (L - 1/r) v' = -v/r - b with v = u - ambient and b what ghosts add
//
// Obstacles: the explicit pass has the mirror at closed faces. The direct solve has the empty box, so the drag of walls is a pass of
// its own before it, implicit in each cell: the splitting is of first order too.
//
// Crank-Nicolson would be second order, but does not damp the shortest waves at r = 1e4.
#include "fluid/core/numerics.h"
#include "fluid/cpu/stopwatch.h"
#include "fluid/cpu/workspace.h"

#include <algorithm>
#include <cassert>

namespace windrow {
namespace {

void diffuse_once(Workspace::State& state, std::span<const glm::vec4> field, float ratio, std::span<glm::vec4> result) {
    cpu::DiffuseTask task{};
    for (int axis = 0; axis < 3; ++axis) {
        task.cells[axis] = state.box.cells[axis];
        task.rules[axis] = state.rules[axis].data();
        task.ambient[axis] = state.ambient[axis];
    }
    task.field = cpu::floats(field);
    task.ratio = ratio;
    task.row_scales = state.row_scales();
    task.links = state.box.rows ? state.box.rows->links().data() : nullptr;
    task.result = cpu::floats(result);
    state.parallel_for(state.box.cells.z, [&](int plane) { state.kernels->diffuse_plane(task, plane); });
    if (!state.has_solids())
        return;
    const cpu::Stopwatch watch("windrow obstacles", state.obstacles_ms);
    state.solid_flow().close_diffusion(field, {.ambient = state.prescribed.now}, ratio, result);
}

// Contribution of the ghost beyond one boundary to L v at its outermost cell: the part that does not depend on v.
float wall_fraction(const Boundary& side, int component, float ambient) {
    return side.kind == BoundaryKind::no_slip ? 2.0f * (side.wall_velocity[component] - ambient) : 0.0f;
}

void diffuse_component(Workspace::State& state, int component, std::span<const glm::vec4> field, float ratio,
                       std::span<glm::vec4> result) {
    cpu::SeparableSolver& solver = (*state.diffusion)[component];
    solver.set_shift(1.0 / ratio, state.parallel_for);
    const Box& box = state.box;
    const float ambient = state.ambient[component];
    float shares[3][2];
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            shares[axis][end] = axis == component ? 0.0f : wall_fraction(box.boundaries.at(axis, end), component, ambient);
    const auto edge = [&](int axis, int index) {
        const float low = index == 0 ? shares[axis][0] : 0.0f, high = index == box.cells[axis] - 1 ? shares[axis][1] : 0.0f;
        if (axis != 1 || !box.rows)
            return low + high;
        const auto links = box.rows->links().subspan(static_cast<std::size_t>(index), 2);
        return box.row_scale(index) * (links[0] * low + links[1] * high);
    };
    // Along its own axis a wall's ghost mirrors u with opposite sign; about ambient this is -v - 2 ambient, with
    // ambient = 0 there.
    float* const data = state.potential.data();
    const auto row_of = [&](int j, int k) { return data + (static_cast<std::size_t>(k) * box.cells.y + j) * solver.pitch(); };
    state.parallel_for(box.cells.z, [&](int k) {
        for (int j = 0; j < box.cells.y; ++j) {
            float* const row = row_of(j, k);
            const float across = edge(1, j) + edge(2, k);
            for (int i = 0; i < box.cells.x; ++i)
                row[i] = -(field[box.index(i, j, k)][component] - ambient) / ratio - across - edge(0, i);
        }
    });
    solver.solve(data, state.scratch.data(), state.parallel_for);
    state.parallel_for(box.cells.z, [&](int k) {
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i)
                result[box.index(i, j, k)][component] = row_of(j, k)[i] + ambient;
    });
}

} // namespace

DiffusionMethod diffusion_method(float viscosity, float dt, float cell_size) {
    const float ratio = viscosity * dt / (cell_size * cell_size);
    if (!(ratio >= numerics::windrow_least_diffusion))
        return DiffusionMethod::none;
    return ratio <= numerics::windrow_most_explicit_diffusion ? DiffusionMethod::one_pass : DiffusionMethod::implicit;
}

Result<DiffusionMethod> diffuse(Workspace& work, std::span<const glm::vec4> field, float viscosity, float dt,
                                std::span<glm::vec4> result) {
    Workspace::State& state = work.state();
    assert(field.size() == state.box.cell_count() && result.size() == field.size() && field.data() != result.data());
    const float ratio = viscosity * dt / (state.box.cell_size * state.box.cell_size);
    const DiffusionMethod method = diffusion_method(viscosity, dt, state.box.finest());
    if (method == DiffusionMethod::none) {
        std::copy(field.begin(), field.end(), result.begin());
    } else if (method == DiffusionMethod::one_pass) {
        diffuse_once(state, field, ratio, result);
    } else {
        if (auto room = reserve_diffusion(work); !room)
            return room.failure();
        if (state.has_solids()) { // a component is read whole before it is written
            std::copy(field.begin(), field.end(), result.begin());
            const cpu::Stopwatch watch("windrow obstacles", state.obstacles_ms);
            state.solid_flow().drag_along_walls({.ambient = state.prescribed.now}, ratio, result);
            field = result;
        }
        for (int component = 0; component < 3; ++component)
            diffuse_component(state, component, field, ratio, result);
    }
    return method;
}

} // namespace windrow
