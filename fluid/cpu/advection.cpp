// Semi-Lagrangian advection of the velocity: gather with halo, then trace and interpolate. Method: operators.h.
#include "fluid/cpu/workspace.h"
#include "fluid/grid/box_rules.h"

#include <cassert>

namespace windrow {
cpu::AdvectTask Workspace::State::advect_task() const {
    cpu::AdvectTask task{};
    task.row_scales = row_scales();
    for (int axis = 0; axis < 3; ++axis) {
        const LegalPlaces legal = legal_places(box, axis);
        task.cells[axis] = box.cells[axis];
        task.legal.low[axis] = legal.low;
        task.legal.high[axis] = legal.high;
        task.legal.period[axis] = legal.period;
        task.legal.inverse_period[axis] = legal.inverse_period;
    }
    return task;
}

// In a closed room the air comes to rest, in place of relaxing to the ambient wind.
void Workspace::State::still_rooms(const cpu::PadTask& pad) {
    for (const std::uint32_t n : solids->rooms()) {
        float* const value = pad.padded_carried + 4 * padded_index(box.cells, solids->place_of(n));
        for (std::size_t c = 0; c < 4; ++c) {
            const std::size_t from = 4 * static_cast<std::size_t>(n) + c;
            value[c] =
                pad.relaxation * pad.carried[from] - (pad.history != nullptr ? pad.history_scale * pad.history[from] : 0.0f);
        }
    }
}

void advect(Workspace& work, const Transport& transport, std::span<glm::vec4> result) {
    Workspace::State& state = work.state();
    assert(transport.carried.size() == state.box.cell_count() && transport.velocity.size() == state.box.cell_count());
    assert(result.size() == state.box.cell_count() && result.data() != transport.velocity.data());

    const bool own_trace = state.box.rows || !transport.velocity_old.empty() || !transport.history.empty() ||
                           transport.relaxation != 1.0f || transport.carried.data() != transport.velocity.data();
    cpu::PadTask pad{};
    for (int axis = 0; axis < 3; ++axis) {
        pad.cells[axis] = state.box.cells[axis];
        pad.rules[axis] = state.carried_rules[axis].data();
        pad.ambient[axis] = state.ambient[axis];
    }
    pad.ambient_cells = state.mean_cells;
    pad.trace_ambient_cells = state.ambient_cells;
    pad.carried = cpu::floats(transport.carried);
    pad.history = cpu::floats(transport.history);
    pad.history_scale = transport.history_scale;
    pad.relaxation = transport.relaxation;
    pad.velocity = cpu::floats(transport.velocity);
    pad.velocity_old = cpu::floats(transport.velocity_old);
    pad.extrapolation = transport.extrapolation;
    pad.row_scales = state.row_scales();
    pad.padded_carried = state.padded_carried.data();
    pad.padded_trace = own_trace ? state.padded_trace.data() : nullptr;
    state.parallel_for(state.box.cells.z + k_halo, [&](int plane) { state.kernels->pad_plane(pad, plane); });

    if (pad.relaxation != 1.0f && state.has_solids())
        state.still_rooms(pad);

    cpu::AdvectTask task = state.advect_task();
    task.velocity = pad.velocity;
    task.padded_carried = pad.padded_carried;
    task.padded_trace = own_trace ? pad.padded_trace : pad.padded_carried;
    task.result = cpu::floats(result);
    task.cells_per_speed = transport.dt / state.box.cell_size;
    if (state.prescribed.now != nullptr) {
        task.prescribed = state.prescribed;
        task.prescribed.legal = task.legal;
        // The air slips along a wall, as the advected field does. A does not repeat with a periodic box: its jump, read across
        // that seam, would feed the perturbation permanently.
        cpu::Legal& legal = task.prescribed.legal;
        for (int axis = 0; axis < 3; ++axis) {
            if (state.box.boundaries.at(axis, 0).kind != BoundaryKind::open)
                legal.low[axis] = 0.0f;
            if (state.box.boundaries.at(axis, 1).kind != BoundaryKind::open)
                legal.high[axis] = static_cast<float>(state.box.cells[axis] - 1);
            legal.period[axis] = legal.inverse_period[axis] = 0.0f;
        }
    }
    const auto advect_plane = state.kernels->advect_plane[static_cast<std::size_t>(transport.interpolation)];
    state.parallel_for(state.box.cells.z, [&](int plane) { advect_plane(task, plane); });
    state.advect_one_sided(task, false, transport.interpolation);
}

} // namespace windrow
