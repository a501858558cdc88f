// The ambient wind at points, and what a plant feels there: windrow_ambient and windrow_felt of shaders/numerics/ambient.glsl for
// groups of points.
//
// Expected costs of a point, in cycles of a core with 512-bit vectors. Uniform: a store. A profile: a logarithm of 20 operations and
// a quotient, in lanes: 4. Gusts: three places in double (two quotients, 20 operations each, 16 lanes in two vectors): 15; eight
// loads and 12 operations of a trilinear read: 8. Detail: the same again, with a root and three quotients for the limit: 28.
// Measured (windrow_query_bench), above a point outside without either: a profile .7 ns, both 7.5 ns or 26 cycles at 3.5 GHz; what a
// plant feels 3 ns, with detail 14 ns or 48 cycles, since compilers make no vectors of all its loops.

// Corners in the tile, and the signs of the vertical component in both rows: the tile is mirrored at both ends of y.
template <int Lanes>
struct TileCorners {
    Corners<Lanes> corners;
    Numbers<Lanes> between[3];
    Numbers<Lanes> sign[2];
};

template <int Lanes>
inline void tile_places(const TileAxis& axis, const Doubles<Lanes>& coordinates, Whole<Lanes>& texels, Numbers<Lanes>& fraction) {
    Doubles<Lanes> along;
    for_lanes<Lanes>([&](int n) { along.at[n] = coordinates.at[n] - axis.origin; });
    wrap(along, axis.period);
    for_lanes<Lanes>([&](int n) {
        const TilePlace place = place_of_wrapped(axis, along.at[n]);
        texels.at[n] = static_cast<std::int32_t>(place.texel);
        fraction.at[n] = static_cast<float>(place.fraction);
    });
}

template <int Lanes>
inline void tile_corners(const TileAxis (&axes)[3], const Positions<Lanes>& positions, TileCorners<Lanes>& tile) {
    constexpr std::int32_t k_row = k_cell_bytes * k_tile_side, k_slice = k_row * k_tile_height;
    Whole<Lanes> texels[3];
    for (int axis = 0; axis < 3; ++axis)
        tile_places(axes[axis], positions.axis[axis], texels[axis], tile.between[axis]);
    for_lanes<Lanes>([&](int n) {
        const std::int32_t x = texels[0].at[n] & (k_tile_side - 1), next_x = (texels[0].at[n] + 1) & (k_tile_side - 1);
        const std::int32_t z = texels[2].at[n] & (k_tile_side - 1), next_z = (texels[2].at[n] + 1) & (k_tile_side - 1);
        const std::int32_t y = texels[1].at[n] & (2 * k_tile_height - 1),
                           next_y = (texels[1].at[n] + 1) & (2 * k_tile_height - 1);
        const std::int32_t row = y < k_tile_height ? y : 2 * k_tile_height - 1 - y;
        const std::int32_t next_row = next_y < k_tile_height ? next_y : 2 * k_tile_height - 1 - next_y;
        tile.sign[0].at[n] = y < k_tile_height ? 1.0f : -1.0f;
        tile.sign[1].at[n] = next_y < k_tile_height ? 1.0f : -1.0f;
        tile.corners.first.at[n] = z * k_slice + row * k_row + x * k_cell_bytes;
        tile.corners.step[0].at[n] = (next_x - x) * k_cell_bytes;
        tile.corners.step[1].at[n] = (next_row - row) * k_row;
        tile.corners.step[2].at[n] = (next_z - z) * k_slice;
    });
}

template <int Lanes>
inline Cell tile_at(const float* texels, const TileCorners<Lanes>& tile, int n) {
    const auto turn = [&](const Pair& line, int row) {
        const Cell signs = {1.0f, tile.sign[row].at[n], 1.0f, 1.0f};
        return line * pair_of(signs, signs);
    };
    return trilinear(texels, tile.corners, tile.between, n, turn);
}

