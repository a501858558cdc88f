// The wind of a box at points (fluid/view.h): trilinear between cell centres, faded to the ambient wind where the box ends.
//
//   place     (x / h) - origin, in double: cells from the low corner; with rows of their own, by the heights of the rows
//   share     of the box's wind, by axis: windrow_edge_share of shaders/numerics/window.glsl
//   wind      A + share (B - A), B the box's wind, A the ambient wind
//
// Expected cost of a point inside, in cycles of a core with 512-bit vectors (16 lanes in float, two vectors of doubles):
//   - a point's 24 bytes by axis, one quotient an axis in double: 5
//   - cell, fraction and share, some 40 operations an axis in lanes: 7
//   - eight loads of 16 bytes and four inserts, 12 operations of three blends, a store: 8
// or 20, 6 ns at 3.5 GHz, against 72 to 120 ns for one point after another in GLM. With 128-bit vectors the lanes cost four times as
// much, 50 cycles in all. Rows add a binary search, 7 steps of a gather: 10. Measured (windrow_query_bench): 4.8 ns, with a product
// in place of the quotient; 6.5 ns with AVX2, 12.4 with SSE2; rows 6 ns more. The loads are from the first cache where the list is
// coherent: a point's neighbours have read the cells. Groups that are wholly inside skip the ambient wind, groups wholly outside the
// cells.
// Expected error: that of the float place, half a unit in the last place of the number of cells, times the difference between
// neighbours, and a rounding of the largest cell for each blend.

template <int Lanes>
struct BoxPlaces {
    Whole<Lanes> low[3], high[3];
    Numbers<Lanes> between[3];
    Numbers<Lanes> share;
};

// Cells from the low corner, and metres over it, by the heights of rows.
template <int Lanes>
inline void places_in_rows(const PointTask& task, const Doubles<Lanes>& heights, Doubles<Lanes>& places) {
    const double* const rows = task.row_heights; // of row -1 first
    for_lanes<Lanes>([&](int n) { places.at[n] = heights.at[n] - task.bottom; });
    Whole<Lanes> below;
    for_lanes<Lanes>([&](int n) { below.at[n] = 0; });
    for (std::int32_t step = 128; step > 0; step /= 2)
        for_lanes<Lanes>([&](int n) {
            const std::int32_t next = below.at[n] + step, row = next < task.rows ? next : task.rows;
            below.at[n] = next == row && rows[row] <= places.at[n] ? row : below.at[n];
        });
    for_lanes<Lanes>([&](int n) {
        const double from = rows[below.at[n]], to = rows[below.at[n] + 1];
        places.at[n] = static_cast<double>(below.at[n]) - 0.5 + (places.at[n] - from) / (to - from);
    });
}

constexpr float k_never_fades = 1e30f; // as fluid/core/view_place.h has it

// The share of an axis, with `from_low` and `from_high` in cells from the box's ends.
template <int Lanes>
inline void fade_at_ends(const PointAxis& axis, const Numbers<Lanes>& from_low, const Numbers<Lanes>& from_high,
                         Numbers<Lanes>& share) {
    if (axis.low_kind == 0.0f && axis.high_kind == 0.0f) {
        for_lanes<Lanes>(
            [&](int n) { share.at[n] *= text::windrow_edge_share(1.0f + from_low.at[n], 1.0f + from_high.at[n], 0.0f); });
    } else if (axis.low_kind == 0.0f || axis.high_kind == 0.0f) {
        const Numbers<Lanes>& from_open = axis.low_kind == 0.0f ? from_low : from_high;
        for_lanes<Lanes>([&](int n) { share.at[n] *= text::windrow_edge_share(1.0f + from_open.at[n], k_never_fades, 0.0f); });
    }
}

// The share of the blend zone of an axis, around what the box follows. The zone of the whole box may reach beyond a box that was read
// out of it: this share and that of the ends both count.
template <int Lanes>
inline void fade_from_point(const PointAxis& axis, const Doubles<Lanes>& in_world, Numbers<Lanes>& share) {
    for_lanes<Lanes>([&](int n) {
        const auto from_point = static_cast<float>(in_world.at[n] - axis.point);
        share.at[n] *= text::windrow_edge_share((axis.reach + from_point) * axis.per_width,
                                                (axis.reach - from_point) * axis.per_width, 1.0f);
    });
}

