// Gathers the fields that an advection reads, with their halo, straight from the unpadded state: one pass, no barrier.
//
//   R = ambient + g (carried - ambient) - s q      V = (1 + a) u - a u_old
//
// A halo cell takes the value of a cell inside, mirrored or wrapped by the product of its axes' rules, or the ambient wind.

struct CombinedRule {
    Cell scale = splat(1.0f), offset = splat(0.0f), history_scale = splat(1.0f);
    bool identity = true;

    // The rule that applies `outer` to what this one gives.
    CombinedRule then(const HaloRule& outer) const {
        if (outer.identity)
            return *this;
        CombinedRule rule;
        rule.scale = load_cell(outer.scale) * scale;
        rule.offset = load_cell(outer.scale) * offset + load_cell(outer.offset);
        rule.history_scale = load_cell(outer.history_scale) * history_scale;
        rule.identity = false;
        return rule;
    }
};

// `padded` is the padded index of the cell itself, for its ambient wind.
inline Cell gather_carried(const PadTask& task, std::size_t cell, std::ptrdiff_t padded, const CombinedRule& rule) {
    Cell value = load_cell(task.carried + 4 * cell);
    if (task.settling != 1.0f) {
        const Cell ambient = load_cell(task.ambient_cells != nullptr ? task.ambient_cells + 4 * padded : task.ambient);
        value = ambient + splat(task.settling) * (value - ambient);
    }
    if (!rule.identity)
        value = rule.scale * value + rule.offset;
    if (task.history != nullptr) {
        Cell history = load_cell(task.history + 4 * cell);
        if (!rule.identity)
            history *= rule.history_scale;
        value -= splat(task.history_scale) * history;
    }
    return value;
}

inline Cell gather_trace(const PadTask& task, std::size_t cell, const CombinedRule& rule) {
    Cell value = load_cell(task.velocity + 4 * cell);
    if (task.velocity_old != nullptr)
        value += splat(task.extrapolation) * (value - load_cell(task.velocity_old + 4 * cell));
    return rule.identity ? value : rule.scale * value + rule.offset;
}

void pad_plane(const PadTask& task, int padded_plane) {
    const PaddedStrides strides = padded_strides(task.cells);
    const HaloRule& plane_rule = task.rules[2][padded_plane];
    for (int row = 0; row < task.cells[1] + k_halo; ++row) {
        const HaloRule& row_rule = task.rules[1][row];
        const std::ptrdiff_t target = padded_plane * strides.plane + row * strides.row;
        float* const carried = task.padded_carried + 4 * target;
        float* const trace = task.padded_trace != nullptr ? task.padded_trace + 4 * target : nullptr;
        const bool row_ambient = plane_rule.ambient || row_rule.ambient;
        const CombinedRule outer = CombinedRule{}.then(row_rule).then(plane_rule);
        const std::size_t source = (static_cast<std::size_t>(plane_rule.source) * task.cells[1] + row_rule.source) * task.cells[0];
        const std::ptrdiff_t padded_source =
            (plane_rule.source + k_halo_low) * strides.plane + (row_rule.source + k_halo_low) * strides.row + k_halo_low;

        const auto put = [&](int column) {
            const HaloRule& rule = task.rules[0][column];
            if (row_ambient || rule.ambient) {
                const auto ambient = [&](const float* cells) { return load_cell(cells != nullptr ? cells + 4 * (target + column) : task.ambient); };
                store_cell(carried + 4 * column, ambient(task.ambient_cells));
                if (trace != nullptr)
                    store_cell(trace + 4 * column, ambient(task.trace_ambient_cells));
                return;
            }
            const CombinedRule whole = CombinedRule{}.then(rule).then(row_rule).then(plane_rule);
            store_cell(carried + 4 * column, gather_carried(task, source + rule.source, padded_source + rule.source, whole));
            if (trace != nullptr)
                store_cell(trace + 4 * column, gather_trace(task, source + rule.source, whole));
        };
        for (int column = 0; column < k_halo_low; ++column)
            put(column);
        if (row_ambient || !outer.identity) {
            for (int column = k_halo_low; column < k_halo_low + task.cells[0]; ++column)
                put(column);
        } else {
            for (int i = 0; i < task.cells[0]; ++i)
                store_cell(carried + 4 * (i + k_halo_low), gather_carried(task, source + i, padded_source + i, outer));
            if (trace != nullptr)
                for (int i = 0; i < task.cells[0]; ++i)
                    store_cell(trace + 4 * (i + k_halo_low), gather_trace(task, source + i, outer));
        }
        for (int column = k_halo_low + task.cells[0]; column < task.cells[0] + k_halo; ++column)
            put(column);
    }
}
