// Departure points and interpolation of a velocity field.
//
//   x0 = x - dt u(x),  v1 = V(x0) (trilinear),  xd = x - dt/2 (u(x) + v1),  result(x) = R(xd)
//
// Displacements are kept apart from the cell's index, d = xd - x in cells, so that a flow gives the same bits at any place in
// the box. Interpolation is written as c + sum w (value - c): float weights do not sum to 1, and a uniform wind must stay
// uniform to the bit. A row is processed by short loops, so that each uses few registers.

struct PaddedStrides {
    std::ptrdiff_t row, plane; // in cells
};
inline PaddedStrides padded_strides(const int cells[3]) {
    const std::ptrdiff_t row = cells[0] + k_halo;
    return {row, row * (cells[1] + k_halo)};
}

inline std::ptrdiff_t padded_index(const PaddedStrides& strides, int i, int j, int k) {
    return (k + k_halo_low) * strides.plane + (j + k_halo_low) * strides.row + i + k_halo_low;
}

// A run of cells along x, from cell (i, j, k).
struct CellRun {
    int i, j, k, count;
    std::size_t first; ///< index of the first cell
};

constexpr int k_row_chunk = 64;

// Sample points of a run of cells along x: the padded cell below each, and the distance from its centre in [0, 1] by axis.
// Arrays of a run are filled in whole groups of k_lanes, so that the loops over a group have no remainder. Entries beyond the
// run's cells are legal to read at, and not used.
struct Points {
    alignas(64) std::int32_t offset[k_row_chunk];
    alignas(64) float fraction[3][k_row_chunk];
};

// Displacements of a run of cells from their own index, by axis. [cells]
struct Displacements {
    alignas(64) float axis[3][k_row_chunk];
};

// The cell below a place, from the low end of the axis, and the distance from its centre.
struct AxisPlace {
    float base, fraction;
};

// Clamp of a displacement from a cell. A comparison with NaN is false, so that a non-finite position becomes the low end and its
// address stays legal.
template <int Axis, bool Wraps = true>
inline AxisPlace place_of(const Legal& legal, float cell, float displacement) {
    const float least = legal.low[Axis] - cell, most = legal.high[Axis] - cell;
    float way = displacement > least ? displacement : least;
    way = way < most ? way : most;
    const float whole = floor_small(way), base = cell + whole;
    return {Wraps ? base - legal.period[Axis] * floor_small(base * legal.inverse_period[Axis]) : base, way - whole};
}

// One axis of `locate`: cell n of the run has index first + n * advance.
template <int Axis, bool Wraps>
inline void locate_axis(const Legal& legal, float first, float advance, std::int32_t stride, int count,
                        const Displacements& displacements, Points& points) {
    for (int group = 0; group < count; group += k_lanes)
        for (int lane = 0; lane < k_lanes; ++lane) {
            const int n = group + lane;
            const AxisPlace place =
                place_of<Axis, Wraps>(legal, first + advance * static_cast<float>(n), displacements.axis[Axis][n]);
            points.fraction[Axis][n] = place.fraction;
            const std::int32_t offset = (static_cast<std::int32_t>(place.base) + k_halo_low) * stride;
            points.offset[n] = Axis == 0 ? offset : points.offset[n] + offset;
        }
}

// To wrap where no axis is periodic changes no bit, and takes a third of the time.
template <bool Wraps>
inline void locate_all(const Legal& legal, const PaddedStrides& strides, const CellRun& run, const Displacements& displacements,
                       Points& points) {
    const auto row = static_cast<std::int32_t>(strides.row), plane = static_cast<std::int32_t>(strides.plane);
    locate_axis<0, Wraps>(legal, static_cast<float>(run.i), 1.0f, 1, run.count, displacements, points);
    locate_axis<1, Wraps>(legal, static_cast<float>(run.j), 0.0f, row, run.count, displacements, points);
    locate_axis<2, Wraps>(legal, static_cast<float>(run.k), 0.0f, plane, run.count, displacements, points);
}

inline void locate(const Legal& legal, const PaddedStrides& strides, const CellRun& run, const Displacements& displacements,
                   Points& points) {
    if (legal.period[0] != 0.0f || legal.period[1] != 0.0f || legal.period[2] != 0.0f)
        locate_all<true>(legal, strides, run, displacements, points);
    else
        locate_all<false>(legal, strides, run, displacements, points);
}

