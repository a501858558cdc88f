// Gather of the fields that an advection reads, with their halo, directly from the unpadded state: one pass, no barrier.
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

// A run of cells along x. `values` and its companions point at the first cell; V is Cell or Native. Values that are constant in
// the run are copied to locals: the stores are to floats, as the task's members are, and would force a reload each time.
template <class V>
struct CarriedRun {
    const float *values, *history, *ambient_cells;
    V ambient, relaxation, history_scale, scale, offset, rule_history_scale;
    bool settles, remembers, identity;

    V at(std::ptrdiff_t n) const {
        V value = load<V>(values + n);
        if (settles) {
            const V around = ambient_cells != nullptr ? load<V>(ambient_cells + n) : ambient;
            value = around + relaxation * (value - around);
        }
        if (!identity)
            value = scale * value + offset;
        if (remembers) {
            V past = load<V>(history + n);
            if (!identity)
                past *= rule_history_scale;
            value -= history_scale * past;
        }
        return value;
    }
};

template <class V>
struct TraceRun {
    const float *values, *old_values;
    V extrapolation, scale, offset;
    bool extrapolates, identity;

    V at(std::ptrdiff_t n) const {
        V value = load<V>(values + n);
        if (extrapolates)
            value += extrapolation * (value - load<V>(old_values + n));
        return identity ? value : scale * value + offset;
    }
};

// `cell` and `padded` are the unpadded and the padded index of the cell that the run starts from.
template <class V>
CarriedRun<V> carried_run(const PadTask& task, std::size_t cell, std::ptrdiff_t padded, const CombinedRule& rule) {
    CarriedRun<V> run;
    run.values = task.carried + 4 * cell;
    run.remembers = task.history != nullptr;
    run.history = run.remembers ? task.history + 4 * cell : nullptr;
    run.settles = task.relaxation != 1.0f;
    run.ambient_cells = task.ambient_cells != nullptr ? task.ambient_cells + 4 * padded : nullptr;
    run.ambient = repeat<V>(load_cell(task.ambient));
    run.relaxation = repeat<V>(splat(task.relaxation));
    run.history_scale = repeat<V>(splat(task.history_scale));
    run.identity = rule.identity;
    run.scale = repeat<V>(rule.scale);
    run.offset = repeat<V>(rule.offset);
    run.rule_history_scale = repeat<V>(rule.history_scale);
    return run;
}

template <class V>
TraceRun<V> trace_run(const PadTask& task, std::size_t cell, const CombinedRule& rule) {
    TraceRun<V> run;
    run.values = task.velocity + 4 * cell;
    run.extrapolates = task.velocity_old != nullptr;
    run.old_values = run.extrapolates ? task.velocity_old + 4 * cell : nullptr;
    run.extrapolation = repeat<V>(splat(task.extrapolation));
    run.identity = rule.identity;
    run.scale = repeat<V>(rule.scale);
    run.offset = repeat<V>(rule.offset);
    return run;
}

// Writes run.at(n) for each of `floats` floats: whole registers, then cells.
template <class WideRun, class CellRun>
inline void write_run(const WideRun& wide, const CellRun& cells, int floats, float* to) {
    int n = 0;
    for (; n + k_native_lanes <= floats; n += k_native_lanes)
        store_native(to + n, wide.at(n));
    for (; n < floats; n += 4)
        store_cell(to + n, cells.at(n));
}

// The trace's y in rows: along it a trajectory counts rows.
inline void scale_rows(const PadTask& task, int row, float* trace) {
    if (task.row_scales == nullptr || trace == nullptr)
        return;
    const int j = row - k_halo_low, last = task.cells[1] - 1;
    const HaloRule& rule = task.rules[1][row];
    const float scale = task.row_scales[rule.ambient ? (j < 0 ? 0 : last) : rule.source];
    for (int column = 0; column < task.cells[0] + k_halo; ++column)
        trace[4 * column + 1] *= scale;
}

void pad_plane(const PadTask& task, int padded_plane) {
    const PaddedStrides strides = padded_strides(task.cells);
    const HaloRule& plane_rule = task.rules[2][padded_plane];
    const int columns = task.cells[0] + k_halo;
    for (int row = 0; row < task.cells[1] + k_halo; ++row) {
        const HaloRule& row_rule = task.rules[1][row];
        const std::ptrdiff_t target = padded_plane * strides.plane + row * strides.row;
        float* const carried = task.padded_carried + 4 * target;
        float* const trace = task.padded_trace != nullptr ? task.padded_trace + 4 * target : nullptr;

        const auto put_ambient = [&](float* to, const float* cells, int first, int last) {
            const Cell everywhere = load_cell(task.ambient);
            for (int column = first; column < last; ++column)
                store_cell(to + 4 * column, cells != nullptr ? load_cell(cells + 4 * (target + column)) : everywhere);
        };
        const auto put_ambient_both = [&](int first, int last) {
            put_ambient(carried, task.ambient_cells, first, last);
            if (trace != nullptr)
                put_ambient(trace, task.trace_ambient_cells, first, last);
        };
        if (plane_rule.ambient || row_rule.ambient) {
            put_ambient_both(0, columns);
            scale_rows(task, row, trace);
            continue;
        }

        const std::size_t source =
            (static_cast<std::size_t>(plane_rule.source) * task.cells[1] + row_rule.source) * task.cells[0];
        const std::ptrdiff_t padded_source =
            (plane_rule.source + k_halo_low) * strides.plane + (row_rule.source + k_halo_low) * strides.row + k_halo_low;
        const CombinedRule outer = CombinedRule{}.then(row_rule).then(plane_rule);
        const int floats = 4 * task.cells[0];
        write_run(carried_run<Native>(task, source, padded_source, outer), carried_run<Cell>(task, source, padded_source, outer),
                  floats, carried + 4 * k_halo_low);
        if (trace != nullptr)
            write_run(trace_run<Native>(task, source, outer), trace_run<Cell>(task, source, outer), floats,
                      trace + 4 * k_halo_low);

        const auto put = [&](int column) {
            const HaloRule& rule = task.rules[0][column];
            if (rule.ambient) {
                put_ambient_both(column, column + 1);
                return;
            }
            const CombinedRule whole = CombinedRule{}.then(rule).then(row_rule).then(plane_rule);
            store_cell(carried + 4 * column,
                       carried_run<Cell>(task, source + rule.source, padded_source + rule.source, whole).at(0));
            if (trace != nullptr)
                store_cell(trace + 4 * column, trace_run<Cell>(task, source + rule.source, whole).at(0));
        };
        for (int column = 0; column < k_halo_low; ++column)
            put(column);
        for (int column = k_halo_low + task.cells[0]; column < columns; ++column)
            put(column);
        scale_rows(task, row, trace);
    }
}
