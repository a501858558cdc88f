// Points in groups: what the queries of a box and of the ambient wind have in common.
//
// A group is `Lanes` points, k_lanes in a list and 1 for a single point: one text. Loops over the lanes of a group become
// vectors, except that the eight cells around a point are read point by point, four floats a cell: eight loads of 16 bytes take
// less than the 24 gathers of a lane a point. No value depends on a neighbour in the list, nor on the number of lanes.

// A number, or a vector, of each point.
template <int Lanes>
struct Numbers {
    alignas(Lanes > 1 ? 64 : 4) float at[Lanes];
};
template <int Lanes>
struct Whole {
    alignas(Lanes > 1 ? 64 : 4) std::int32_t at[Lanes];
};
template <int Lanes>
struct Doubles {
    alignas(Lanes > 1 ? 64 : 8) double at[Lanes];
};
template <int Lanes>
struct Vectors {
    alignas(16) float at[Lanes][4];
};

// Runs body(n) for each lane. Without the pragma short loops within others are unrolled before vectors are made of them.
template <int Lanes, class Body>
__attribute__((always_inline)) inline void for_lanes(const Body& body) {
#pragma GCC unroll 1
    for (int n = 0; n < Lanes; ++n)
        body(n);
}

// [m] The points as asked, by axis. What is not finite is 0 there, and `lost` is NaN instead of 0.
template <int Lanes>
struct Positions {
    Doubles<Lanes> axis[3];
    Numbers<Lanes> lost;
};

template <int Lanes>
inline void read_positions(const double* from, Positions<Lanes>& positions) {
    for_lanes<Lanes>([&](int n) {
        positions.axis[0].at[n] = from[3 * n];
        positions.axis[1].at[n] = from[3 * n + 1];
        positions.axis[2].at[n] = from[3 * n + 2];
    });
}

// Zero where x is not finite, which `lost` then marks.
template <int Lanes>
inline void drop_lost(Doubles<Lanes>& values, Numbers<Lanes>& lost) {
    for_lanes<Lanes>([&](int n) {
        const double value = values.at[n], nothing = value - value;
        values.at[n] = nothing == 0.0 ? value : 0.0;
        lost.at[n] += static_cast<float>(nothing);
    });
}

template <int Lanes>
inline bool any_above(const Numbers<Lanes>& values, float bound) {
    std::int32_t found = 0;
    for_lanes<Lanes>([&](int n) { found |= values.at[n] > bound ? 1 : 0; });
    return found != 0;
}
template <int Lanes>
inline bool any_below(const Numbers<Lanes>& values, float bound) {
    std::int32_t found = 0;
    for_lanes<Lanes>([&](int n) { found |= values.at[n] < bound ? 1 : 0; });
    return found != 0;
}

// values[n] mod the period, from 0 to the period. Exact for any coordinate (wrap.inl).
template <int Lanes>
inline void wrap(Doubles<Lanes>& values, const Period& period) {
    Numbers<Lanes> far; // a float, since a mask of doubles does not become one of ints in one step
    for_lanes<Lanes>([&](int n) { far.at[n] = static_cast<float>(is_near(values.at[n], period) ? 0.0 : 1.0); });
    if (any_above(far, 0.0f)) {
        for_lanes<Lanes>([&](int n) { values.at[n] = wrapped(values.at[n], period); });
        return;
    }
    for_lanes<Lanes>([&](int n) { values.at[n] = wrapped_near(values.at[n], period); });
}

// Two cells, or four floats each of two lines.
#if defined(__AVX__)
inline Pair pair_of(const float* low, const float* high) {
    return reinterpret_cast<Pair>(_mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1));
}
inline Pair pair_of(Cell low, Cell high) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
inline Cell low_of(Pair pair) {
    return __builtin_shufflevector(pair, pair, 0, 1, 2, 3);
}
inline Cell high_of(Pair pair) {
    return __builtin_shufflevector(pair, pair, 4, 5, 6, 7);
}
inline Pair blend(Pair a, Pair b, float t) {
    return a + (t - Pair{}) * (b - a);
}
#else
inline Pair pair_of(const float* low, const float* high) {
    return {load_cell(low), load_cell(high)};
}
inline Pair pair_of(Cell low, Cell high) {
    return {low, high};
}
inline Cell low_of(const Pair& pair) {
    return pair.low;
}
inline Cell high_of(const Pair& pair) {
    return pair.high;
}
inline Pair operator*(const Pair& a, const Pair& b) {
    return {a.low * b.low, a.high * b.high};
}
inline Pair blend(const Pair& a, const Pair& b, float t) {
    return {a.low + splat(t) * (b.low - a.low), a.high + splat(t) * (b.high - a.high)};
}
#endif
// a + t (b - a): equal ends give themselves, to the bit. Not fused, unlike `lerp`.
inline Cell blend(Cell a, Cell b, float t) {
    return a + splat(t) * (b - a);
}

