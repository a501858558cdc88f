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

constexpr int k_row_chunk = 64;

// Points to sample at, for a run of cells along x: the padded cell below each, and the distance from its centre in [0, 1] by axis.
struct Points {
    alignas(64) std::int32_t offset[k_row_chunk];
    alignas(64) float fraction[3][k_row_chunk];
};

// Displacements of a run of cells from their own index, by axis. [cells]
struct Displacements {
    alignas(64) float axis[3][k_row_chunk];
};

inline float floor_small(float value) {
    const auto whole = static_cast<float>(static_cast<std::int32_t>(value));
    return whole > value ? whole - 1.0f : whole;
}

// One axis of `locate`: cell n of the run has index first + n * advance. A comparison with NaN is false, so that a broken position
// becomes the low end and its address stays legal.
inline void locate_axis(const AdvectTask& task, int axis, float first, float advance, std::int32_t stride, int count,
                        const float* displacement, Points& points) {
    const float low = task.low[axis], high = task.high[axis], period = task.period[axis], inverse_period = task.inverse_period[axis];
    float* const fraction = points.fraction[axis];
    std::int32_t* const offset = points.offset;
    for (int n = 0; n < count; ++n) {
        const float cell = first + advance * static_cast<float>(n);
        const float least = low - cell, most = high - cell;
        float legal = displacement[n] > least ? displacement[n] : least;
        legal = legal < most ? legal : most;
        const float whole = floor_small(legal);
        fraction[n] = legal - whole;
        float base = cell + whole;
        base -= period * floor_small(base * inverse_period);
        offset[n] += (static_cast<std::int32_t>(base) + k_halo_low) * stride;
    }
}

inline void locate(const AdvectTask& task, const PaddedStrides& strides, int i0, int j, int k, int count, const Displacements& displacements,
                   Points& points) {
    for (int n = 0; n < count; ++n)
        points.offset[n] = 0;
    locate_axis(task, 0, static_cast<float>(i0), 1.0f, 1, count, displacements.axis[0], points);
    locate_axis(task, 1, static_cast<float>(j), 0.0f, static_cast<std::int32_t>(strides.row), count, displacements.axis[1], points);
    locate_axis(task, 2, static_cast<float>(k), 0.0f, static_cast<std::int32_t>(strides.plane), count, displacements.axis[2], points);
}

inline Cell lerp(Cell a, Cell b, Cell t) { return multiply_add(t, b - a, a); }

struct Linear {
    struct Weights {
        const float *x, *y, *z;
        Weights(const Points& points, int) : x(points.fraction[0]), y(points.fraction[1]), z(points.fraction[2]) {}
    };

    static Cell sample(const float* at, const PaddedStrides& strides, const Weights& w, int n) {
        const Cell tx = splat(w.x[n]), ty = splat(w.y[n]), tz = splat(w.z[n]);
        const float* const up = at + 4 * strides.plane;
        const float* const over = at + 4 * strides.row;
        const float* const both = up + 4 * strides.row;
        const Cell left = lerp(lerp(load_cell(at), load_cell(up), tz), lerp(load_cell(over), load_cell(both), tz), ty);
        const Cell right = lerp(lerp(load_cell(at + 4), load_cell(up + 4), tz), lerp(load_cell(over + 4), load_cell(both + 4), tz), ty);
        return lerp(left, right, tx);
    }
};

struct Cubic {
    // Lagrange weights of the nodes -1, 1, 2 by axis; node 0 takes what is left of 1.
    struct Weights {
        alignas(64) float before[3][k_row_chunk], after[3][k_row_chunk], beyond[3][k_row_chunk];

        Weights(const Points& points, int count) {
            for (int axis = 0; axis < 3; ++axis)
                for (int n = 0; n < count; ++n) {
                    const float t = points.fraction[axis][n];
                    const float a = t - 1.0f, b = t - 2.0f, c = t + 1.0f;
                    before[axis][n] = t * a * b * (-1.0f / 6.0f);
                    after[axis][n] = c * t * b * -0.5f;
                    beyond[axis][n] = c * t * a * (1.0f / 6.0f);
                }
        }
    };

