// Advection of a scalar along the wind's trajectories. Walls mirror it, open boundaries hold the caller's outside value.
#include "fluid/core/message.h"
#include "fluid/cpu/workspace.h"

#include <cassert>

namespace windrow {

Result<void> advect(Workspace& work, const ScalarTransport& transport, std::span<float> result) {
    Workspace::State& state = work.state();
    const Box& box = state.box;
    assert(transport.carried.size() == box.cell_count() && transport.velocity.size() == box.cell_count() &&
           result.size() == box.cell_count());
    if (state.padded_scalar.empty() &&
        !detail::memory_lasts([&] { state.padded_scalar = cpu::Buffer<float>(state.padded_cells()); }))
        return detail::out_of_memory();

    // The trace reads the padded wind, so the wind is gathered as for its own advection.
    cpu::PadTask pad{};
    for (int axis = 0; axis < 3; ++axis) {
        pad.cells[axis] = box.cells[axis];
        pad.rules[axis] = state.carried_rules[axis].data();
        pad.ambient[axis] = state.ambient[axis];
    }
    pad.carried = pad.velocity = cpu::floats(transport.velocity);
    pad.relaxation = 1.0f;
    pad.padded_carried = state.padded_carried.data();
    pad.padded_trace = box.rows ? state.padded_trace.data() : nullptr;
    pad.row_scales = state.row_scales();
    const glm::ivec3 padded = box.cells + k_halo;
    state.parallel_for(padded.z, [&](int plane) {
        state.kernels->pad_plane(pad, plane);
        const HaloRule& z = state.rules[2][plane];
        float* to = state.padded_scalar.data() + static_cast<std::size_t>(plane) * padded.x * padded.y;
        for (int row = 0; row < padded.y; ++row) {
            const HaloRule& y = state.rules[1][row];
            for (const HaloRule& x : state.rules[0])
                *to++ = x.ambient || y.ambient || z.ambient ? transport.outside
                                                            : transport.carried[box.index(x.source, y.source, z.source)];
        }
    });

    cpu::AdvectTask task = state.advect_task();
    task.velocity = pad.velocity;
    task.padded_trace = box.rows ? pad.padded_trace : pad.padded_carried;
    task.padded_carried = state.padded_scalar.data();
    task.result = result.data();
    task.cells_per_speed = transport.dt / box.cell_size;
    task.clamped = transport.clamped;
    const auto advect_plane = state.kernels->advect_scalar_plane[static_cast<std::size_t>(transport.interpolation)];
    state.parallel_for(box.cells.z, [&](int plane) { advect_plane(task, plane); });
    state.advect_one_sided(task, true, transport.interpolation);
    return {};
}

} // namespace windrow
