// Departure points and interpolation of a velocity field.
//
//   x0 = x - dt u(x),  v1 = V(x0) (trilinear),  xd = x - dt/2 (u(x) + v1),  result(x) = R(xd)
//
// Displacements are kept apart from the cell's index, d = xd - x in cells, so that a flow gives the same bits wherever
// in the box it is. Interpolation is written as c + sum w (value - c): float weights do not sum to 1, and a
// uniform wind must stay uniform to the bit. A row goes through short loops, so that each keeps few registers alive.

struct PaddedStrides {
    std::ptrdiff_t row, plane; // in cells
};
inline PaddedStrides padded_strides(const int cells[3]) {
    const std::ptrdiff_t row = cells[0] + k_halo;
    return {row, row * (cells[1] + k_halo)};
}

// A point to sample at: the padded cell below it on each axis, and its distance from that cell's centre in [0, 1].
struct Locator {
    Cell low, high, period, inverse_period;
    PaddedStrides strides;

    explicit Locator(const AdvectTask& task)
        : low(load_cell(task.low)), high(load_cell(task.high)), period(load_cell(task.period)), inverse_period(load_cell(task.inverse_period)),
          strides(padded_strides(task.cells)) {}

    // `cell` is the index of the arrival cell, `displacement` in cells.
    std::ptrdiff_t locate(Cell cell, Cell displacement, Cell& fraction) const {
        const Cell legal = clamp_to(displacement, low - cell, high - cell);
        const Cell whole = floor_of(legal);
        fraction = legal - whole;
        Cell base = cell + whole;
        base -= period * floor_of(base * inverse_period);
        const CellInt index = __builtin_convertvector(base, CellInt) + k_halo_low;
        return index[2] * strides.plane + index[1] * strides.row + index[0];
    }
};

inline Cell lerp(Cell a, Cell b, Cell t) { return multiply_add(t, b - a, a); }

struct Linear {
    static Cell sample(const float* at, const PaddedStrides& strides, Cell t) {
        const Cell tx = splat(t[0]), ty = splat(t[1]), tz = splat(t[2]);
        Cell planes[2];
        for (int k = 0; k < 2; ++k) {
            const float* const p = at + 4 * k * strides.plane;
            const float* const q = p + 4 * strides.row;
            planes[k] = lerp(lerp(load_cell(p), load_cell(p + 4), tx), lerp(load_cell(q), load_cell(q + 4), tx), ty);
        }
        return lerp(planes[0], planes[1], tz);
    }
};

// Lagrange weights of the nodes -1, 1, 2 at t (node 0 takes what is left of 1).
struct CubicWeights {
    Cell before, after, beyond;
    explicit CubicWeights(Cell t) {
        const Cell one = splat(1.0f), two = splat(2.0f);
        const Cell a = t - one, b = t - two, c = t + one;
        before = t * a * b * splat(-1.0f / 6.0f);
        after = c * t * b * splat(-0.5f);
        beyond = c * t * a * splat(1.0f / 6.0f);
    }
};

struct Cubic {
    static Cell sample(const float* at, const PaddedStrides& strides, Cell t) {
        const CubicWeights w(t);
        Block planes[4];
        const float* const corner = at - 4 * (1 + strides.row + strides.plane);
        for (int k = 0; k < 4; ++k) {
            const float* const p = corner + 4 * k * strides.plane;
            const Block centre = load_block(p + 4 * strides.row);
            Block sum = multiply_add(load_block(p) - centre, w.before[1], centre);
            sum = multiply_add(load_block(p + 8 * strides.row) - centre, w.after[1], sum);
            planes[k] = multiply_add(load_block(p + 12 * strides.row) - centre, w.beyond[1], sum);
        }
        Block line = multiply_add(planes[0] - planes[1], w.before[2], planes[1]);
        line = multiply_add(planes[2] - planes[1], w.after[2], line);
        line = multiply_add(planes[3] - planes[1], w.beyond[2], line);
        const Cell here = cell_of<1>(line);
        Cell sum = multiply_add(cell_of<0>(line) - here, splat(w.before[0]), here);
        sum = multiply_add(cell_of<2>(line) - here, splat(w.after[0]), sum);
        return multiply_add(cell_of<3>(line) - here, splat(w.beyond[0]), sum);
    }
};

constexpr int k_row_chunk = 64;

// Departure points of `count` cells from (i0, j, k): padded offsets and fractions.
inline void trace_row(const AdvectTask& task, const Locator& locator, int i0, int j, int k, int count, std::ptrdiff_t* offsets,
                      Cell* fractions) {
    const std::size_t first = (static_cast<std::size_t>(k) * task.cells[1] + j) * task.cells[0] + i0;
    const float* const velocity = task.velocity + 4 * first;
    const Cell full = splat(-task.cells_per_speed), half = splat(-0.5f * task.cells_per_speed);
    for (int n = 0; n < count; ++n) {
        const Cell cell = {float(i0 + n), float(j), float(k), 0.0f};
        offsets[n] = locator.locate(cell, full * load_cell(velocity + 4 * n), fractions[n]);
    }
    for (int n = 0; n < count; ++n) {
        const Cell cell = {float(i0 + n), float(j), float(k), 0.0f};
        const Cell traced = Linear::sample(task.padded_trace + 4 * offsets[n], locator.strides, fractions[n]);
        offsets[n] = locator.locate(cell, half * (load_cell(velocity + 4 * n) + traced), fractions[n]);
    }
}

template <class Interpolant>
void advect_plane(const AdvectTask& task, int plane) {
    const Locator locator(task);
    std::ptrdiff_t offsets[k_row_chunk];
    Cell fractions[k_row_chunk];
    for (int j = 0; j < task.cells[1]; ++j) {
        for (int i0 = 0; i0 < task.cells[0]; i0 += k_row_chunk) {
            const int left = task.cells[0] - i0;
            const int count = left < k_row_chunk ? left : k_row_chunk;
            trace_row(task, locator, i0, j, plane, count, offsets, fractions);
            float* const result = task.result + 4 * ((static_cast<std::size_t>(plane) * task.cells[1] + j) * task.cells[0] + i0);
            for (int n = 0; n < count; ++n)
                store_cell(result + 4 * n, Interpolant::sample(task.padded_carried + 4 * offsets[n], locator.strides, fractions[n]));
        }
    }
}