    static Cell sample(const float* at, const PaddedStrides& strides, const Weights& w, int n) {
        Block planes[4];
        const float* const corner = at - 4 * (1 + strides.row + strides.plane);
        for (int k = 0; k < 4; ++k) {
            const float* const p = corner + 4 * k * strides.plane;
            const Block centre = load_block(p + 4 * strides.row);
            Block sum = multiply_add(load_block(p) - centre, w.before[1][n], centre);
            sum = multiply_add(load_block(p + 8 * strides.row) - centre, w.after[1][n], sum);
            planes[k] = multiply_add(load_block(p + 12 * strides.row) - centre, w.beyond[1][n], sum);
        }
        Block line = multiply_add(planes[0] - planes[1], w.before[2][n], planes[1]);
        line = multiply_add(planes[2] - planes[1], w.after[2][n], line);
        line = multiply_add(planes[3] - planes[1], w.beyond[2][n], line);
        const Cell here = cell_of<1>(line);
        Cell sum = multiply_add(cell_of<0>(line) - here, splat(w.before[0][n]), here);
        sum = multiply_add(cell_of<2>(line) - here, splat(w.after[0][n]), sum);
        return multiply_add(cell_of<3>(line) - here, splat(w.beyond[0][n]), sum);
    }
};

// Departure points of `count` cells from (i0, j, k).
inline void trace_row(const AdvectTask& task, const PaddedStrides& strides, int i0, int j, int k, int count, Points& points) {
    const std::size_t first = (static_cast<std::size_t>(k) * task.cells[1] + j) * task.cells[0] + i0;
    const float* const velocity = task.velocity + 4 * first;
    Displacements displacements;
    for (int n = 0; n < count; ++n)
        for (int axis = 0; axis < 3; ++axis)
            displacements.axis[axis][n] = -task.cells_per_speed * velocity[4 * n + axis];
    locate(task, strides, i0, j, k, count, displacements, points);

    alignas(64) float traced[4 * k_row_chunk];
    const Linear::Weights weights(points, count);
    for (int n = 0; n < count; ++n)
        store_cell(traced + 4 * n, Linear::sample(task.padded_trace + 4 * static_cast<std::ptrdiff_t>(points.offset[n]), strides, weights, n));
    for (int n = 0; n < count; ++n)
        for (int axis = 0; axis < 3; ++axis)
            displacements.axis[axis][n] = -0.5f * task.cells_per_speed * (velocity[4 * n + axis] + traced[4 * n + axis]);
    locate(task, strides, i0, j, k, count, displacements, points);
}

// Calls row(points, first cell of the result, count) for each run of cells of a plane.
template <class Row>
inline void for_each_run(const AdvectTask& task, int plane, const Row& row) {
    const PaddedStrides strides = padded_strides(task.cells);
    Points points;
    for (int j = 0; j < task.cells[1]; ++j)
        for (int i0 = 0; i0 < task.cells[0]; i0 += k_row_chunk) {
            const int left = task.cells[0] - i0;
            const int count = left < k_row_chunk ? left : k_row_chunk;
            trace_row(task, strides, i0, j, plane, count, points);
            row(strides, points, (static_cast<std::size_t>(plane) * task.cells[1] + j) * task.cells[0] + i0, count);
        }
}

template <class Interpolant>
void advect_plane(const AdvectTask& task, int plane) {
    for_each_run(task, plane, [&](const PaddedStrides& strides, const Points& points, std::size_t first, int count) {
        const typename Interpolant::Weights weights(points, count);
        float* const result = task.result + 4 * first;
        for (int n = 0; n < count; ++n) {
            const float* const at = task.padded_carried + 4 * static_cast<std::ptrdiff_t>(points.offset[n]);
            store_cell(result + 4 * n, Interpolant::sample(at, strides, weights, n));
        }
    });
}