template <bool Periodic, int Lanes>
inline void cells_around(const PointAxis& axis, const Numbers<Lanes>& local, Whole<Lanes>& low, Whole<Lanes>& high,
                         Numbers<Lanes>& between) {
    constexpr float k_kind = Periodic ? 2.0f : 0.0f; // open ends and walls differ in the share alone
    const std::int32_t cells = axis.cells;
    Numbers<Lanes> sample, below; // by short loops: of a longer one the compiler makes no vectors
    for_lanes<Lanes>(
        [&](int n) { sample.at[n] = text::windrow_axis_sample(local.at[n], static_cast<float>(cells), k_kind) - 0.5f; });
    for_lanes<Lanes>([&](int n) { below.at[n] = text::floor(sample.at[n]); });
    for_lanes<Lanes>([&](int n) {
        between.at[n] = sample.at[n] - below.at[n];
        low.at[n] = static_cast<std::int32_t>(below.at[n]);
    });
    for_lanes<Lanes>([&](int n) { high.at[n] = text::windrow_axis_texel(low.at[n] + 1, cells, k_kind); });
    for_lanes<Lanes>([&](int n) { low.at[n] = text::windrow_axis_texel(low.at[n], cells, k_kind); });
}

// Positions that are not finite, or that no double of cells holds, have the share 0. Where a single point has it, its cells are unset.
template <int Lanes>
inline void place_points(const PointTask& task, const Positions<Lanes>& positions, BoxPlaces<Lanes>& places) {
    for_lanes<Lanes>([&](int n) { places.share.at[n] = 1.0f; });
    Doubles<Lanes> in_world, local, nothing;
    for_lanes<Lanes>([&](int n) { nothing.at[n] = 0.0; });
    for (int a = 0; a < 3; ++a) {
        const PointAxis& axis = task.axis[a];
        const bool rows = a == 1 && task.rows > 0;
        for_lanes<Lanes>([&](int n) { in_world.at[n] = positions.axis[a].at[n] * task.per_cell; });
        for_lanes<Lanes>([&](int n) { nothing.at[n] += in_world.at[n] - in_world.at[n]; }); // or NaN
        if (rows)
            places_in_rows(task, positions.axis[a], local);
        else
            for_lanes<Lanes>([&](int n) { local.at[n] = in_world.at[n] - axis.origin; });
        if (axis.low_kind == 2.0f)
            wrap(local, axis.period);
        // NaN becomes -1, so that its address is legal. Below -1 all places are alike.
        Numbers<Lanes> in_box, from_low, from_high;
        for_lanes<Lanes>([&](int n) {
            const auto place = static_cast<float>(local.at[n]);
            in_box.at[n] = place > -1.0f ? place : -1.0f;
        });
        if (rows) { // over a cell's size, also where the outermost row has another thickness
            for_lanes<Lanes>([&](int n) {
                const double over = positions.axis[a].at[n] - task.bottom;
                from_low.at[n] = static_cast<float>(over * task.per_cell);
                from_high.at[n] = static_cast<float>((task.top - over) * task.per_cell);
            });
            fade_at_ends(axis, from_low, from_high, places.share);
        } else {
            for_lanes<Lanes>([&](int n) { from_high.at[n] = static_cast<float>(axis.cells) - in_box.at[n]; });
            fade_at_ends(axis, in_box, from_high, places.share);
        }
        if (axis.reach > 0.0f)
            fade_from_point(axis, in_world, places.share);
        if (axis.low_kind == 2.0f)
            cells_around<true>(axis, in_box, places.low[a], places.high[a], places.between[a]);
        else
            cells_around<false>(axis, in_box, places.low[a], places.high[a], places.between[a]);
        if constexpr (Lanes == 1)
            if (places.share.at[0] == 0.0f)
                return;
    }
    Numbers<Lanes> lost;
    for_lanes<Lanes>([&](int n) { lost.at[n] = static_cast<float>(nothing.at[n]); });
    for_lanes<Lanes>([&](int n) { places.share.at[n] = lost.at[n] == 0.0f ? places.share.at[n] : 0.0f; });
}

template <int Lanes>
inline void corners_of(const PointTask& task, const BoxPlaces<Lanes>& places, Corners<Lanes>& corners) {
    const std::int32_t row = k_cell_bytes * task.axis[0].cells, plane = row * task.axis[1].cells;
    for_lanes<Lanes>([&](int n) {
        corners.first.at[n] = places.low[2].at[n] * plane + places.low[1].at[n] * row + places.low[0].at[n] * k_cell_bytes;
        corners.step[0].at[n] = (places.high[0].at[n] - places.low[0].at[n]) * k_cell_bytes;
        corners.step[1].at[n] = (places.high[1].at[n] - places.low[1].at[n]) * row;
        corners.step[2].at[n] = (places.high[2].at[n] - places.low[2].at[n]) * plane;
    });
}

constexpr auto k_not_turned = [](const Pair& line, int) { return line; };

// Of the box's wind where the share is above 0, else the ambient wind to the bit; so a cell that is not finite has no say there.
inline Cell mixed(Cell ambient, Cell inside, float share) {
    if (share <= 0.0f)
        return ambient;
    return share == 1.0f ? inside : blend(ambient, inside, share);
}