// The eight cells around a point: the first, and the way to its neighbour along each axis. In bytes, of which the largest field
// has 2^30.
constexpr std::int32_t k_cell_bytes = 16;
template <int Lanes>
struct Corners {
    Whole<Lanes> first, step[3];
};
inline const float* bytes_on(const float* from, std::ptrdiff_t bytes) {
    return reinterpret_cast<const float*>(reinterpret_cast<const char*>(from) + bytes);
}

// Trilinear, along x, then y, then z, as windrow_tile_at of shaders/numerics/ambient.glsl. `turn(line, row)` changes the lower
// and the upper row before they are blended.
template <class Turn>
inline Cell trilinear(const float* first, const std::ptrdiff_t (&step)[3], const float (&between)[3], const Turn& turn) {
    const float *const a = first, *const b = bytes_on(a, step[1]), *const c = bytes_on(a, step[2]),
                       *const d = bytes_on(b, step[2]);
    const auto beside = [&](const float* cell) { return bytes_on(cell, step[0]); };
    const Pair near = blend(pair_of(a, c), pair_of(beside(a), beside(c)), between[0]);
    const Pair over = blend(pair_of(b, d), pair_of(beside(b), beside(d)), between[0]);
    const Pair both = blend(turn(near, 0), turn(over, 1), between[1]);
    return blend(low_of(both), high_of(both), between[2]);
}

template <int Lanes, class Turn>
inline Cell trilinear(const float* cells, const Corners<Lanes>& corners, const Numbers<Lanes> (&between)[3], int n,
                      const Turn& turn) {
    const std::ptrdiff_t step[3] = {corners.step[0].at[n], corners.step[1].at[n], corners.step[2].at[n]};
    const float t[3] = {between[0].at[n], between[1].at[n], between[2].at[n]};
    return trilinear(bytes_on(cells, corners.first.at[n]), step, t, turn);
}

template <int Count>
struct LaneCount {
    static constexpr int count = Count;
};
// Calls group(lanes, first, positions, size) for each group of a list: `positions` of as many as `lanes` has, `size` of them in the
// list, from its `first` on. What the list does not fill is filled with its last point; one or two that are left go alone, since a
// group costs about as much as two single points.
template <class Group>
__attribute__((noinline)) void for_whole_groups(const double* positions, std::size_t count, const Group& group) {
    std::size_t first = 0;
    for (; first + k_lanes <= count; first += k_lanes)
        group(LaneCount<k_lanes>(), first, positions + 3 * first, k_lanes);
    const std::size_t left = count - first;
    if (left == 0)
        return;
    double rest[3 * k_lanes];
    for (std::size_t n = 0; n < k_lanes; ++n)
        for (int axis = 0; axis < 3; ++axis)
            rest[3 * n + axis] = positions[3 * (first + (n < left ? n : left - 1)) + axis];
    group(LaneCount<k_lanes>(), first, rest, static_cast<int>(left));
}
template <class Group>
inline void for_groups(const double* positions, std::size_t count, const Group& group) {
    const std::size_t alone = count % k_lanes <= 2 ? count % k_lanes : 0;
    if (count > alone)
        for_whole_groups(positions, count - alone, group);
    for (std::size_t n = count - alone; n < count; ++n)
        group(LaneCount<1>(), n, positions + 3 * n, 1);
}

// velocity(n) of the first `count` lanes, as three or four floats each. Three are stored as four where a next point follows, which
// then takes its own place.
template <class Velocity>
inline void write_velocities(const Velocity& velocity, int count, int stride, float* out) {
    for (int n = 0; n + 1 < count; ++n)
        store_cell(out + stride * n, velocity(n));
    const Cell last = velocity(count - 1);
    float* const end = out + stride * (count - 1);
    if (stride == 4)
        store_cell(end, last);
    else
        for (int axis = 0; axis < 3; ++axis)
            end[axis] = last[axis];
}