struct Linear {
    using Line = Pair;
    static constexpr bool k_cubic = false;

    struct Weights {
        const float *x, *y, *z;
        Weights(const Points& points, int) : x(points.fraction[0]), y(points.fraction[1]), z(points.fraction[2]) {}
    };

    // Both x-neighbours of a point, interpolated along y and z.
    static Pair sample_line(const float* at, const PaddedStrides& strides, const Weights& w, int n) {
        const float* const up = at + 4 * strides.plane;
        const Pair near = lerp(load_pair(at), load_pair(up), w.z[n]);
        const Pair over = lerp(load_pair(at + 4 * strides.row), load_pair(up + 4 * strides.row), w.z[n]);
        return lerp(near, over, w.y[n]);
    }

    static Native sample_x(const Pair (&lines)[k_native_cells], const Weights& w, int n) {
        const Ends ends = transpose(lines);
        return multiply_add(spread(w.x + n), ends.after - ends.here, ends.here);
    }
};

struct Cubic {
    using Line = Block;
    static constexpr bool k_cubic = true;

    // Lagrange weights of the nodes -1, 1, 2 by axis; node 0 takes the rest of 1.
    struct Weights {
        alignas(64) float before[3][k_row_chunk], after[3][k_row_chunk], beyond[3][k_row_chunk];

        Weights(const Points& points, int count) {
            for (int axis = 0; axis < 3; ++axis)
                for (int group = 0; group < count; group += k_lanes)
                    for (int lane = 0; lane < k_lanes; ++lane) {
                        const int n = group + lane;
                        const float t = points.fraction[axis][n];
                        const float a = t - 1.0f, b = t - 2.0f, c = t + 1.0f;
                        before[axis][n] = t * a * b * (-1.0f / 6.0f);
                        after[axis][n] = c * t * b * -0.5f;
                        beyond[axis][n] = c * t * a * (1.0f / 6.0f);
                    }
        }
    };

    // The four columns around a point, interpolated along y and z: nodes -1, 0, 1, 2 of x.
    static Block sample_line(const float* at, const PaddedStrides& strides, const Weights& w, int n) {
        Block planes[4];
        const float* const corner = at - 4 * (1 + strides.row + strides.plane);
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            const float* const p = corner + 4 * k * strides.plane;
            const Block centre = load_block(p + 4 * strides.row);
            Block sum = multiply_add(load_block(p) - centre, w.before[1][n], centre);
            sum = multiply_add(load_block(p + 8 * strides.row) - centre, w.after[1][n], sum);
            planes[k] = multiply_add(load_block(p + 12 * strides.row) - centre, w.beyond[1][n], sum);
        }
        Block line = multiply_add(planes[0] - planes[1], w.before[2][n], planes[1]);
        line = multiply_add(planes[2] - planes[1], w.after[2][n], line);
        return multiply_add(planes[3] - planes[1], w.beyond[2][n], line);
    }

    static Native sample_x(const Block (&lines)[k_native_cells], const Weights& w, int n) {
        const Nodes nodes = transpose(lines);
        Native sum = multiply_add(nodes.before - nodes.here, spread(w.before[0] + n), nodes.here);
        sum = multiply_add(nodes.after - nodes.here, spread(w.after[0] + n), sum);
        return multiply_add(nodes.beyond - nodes.here, spread(w.beyond[0] + n), sum);
    }
};

// 32 of those cells: LLL + BLL + LBL + LLB (Interpolation::cubic_32).
struct Cubic32 {
    struct Line {
        Block inner; ///< interpolated linearly along y and z: nodes -1, 0, 1, 2 of x
        Pair added;  ///< what the cubic adds along y and along z: nodes 0, 1 of x
    };
    static constexpr bool k_cubic = true;

    struct Weights {
        Cubic::Weights cubic;
        const float *x, *y, *z;
        Weights(const Points& points, int count)
            : cubic(points, count), x(points.fraction[0]), y(points.fraction[1]), z(points.fraction[2]) {}
    };

    // What the cubic adds to the linear value between two of four rows. Their weights sum to 0.
    static Pair added(Pair before, Pair here, Pair after, Pair beyond, const Weights& w, int axis, float t, int n, Pair sum) {
        sum = multiply_add(before - here, w.cubic.before[axis][n], sum);
        sum = multiply_add(after - here, w.cubic.after[axis][n] - t, sum);
        return multiply_add(beyond - here, w.cubic.beyond[axis][n], sum);
    }