// Marks what is not finite for the ambient wind.
template <int Lanes>
inline void ambient_around(const PointTask& task, Positions<Lanes>& positions, Vectors<Lanes>& ambient) {
    Doubles<Lanes> in_world;
    for_lanes<Lanes>([&](int n) { positions.lost.at[n] = 0.0f; });
    for (int axis = 0; axis < 3; ++axis) {
        for_lanes<Lanes>([&](int n) { in_world.at[n] = positions.axis[axis].at[n] * task.per_cell; });
        drop_lost(in_world, positions.lost);
        drop_lost(positions.axis[axis], positions.lost);
    }
    ambient_points(task.ambient, positions, ambient);
}

// The wind among the cells as the law of the wall leaves it: by the height in its fourth lane, which becomes 0.
template <int Lanes>
inline void read_over_wall(const PointTask& task, const Positions<Lanes>& positions, const BoxPlaces<Lanes>& places,
                           const Corners<Lanes>& corners, Vectors<Lanes>& air) {
    Numbers<Lanes> height;
    for (int n = 0; n < Lanes; ++n) {
        const Cell cell = trilinear(task.field, corners, places.between, n, k_not_turned);
        store_cell(air.at[n], cell);
        height.at[n] = cell[3];
    }
    for_lanes<Lanes>([&](int n) {
        const auto over_floor = static_cast<float>(positions.axis[1].at[n] - task.bottom);
        height.at[n] = text::windrow_wall_height(height.at[n], over_floor, task.wall_lowest, task.wall_fall);
    });
    for_lanes<Lanes>(
        [&](int n) { height.at[n] = text::windrow_wall_share(height.at[n], task.wall_per_length, task.wall_per_log); });
    for (int n = 0; n < Lanes; ++n) {
        const Cell share = {height.at[n], height.at[n], height.at[n], 0.0f};
        store_cell(air.at[n], share * load_cell(air.at[n]));
    }
}

// `Law`: of the wall.
template <bool Law, int Lanes>
inline void point_group(const PointTask& task, const double* from, int count, int stride, float* out) {
    Positions<Lanes> positions;
    BoxPlaces<Lanes> places;
    read_positions(from, positions);
    place_points(task, positions, places);
    Corners<Lanes> corners;
    if (Lanes > 1 || places.share.at[0] > 0.0f)
        corners_of(task, places, corners);
    Vectors<Lanes> air;
    if (Law && (Lanes > 1 || places.share.at[0] > 0.0f))
        read_over_wall(task, positions, places, corners, air);
    const auto inside = [&](int n) {
        if constexpr (Law)
            return load_cell(air.at[n]);
        else
            return trilinear(task.field, corners, places.between, n, k_not_turned);
    };
    if (!any_below(places.share, 1.0f)) {
        write_velocities(inside, count, stride, out);
        return;
    }
    Vectors<Lanes> ambient;
    ambient_around(task, positions, ambient);
    if (!any_above(places.share, 0.0f)) {
        write_velocities([&](int n) { return load_cell(ambient.at[n]); }, count, stride, out);
        return;
    }
    write_velocities([&](int n) { return mixed(load_cell(ambient.at[n]), inside(n), places.share.at[n]); }, count, stride, out);
}

template <bool Law>
void point_groups(const PointTask& task, const double* positions, std::size_t count, int stride, float* out) {
    const auto group = [&](auto lanes, std::size_t first, const double* from, int size) {
        point_group<Law, lanes.count>(task, from, size, stride, out + stride * first);
    };
    for_groups(positions, count, group);
}

void point_list(const PointTask& task, const double* positions, std::size_t count, int stride, float* out) {
    if (task.wall_per_log > 0.0f)
        point_groups<true>(task, positions, count, stride, out);
    else
        point_groups<false>(task, positions, count, stride, out);
}

void place_point(const PointTask& task, const double* position, PointPlace& place) {
    Positions<1> positions;
    BoxPlaces<1> places;
    Vectors<1> ambient;
    read_positions(position, positions);
    place_points(task, positions, places);
    place.share = places.share.at[0];
    for (int axis = 0; axis < 3 && place.share > 0.0f; ++axis) {
        place.low[axis] = places.low[axis].at[0];
        place.high[axis] = places.high[axis].at[0];
        place.between[axis] = places.between[axis].at[0];
    }
    if (place.share != 1.0f) {
        ambient_around(task, positions, ambient);
        store_cell(place.ambient, load_cell(ambient.at[0]));
    }
}

void blend_corners(const float* corners, const PointPlace& place, float* out) {
    constexpr std::ptrdiff_t k_steps[3] = {k_cell_bytes, 2 * k_cell_bytes, 4 * k_cell_bytes};
    const float t[3] = {place.between[0], place.between[1], place.between[2]};
    store_cell(out, mixed(load_cell(place.ambient), trilinear(corners, k_steps, t, k_not_turned), place.share));
}