// The mean wind where a point is not finite.
template <int Lanes>
inline void ambient_points(const AmbientTask& task, const Positions<Lanes>& positions, Vectors<Lanes>& wind) {
    const Cell mean = load_cell(task.mean);
    Numbers<Lanes> share;
    for_lanes<Lanes>([&](int n) { share.at[n] = 1.0f; });
    if (task.roughness_length > 0.0f)
        for_lanes<Lanes>([&](int n) {
            const double over = positions.axis[1].at[n] - task.ground;
            const double raised = over < task.lowest ? task.lowest : over;
            const auto height = static_cast<float>(task.highest < raised ? task.highest : raised);
            const float fraction = text::windrow_profile(height, task.roughness_length, task.reference_height);
            share.at[n] = positions.lost.at[n] == 0.0f ? fraction : 1.0f;
        });
    if (!(task.gust_strength > 0.0f)) {
        for_lanes<Lanes>([&](int n) { store_cell(wind.at[n], splat(share.at[n]) * mean); });
        return;
    }
    TileCorners<Lanes> tile;
    tile_corners(task.gusts, positions, tile);
    Numbers<Lanes> strength;
    for_lanes<Lanes>([&](int n) { strength.at[n] = task.gust_strength * text::min(share.at[n], 1.0f); });
    const Cell axes = load_cell(task.gust_axes);
    for_lanes<Lanes>([&](int n) {
        const Cell gust = splat(strength.at[n]) * axes * tile_at(task.tile, tile, n);
        const Cell steady = splat(share.at[n]) * mean;
        store_cell(wind.at[n], positions.lost.at[n] == 0.0f ? steady + gust : steady);
    });
}

template <int Lanes>
inline void read_known_positions(const double* from, Positions<Lanes>& positions) {
    read_positions(from, positions);
    for_lanes<Lanes>([&](int n) { positions.lost.at[n] = 0.0f; });
    for (int axis = 0; axis < 3; ++axis)
        drop_lost(positions.axis[axis], positions.lost);
}

template <int Lanes>
inline void ambient_group(const AmbientTask& task, const double* from, int count, int stride, float* out) {
    Positions<Lanes> positions;
    Vectors<Lanes> wind;
    read_known_positions(from, positions);
    ambient_points(task, positions, wind);
    write_velocities([&](int n) { return load_cell(wind.at[n]); }, count, stride, out);
}

void ambient_list(const AmbientTask& task, const double* positions, std::size_t count, int stride, float* out) {
    const auto group = [&](auto lanes, std::size_t first, const double* from, int size) {
        ambient_group<lanes.count>(task, from, size, stride, out + stride * first);
    };
    for_groups(positions, count, group);
}

template <int Stride, int Lanes>
inline void felt_lanes(const FeltTask& task, const Vectors<Lanes>& ripple, float* velocities) {
    Numbers<Lanes> x, y, z;
    for_lanes<Lanes>([&](int n) {
        x.at[n] = velocities[Stride * n];
        y.at[n] = velocities[Stride * n + 1];
        z.at[n] = velocities[Stride * n + 2];
    });
    if (task.detail_amount > 0.0f)
        for_lanes<Lanes>([&](int n) {
            const text::vec3 wind(x.at[n], y.at[n], z.at[n]);
            const text::vec3 detail =
                task.detail_amount * text::windrow_speed(wind) * text::vec3(ripple.at[n][0], ripple.at[n][1], ripple.at[n][2]);
            x.at[n] += detail.x;
            y.at[n] += detail.y;
            z.at[n] += detail.z;
        });
    for_lanes<Lanes>([&](int n) {
        const text::vec3 felt = text::windrow_limited(text::vec3(x.at[n], y.at[n], z.at[n]), task.strength, task.limit);
        velocities[Stride * n] = felt.x;
        velocities[Stride * n + 1] = felt.y;
        velocities[Stride * n + 2] = felt.z;
    });
}

// Detail, strength and limit of the velocities in `out`, in place.
template <int Lanes>
inline void felt_group(const FeltTask& task, const double* from, int count, int stride, float* out) {
    Positions<Lanes> positions;
    Vectors<Lanes> ripple;
    if (task.detail_amount > 0.0f) {
        read_known_positions(from, positions);
        TileCorners<Lanes> tile;
        tile_corners(task.detail, positions, tile);
        for_lanes<Lanes>([&](int n) {
            store_cell(ripple.at[n], positions.lost.at[n] == 0.0f ? tile_at(task.tile, tile, n) / splat(task.longest) : Cell{});
        });
    }
    alignas(64) float rest[4 * Lanes] = {};
    float* velocities = out;
    if (count < Lanes) { // a group is worked on whole
        for (int n = 0; n < stride * count; ++n)
            rest[n] = out[n];
        velocities = rest;
    }
    if (stride == 3)
        felt_lanes<3>(task, ripple, velocities);
    else
        felt_lanes<4>(task, ripple, velocities);
    for (int n = 0; count < Lanes && n < stride * count; ++n)
        out[n] = rest[n];
}

void felt_list(const FeltTask& task, const double* positions, std::size_t count, int stride, float* out) {
    const auto group = [&](auto lanes, std::size_t first, const double* from, int size) {
        felt_group<lanes.count>(task, from, size, stride, out + stride * first);
    };
    for_groups(positions, count, group);
}