    static Line sample_line(const float* at, const PaddedStrides& strides, const Weights& w, int n) {
        const std::ptrdiff_t row = 4 * strides.row, plane = 4 * strides.plane;
        const float y = w.y[n], z = w.z[n];
        const float* const from = at - 4;
        const Block near = lerp(load_block(from), load_block(from + row), y);
        const Block over = lerp(load_block(from + plane), load_block(from + plane + row), y);
        const auto along_y = [&](std::ptrdiff_t k) { return lerp(load_pair(at + k), load_pair(at + k + row), y); };
        const auto along_z = [&](std::ptrdiff_t j) { return lerp(load_pair(at + j), load_pair(at + j + plane), z); };
        const Pair sum = added(along_z(-row), along_z(0), along_z(row), along_z(2 * row), w, 1, y, n, Pair{});
        return {lerp(near, over, z), added(along_y(-plane), middle(near), middle(over), along_y(2 * plane), w, 2, z, n, sum)};
    }

    static Native sample_x(const Line (&lines)[k_native_cells], const Weights& w, int n) {
        Block inner[k_native_cells];
        Pair more[k_native_cells];
#pragma GCC unroll 4
        for (int cell = 0; cell < k_native_cells; ++cell) {
            inner[cell] = lines[cell].inner;
            more[cell] = lines[cell].added;
        }
        const Ends ends = transpose(more);
        return Cubic::sample_x(inner, w.cubic, n) + multiply_add(spread(w.x + n), ends.after - ends.here, ends.here);
    }
};

// Samples at as many cells as a register holds, from cell n of the run: their lines are adjacent, so that one operation does x.
template <class Interpolant>
inline Native sample(const float* field, const Points& points, const PaddedStrides& strides,
                     const typename Interpolant::Weights& w, int n) {
    typename Interpolant::Line lines[k_native_cells];
#pragma GCC unroll 4 // a loop would index the lines, and so put them in memory
    for (int cell = 0; cell < k_native_cells; ++cell)
        lines[cell] =
            Interpolant::sample_line(field + 4 * static_cast<std::ptrdiff_t>(points.offset[n + cell]), strides, w, n + cell);
    return Interpolant::sample_x(lines, w, n);
}

// Prefetch of the runs of cells needed soon, one cache line at a time while others are sampled: a core tracks only a few misses,
// and a prefetch of a whole row stalls it. Hardware prefetching stops at the end of each row, and rows are short.
struct Ahead {
    const float *first, *second;
};
constexpr int k_cells_of_a_line = 4;

// `count` cells of a run.
template <class Interpolant>
inline void sample_run(const float* field, const Points& points, const PaddedStrides& strides, int count, const Ahead& ahead,
                       float* result) {
    const typename Interpolant::Weights weights(points, count);
    int n = 0;
    for (; n + k_native_cells <= count; n += k_native_cells) {
        if (n % k_cells_of_a_line == 0) {
            __builtin_prefetch(ahead.first + 4 * n);
            __builtin_prefetch(ahead.second + 4 * n);
        }
        store_native(result + 4 * n, sample<Interpolant>(field, points, strides, weights, n));
    }
    if (n < count) {
        float rest[k_native_lanes];
        store_native(rest, sample<Interpolant>(field, points, strides, weights, n));
        for (int lane = 0; lane < 4 * (count - n); ++lane)
            result[4 * n + lane] = rest[lane];
    }
}

// A row's cells by component, in whole groups: zeros beyond the last cell.
inline void split_components(const float* cells, int count, Displacements& components) {
    for (int group = 0; group < count; group += k_lanes) {
        alignas(64) float rest[4 * k_lanes];
        const float* from = cells + 4 * group;
        if (group + k_lanes > count) {
            for (int n = 0; n < 4 * k_lanes; ++n)
                rest[n] = n < 4 * (count - group) ? from[n] : 0.0f;
            from = rest;
        }
        for (int lane = 0; lane < k_lanes; ++lane)
            for (int axis = 0; axis < 3; ++axis)
                components.axis[axis][group + lane] = from[4 * lane + axis];
    }
}

