// Turbulent stress in the columns of a plane (fluid/solids/surface_layer.h): tridiagonal systems along y, a register of columns at a
// time. The cells of a register are in the order of `deal`.

inline Native square_root(Native a) {
#if defined(__AVX512F__)
    return reinterpret_cast<Native>(_mm512_maskz_sqrt_ps(0xffff, reinterpret_cast<__m512>(a)));
#elif defined(__AVX__)
    return reinterpret_cast<Native>(_mm256_sqrt_ps(reinterpret_cast<__m256>(a)));
#elif defined(__SSE2__)
    return reinterpret_cast<Native>(_mm_sqrt_ps(reinterpret_cast<__m128>(a)));
#else
    for (int n = 0; n < k_native_lanes; ++n)
        a[n] = __builtin_sqrtf(a[n]);
    return a;
#endif
}
// a where the mask is set, else 0.
inline Native only(NativeBits mask, Native a) {
    return reinterpret_cast<Native>(mask & reinterpret_cast<NativeBits>(a));
}

// Horizontal components.
struct Level {
    Native x, z;
};
inline Level operator-(Level a, Level b) {
    return {a.x - b.x, a.z - b.z};
}
inline Level only(NativeBits mask, Level a) {
    return {only(mask, a.x), only(mask, a.z)};
}
inline Native length(Level a) {
    return square_root(a.x * a.x + a.z * a.z);
}

// One row of cells: u, the part of it that is solved for, the ambient wind A, and what the lee of plants takes of the mixing length.
template <bool Lee>
struct StressRow {
    Level u, v, wind;
};
template <>
struct StressRow<true> {
    Level u, v, wind;
    Native lee = {};
};

// As windrow_lee_mixing.
inline Native lee_mixing(Native low, Native high) {
    const Native deepest = text::WINDROW_DEEPEST_LEE - Native{}, most = low > high ? low : high,
                 least = most > Native{} ? most : Native{};
    const Native left = 1.0f - (least < deepest ? least : deepest);
    return left * left;
}

// What passes a face, in cells of speed: `bond` times the new v above it, less that below between cells, and what is known. With A
// prescribed: k (2 v' - v + A) - k_wind A, and (k_wind - 1/2 - k) (v' - v) where that is above 0.
struct StressFace {
    NativeBits inner; // between cells
    Native bond;
    Level known;
};

template <bool Lee>
inline StressFace find_stress(const StressTask& task, Native passes, float wind_mixing, float wind_drag,
                              const StressRow<Lee>& low, const StressRow<Lee>& high) {
    const NativeBits inner = passes > Native{}, surface = passes < Native{};
    const Native factor = task.cells_per_speed - Native{};
    const Level u = high.u - only(inner, low.u), v = high.v - only(inner, low.v), wind = high.wind - only(inner, low.wind);
    Native mixed = passes;
    if constexpr (Lee)
        mixed = passes * lee_mixing(low.lee, high.lee);
    const Native k = factor * (only(inner, mixed) - only(surface, passes)) * length(u);
    const Native mixing = task.wind_mixing != nullptr ? wind_mixing - Native{} : passes;
    const Native of_wind = only(inner, mixing) + only(surface, wind_drag - Native{});
    const Native k_wind = factor * of_wind * length(wind), much = k_wind - 0.5f, most = k > much ? k : much;
    const Native rest = (task.prescribed ? k : Native{}) - k_wind;
    return StressFace{inner, k + most, {rest * wind.x - most * v.x, rest * wind.z - most * v.z}};
}

// Some cells of a row, fewer than a register has at its end.
class RowCells {
  public:
    explicit RowCells(int count) : count_(count) {}

    [[nodiscard, gnu::always_inline]] CellRegisters read(const float* cells) const {
        CellRegisters registers;
        if (count_ < k_native_lanes) {
            float whole[4 * k_native_lanes] = {};
            __builtin_memcpy(whole, cells, 4 * sizeof(float) * static_cast<std::size_t>(count_));
            for (int n = 0; n < 4; ++n)
                registers.part[n] = load_native(whole + n * k_native_lanes);
            return registers;
        }
        for (int n = 0; n < 4; ++n)
            registers.part[n] = load_native(cells + n * k_native_lanes);
        return registers;
    }
    [[nodiscard, gnu::always_inline]] Native read_floats(const float* floats) const {
        if (count_ == k_native_lanes)
            return deal(load_native(floats));
        float whole[k_native_lanes] = {};
        __builtin_memcpy(whole, floats, sizeof(float) * static_cast<std::size_t>(count_));
        return deal(load_native(whole));
    }
    [[gnu::always_inline]] void write(const CellRegisters& registers, float* cells) const {
        if (count_ == k_native_lanes) {
            for (int n = 0; n < 4; ++n)
                store_native(cells + n * k_native_lanes, registers.part[n]);
            return;
        }
        float whole[4 * k_native_lanes];
        for (int n = 0; n < 4; ++n)
            store_native(whole + n * k_native_lanes, registers.part[n]);
        __builtin_memcpy(cells, whole, 4 * sizeof(float) * static_cast<std::size_t>(count_));
    }

