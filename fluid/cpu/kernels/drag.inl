// Halves of drag over some cells of a row where nothing else acts (shaders/numerics/splitting.glsl), a register of cells at a time: the
// operations of the formula for single cells, in their order, so that each level has the formula's bits. Cells of a register are in
// the order of `deal`.

// 1 + way |u|, by which drag divides a speed.
inline Native slowing(Native way, const DealtCells& u) {
    return 1.0f + way * square_root(u.x * u.x + u.y * u.y + u.z * u.z);
}

// a where the mask is set, else b.
inline Native select(NativeBits mask, Native a, Native b) {
    return reinterpret_cast<Native>((mask & reinterpret_cast<NativeBits>(a)) | (~mask & reinterpret_cast<NativeBits>(b)));
}

// visit(cells, way, first float of the cells) for each register of cells.
template <class Visit>
inline void for_each_register(const DragTask& task, const Visit& visit) {
    for (int first = 0; first < task.count; first += k_native_lanes) {
        const RowCells cells(task.count - first < k_native_lanes ? task.count - first : k_native_lanes);
        Native drag = task.canopy - Native{};
        if (task.deposits != nullptr)
            drag = drag + cells.read_floats(task.deposits + first);
        visit(cells, task.half * drag, 4 * static_cast<std::ptrdiff_t>(first));
    }
}

inline DealtCells departing(const DragTask& task, const RowCells& cells, std::ptrdiff_t at) {
    if (task.carried == nullptr)
        return dealt_cells(cells.read(task.wind + at));
    DealtCells u = dealt_cells(cells.read(task.carried + at));
    if (task.left != 1.0f) {
        u.x = task.rest[0] + task.left * (u.x - task.rest[0]);
        u.y = task.rest[1] + task.left * (u.y - task.rest[1]);
        u.z = task.rest[2] + task.left * (u.z - task.rest[2]);
    }
    return u;
}

void drag_departs(const DragTask& task) {
    for_each_register(task, [&](const RowCells& cells, Native way, std::ptrdiff_t at) {
        const CellRegisters before = cells.read(task.history + at);
        cells.write(before, task.kept + at);
        const DealtCells u = departing(task, cells, at);
        const Native slow = slowing(way, u);
        DealtCells history = dealt_cells(before);
        history.x = history.x - task.scale * (u.x / slow - u.x);
        history.y = history.y - task.scale * (u.y / slow - u.y);
        history.z = history.z - task.scale * (u.z / slow - u.z);
        cells.write(cells_of_dealt(history), task.history + at);
    });
}

void drag_arrives(const DragTask& task) {
    for_each_register(task, [&](const RowCells& cells, Native way, std::ptrdiff_t at) {
        const CellRegisters kept = cells.read(task.kept + at);
        cells.write(kept, task.history + at);
        const DealtCells q = dealt_cells(kept);
        const DealtCells rest = task.wind != nullptr ? dealt_cells(cells.read(task.wind + at)) : DealtCells{};
        const DealtCells pressure{task.scale * q.x, task.scale * q.y, task.scale * q.z, Native{}};
        DealtCells u = dealt_cells(cells.read(task.arrived + at));
        const DealtCells free{u.x + rest.x - pressure.x, u.y + rest.y - pressure.y, u.z + rest.z - pressure.z, Native{}};
        const Native slow = slowing(way, free), taken = 1.0f - 1.0f / slow, left = 1.0f - taken * taken;
        const NativeBits any = way > Native{};
        u.x = select(any, free.x / slow + left * pressure.x - rest.x, u.x);
        u.y = select(any, free.y / slow + left * pressure.y - rest.y, u.y);
        u.z = select(any, free.z / slow + left * pressure.z - rest.z, u.z);
        cells.write(cells_of_dealt(u), task.arrived + at);
    });
}

// windrow_lee in each cell of a row.
void deepen_lee(const LeeTask& task) {
    const Native deepest = text::WINDROW_DEEPEST_LEE - Native{};
    for (int first = 0; first < task.count; first += k_native_lanes) {
        const RowCells cells(task.count - first < k_native_lanes ? task.count - first : k_native_lanes);
        const std::ptrdiff_t at = 4 * static_cast<std::ptrdiff_t>(first);
        const DealtCells u = dealt_cells(cells.read(task.velocity + at)), high = dealt_cells(cells.read(task.above + at));
        const DealtCells low = task.below != nullptr ? dealt_cells(cells.read(task.below + at)) : DealtCells{};
        Native drag = task.canopy - Native{};
        if (task.deposits != nullptr)
            drag = drag + cells.read_floats(task.deposits + first);
        const Native shear = task.time_per_height * length(Level{high.x - low.x, high.z - low.z});
        const Native broken = drag * task.dt * square_root(u.x * u.x + u.y * u.y + u.z * u.z);
        const Native before = only(u.w > Native{}, u.w < deepest ? u.w : deepest);
        const Native lee = (before + broken) / (1.0f + 0.2f * shear + broken);
        DealtCells carried = dealt_cells(cells.read(task.carried + at));
        carried.w = lee < deepest ? lee : deepest;
        cells.write(cells_of_dealt(carried), task.carried + at);
    }
}