// The cell that is read or written a few rows after this one, inside the field.
inline std::size_t soon(const AdvectTask& task, std::size_t cell) {
    constexpr std::size_t k_cells_ahead = 128;
    const std::size_t later = cell + k_cells_ahead;
    return later < static_cast<std::size_t>(task.cells[0]) * task.cells[1] * task.cells[2] ? later : cell;
}

// Departure points of a run.
inline void trace_departures(const AdvectTask& task, const PaddedStrides& strides, const CellRun& run,
                             Displacements& displacements, Points& points) {
    Displacements velocity, traced;
    split_components(task.velocity + 4 * run.first, run.count, velocity);
    const int floats = (run.count + k_lanes - 1) / k_lanes * k_lanes;
    if (task.row_scales != nullptr)
        for (int n = 0; n < floats; ++n)
            velocity.axis[1][n] *= task.row_scales[run.j];
    for (int axis = 0; axis < 3; ++axis)
        for (int n = 0; n < floats; ++n)
            displacements.axis[axis][n] = -task.cells_per_speed * velocity.axis[axis][n];
    locate(task.legal, strides, run, displacements, points);

    alignas(64) float samples[4 * k_row_chunk];
    // At Courant numbers up to 1 the next plane's cells reach two planes beyond this one.
    const Ahead ahead = {task.padded_trace + 4 * padded_index(strides, run.i, run.j, run.k + 2),
                         task.velocity + 4 * soon(task, run.first)};
    sample_run<Linear>(task.padded_trace, points, strides, run.count, ahead, samples);
    split_components(samples, run.count, traced);
    for (int axis = 0; axis < 3; ++axis)
        for (int n = 0; n < floats; ++n)
            displacements.axis[axis][n] = -0.5f * task.cells_per_speed * (velocity.axis[axis][n] + traced.axis[axis][n]);
    locate(task.legal, strides, run, displacements, points);
}

// Calls body(strides, points, run, displacements) for each run of cells of a plane.
template <class Body>
inline void for_each_run(const AdvectTask& task, int plane, const Body& body) {
    const PaddedStrides strides = padded_strides(task.cells);
    Points points;
    Displacements displacements;
    for (int j = 0; j < task.cells[1]; ++j)
        for (int i = 0; i < task.cells[0]; i += k_row_chunk) {
            const int left = task.cells[0] - i;
            const CellRun run = {i, j, plane, left < k_row_chunk ? left : k_row_chunk,
                                 (static_cast<std::size_t>(plane) * task.cells[1] + j) * task.cells[0] + i};
            trace_departures(task, strides, run, displacements, points);
            body(strides, points, run, displacements);
        }
}

// As factors of the mean wind.
inline void bends_at(const AdvectTask& task, const CellRun& run, const Displacements& displacements, float* bends) {
    const float* const rows = task.prescribed.bends + k_halo_low;
    const Legal& legal = task.legal;
    const auto cell = static_cast<float>(run.j);
    for (int group = 0; group < run.count; group += k_lanes)
        for (int lane = 0; lane < k_lanes; ++lane) {
            const int n = group + lane;
            const AxisPlace place = place_of<1>(legal, cell, displacements.axis[1][n]);
            const auto row = static_cast<std::int32_t>(place.base);
            const float t = place.fraction;
            bends[n] = text::windrow_profile_bend(t, rows[row], rows[row + 1]);
        }
}

// Whether any cell's square may exceed a bound.
inline bool any_beyond(const float* cells, int count, float squared) {
    int n = 0;
    Native most = {};
    for (; n + k_native_cells <= count; n += k_native_cells) {
        const Native u = load_native(cells + 4 * n), square = u * u;
        most = square > most ? square : most;
    }
    float largest = 0.0f;
    for (int lane = 0; lane < k_native_lanes; ++lane)
        largest = most[lane] > largest ? most[lane] : largest;
    for (int at = 4 * n; at < 4 * count; ++at)
        largest = cells[at] * cells[at] > largest ? cells[at] * cells[at] : largest;
    return 3.0f * largest > squared;
}