  private:
    int count_;
};

template <bool Lee>
inline void solve_columns(const StressTask& task, int plane, int first) {
    const int nx = task.cells[0], ny = task.cells[1];
    const RowCells cells(nx - first < k_native_lanes ? nx - first : k_native_lanes);
    const std::size_t corner = 4 * (static_cast<std::size_t>(plane) * ny * nx + first), row = 4 * static_cast<std::size_t>(nx);
    const float* const faces = task.faces + (static_cast<std::size_t>(plane) * (ny + 1) * nx + first);
    const auto read_level = [&](const float* from) {
        const Components u = dealt_components_of(cells.read(from));
        return Level{u.x, u.z};
    };
    const auto read_wind = [&](int j) {
        if (task.wind == nullptr)
            return Level{task.ambient[0] - Native{}, task.ambient[2] - Native{}};
        const std::size_t padded_row =
            static_cast<std::size_t>(plane + k_halo_low) * (ny + k_halo) + static_cast<std::size_t>(j + k_halo_low);
        return read_level(task.wind + 4 * (padded_row * (nx + k_halo) + first + k_halo_low));
    };
    const auto read_row = [&](int j) {
        const float* const u = task.velocity + corner + row * static_cast<std::size_t>(j);
        const float* const v = task.carried + corner + row * static_cast<std::size_t>(j);
        const DealtCells here = dealt_cells(cells.read(u));
        StressRow<Lee> level{{here.x, here.z}, {}, read_wind(j)};
        if constexpr (Lee)
            level.lee = here.w;
        level.v = u == v ? level.u : read_level(v);
        return level;
    };
    const auto beyond = [&](int j) { // the air is ambient
        const Level wind = read_wind(j);
        return StressRow<Lee>{wind, task.prescribed ? Level{} : wind, wind};
    };
    const auto find = [&](int j, const StressRow<Lee>& low, const StressRow<Lee>& high) {
        return find_stress<Lee>(task, cells.read_floats(faces + static_cast<std::size_t>(j) * nx),
                                task.wind_mixing != nullptr ? task.wind_mixing[j] : 0.0f, j < ny ? task.wind_drag[j] : 0.0f, low,
                                high);
    };

    // Row by row v[j] = swept + ratio v[j+1]; the result's fourth component keeps the ratio.
    const StressRow<Lee> below = beyond(-1), above = beyond(ny);
    StressRow<Lee> here = read_row(0);
    StressFace low = find(0, below, here);
    Level swept = below.v;
    Native ratio = {};
    for (int j = 0; j < ny; ++j) {
        const StressRow<Lee> next = j + 1 < ny ? read_row(j + 1) : above;
        const StressFace high = find(j + 1, here, next);
        const Native to_low = only(low.inner, low.bond), to_high = only(high.inner, high.bond);
        const Level known = only(high.inner, high.known) - low.known;
        // A row of another thickness takes its time: the equation times thickness over cell size.
        const float thick = task.row_scales != nullptr ? 1.0f / task.row_scales[j] : 1.0f;
        const Native whole = thick - Native{};
        const Native pivot = 1.0f / (whole + low.bond + to_high - to_low * ratio);
        ratio = to_high * pivot;
        swept.x = (whole * here.v.x + known.x + to_low * swept.x) * pivot;
        swept.z = (whole * here.v.z + known.z + to_low * swept.z) * pivot;
        const std::size_t at = corner + row * static_cast<std::size_t>(j);
        const DealtCells carried = dealt_cells(cells.read(task.carried + at));
        cells.write(cells_of_dealt({swept.x, carried.y, swept.z, ratio}), task.result + at);
        here = next;
        low = high;
    }
    Level next = above.v;
    for (int j = ny - 1; j >= 0; --j) {
        float* const result = task.result + corner + row * static_cast<std::size_t>(j);
        const DealtCells u = dealt_cells(cells.read(result));
        next = {u.x + u.w * next.x, u.z + u.w * next.z};
        cells.write(cells_of_dealt({next.x, u.y, next.z, Native{}}), result);
    }
}

[[gnu::flatten]] void stress_plane(const StressTask& task, int plane) {
    for (int first = 0; first < task.cells[0]; first += k_native_lanes)
        task.lee ? solve_columns<true>(task, plane, first) : solve_columns<false>(task, plane, first);
}