// Advection of the prescribed background wind A by the perturbation v, v . grad A. With xd the departure point and
// x_A = xd + dt v the departure point under A alone,
//
//   result += A(xd) - (c A(x_A) + (1 - c) A'(x)),   c = g^2 / (g^2 + |v|^2)
//
// A(x_A) is the wind at x where v = 0. A', which is A at the step's end, has the same value, since A is a frozen pattern that
// passes. The first term does not change the pattern in air with a velocity of its own. The second makes it decay there, as
// gusts do behind a shelter. g is the strength of the gusts. v is taken half way, to second order: the advected field without
// the pressure. A is interpolated linearly, its profile like the advected field, so that fading gusts give the solution of the
// whole wind.
template <class Interpolant>
inline void carry_prescribed(const AdvectTask& task, const PaddedStrides& strides, const CellRun& run,
                             Displacements& displacements, Points& points) {
    const PrescribedWind& prescribed = task.prescribed;
    const int count = run.count, floats = (count + k_lanes - 1) / k_lanes * k_lanes;
    float* const result = task.result + 4 * run.first;
    if (prescribed.source_flow == nullptr && !any_beyond(result, count, prescribed.still_squared))
        return;
    Displacements v;
    split_components(result, count, v);
    if (prescribed.source_flow != nullptr) {
        Displacements flow;
        split_components(prescribed.source_flow + 4 * run.first, count, flow);
        for (int axis = 0; axis < 3; ++axis)
            for (int n = 0; n < floats; ++n)
                v.axis[axis][n] += flow.axis[axis][n];
    }
    alignas(64) float squares[k_row_chunk];
    float largest = 0.0f;
    for (int n = 0; n < floats; ++n) {
        squares[n] = v.axis[0][n] * v.axis[0][n] + (v.axis[1][n] * v.axis[1][n] + v.axis[2][n] * v.axis[2][n]);
        largest = squares[n] > largest ? squares[n] : largest;
    }
    if (!(largest > prescribed.still_squared))
        return;
    alignas(64) float at_departure[4 * k_row_chunk], at_own[4 * k_row_chunk];
    alignas(64) float departure_bends[k_row_chunk] = {}, own_bends[k_row_chunk] = {};
    const bool bent = prescribed.bends != nullptr && Interpolant::k_cubic;
    const float* const next = prescribed.next + 4 * padded_index(strides, run.i, run.j, run.k);
    const Ahead ahead = {prescribed.now + 4 * padded_index(strides, run.i, run.j, run.k + 2), next};
    locate(prescribed.legal, strides, run, displacements, points);
    sample_run<Linear>(prescribed.now, points, strides, count, ahead, at_departure);
    if (bent)
        bends_at(task, run, displacements, departure_bends);
    for (int axis = 0; axis < 3; ++axis) {
        const bool along_rows = axis == 1 && task.row_scales != nullptr;
        const float per_speed = along_rows ? task.cells_per_speed * task.row_scales[run.j] : task.cells_per_speed;
        for (int n = 0; n < floats; ++n)
            displacements.axis[axis][n] += per_speed * v.axis[axis][n];
    }
    locate(prescribed.legal, strides, run, displacements, points);
    sample_run<Linear>(prescribed.now, points, strides, count, ahead, at_own);
    if (bent)
        bends_at(task, run, displacements, own_bends);
    const Cell mean = load_cell(prescribed.mean);
    for (int n = 0; n < count; ++n) {
        if (!(squares[n] > prescribed.still_squared))
            continue;
        const float weight = prescribed.gusts_squared / (prescribed.gusts_squared + squares[n]);
        const Cell end = load_cell(next + 4 * n);
        const Cell departed = load_cell(at_departure + 4 * n) + splat(departure_bends[n]) * mean;
        const Cell own = load_cell(at_own + 4 * n) + splat(own_bends[n]) * mean;
        store_cell(result + 4 * n, load_cell(result + 4 * n) + (departed - (end + splat(weight) * (own - end))));
    }
}

template <class Interpolant>
void advect_plane(const AdvectTask& task, int plane) {
    for_each_run(task, plane,
                 [&](const PaddedStrides& strides, Points& points, const CellRun& run, Displacements& displacements) {
                     // The next plane's cells reach three planes beyond this one, with the nodes of a cubic.
                     const Ahead ahead = {task.padded_carried + 4 * padded_index(strides, run.i, run.j, run.k + 3),
                                          task.result + 4 * soon(task, run.first)};
                     sample_run<Interpolant>(task.padded_carried, points, strides, run.count, ahead, task.result + 4 * run.first);
                     if (task.prescribed.now != nullptr)
                         carry_prescribed<Interpolant>(task, strides, run, displacements, points);
                 });
}
