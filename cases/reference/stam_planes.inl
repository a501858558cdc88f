// The passes of StamStep that lie between the threads' barriers, a plane a task, without a branch on where a cell lies:
//
//   advect       u (halo) -> u*      positions of a row in short loops of 16 lanes, then 4 loads of two x-neighbours a cell
//   divergence   u* -> h/2 div       16 cells at once, from whole cells: a component a lane, no gather
//   gradient     u*, psi -> u        16 cells at once; also writes the floor's ghost row, the only halo that changes

constexpr int k_run = 64;         // cells of a row between two loops
constexpr int k_planes_ahead = 2; // prefetched

typedef float Cell __attribute__((vector_size(16)));
typedef float Pair __attribute__((vector_size(32)));  // two x-neighbours
typedef float Block __attribute__((vector_size(64))); // four cells, or one component of sixteen
typedef std::int32_t BlockMask __attribute__((vector_size(64)));

template <class V>
inline V load(const float* from) {
    V value;
    __builtin_memcpy(&value, from, sizeof value);
    return value;
}
template <class V>
inline void store(float* to, V value) {
    __builtin_memcpy(to, &value, sizeof value);
}

// Brings the cells of a row into cache. Rows are short and lie far apart, so that the machine's own prefetching stops at each
// end.
inline void prefetch_row(const float* cells, int count) {
    for (int n = 0; n < count; n += 4)
        __builtin_prefetch(cells + 4 * n);
}

// a + t (b - a): exact where a = b, so that a uniform wind stays uniform.
template <class V>
inline V lerp(V a, V b, float t) {
    return a + t * (b - a);
}

// For a run of cells along x: the cell below each departure point, and the distance from its centre in [0, 1] by axis.
struct Points {
    alignas(64) std::int32_t offset[k_run]; // [cells] from cell (0, 0, 0)
    alignas(64) float fraction[3][k_run];
};

// Displacements are clamped so that position cell + displacement stays in [low, high]; a comparison with NaN is false, which
// makes a broken position the low end.
inline void locate_axis(float first, float advance, float low, float high, std::int32_t stride, int count, int axis,
                        const float* velocity, float cells_per_speed, Points& points) {
    float* const fraction = points.fraction[axis];
    for (int n = 0; n < count; ++n) {
        const float cell = first + advance * static_cast<float>(n);
        const float displacement = -cells_per_speed * velocity[4 * n + axis];
        const float least = low - cell, most = high - cell;
        float legal = displacement > least ? displacement : least;
        legal = legal < most ? legal : most;
        const float whole = __builtin_floorf(legal);
        fraction[n] = legal - whole;
        points.offset[n] += static_cast<std::int32_t>(cell + whole) * stride;
    }
}

// Between rows and planes first: two neighbours along x lie in one load where registers hold them.
template <class V>
inline V bilinear(const float* at, std::ptrdiff_t row, std::ptrdiff_t plane, float y, float z) {
    return lerp(lerp(load<V>(at), load<V>(at + plane), z), lerp(load<V>(at + row), load<V>(at + row + plane), z), y);
}
inline Cell trilinear(const float* at, std::ptrdiff_t row, std::ptrdiff_t plane, float x, float y, float z) {
#if defined(__AVX__)
    const Pair line = bilinear<Pair>(at, row, plane, y, z);
    return lerp(__builtin_shufflevector(line, line, 0, 1, 2, 3), __builtin_shufflevector(line, line, 4, 5, 6, 7), x);
#else
    return lerp(bilinear<Cell>(at, row, plane, y, z), bilinear<Cell>(at + 4, row, plane, y, z), x);
#endif
}

constexpr BlockMask k_is_x = {-1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0};
constexpr BlockMask k_is_y = {0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0};
constexpr BlockMask k_is_z = {0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0};

// x of one neighbour, y of another, z of a third, 0: four cells.
inline Block normal_components(const float* x, const float* y, const float* z) {
    const Block none = {};
    return k_is_x ? load<Block>(x) : k_is_y ? load<Block>(y) : k_is_z ? load<Block>(z) : none;
}

// Sums of neighbouring lanes, those of `a` before those of `b`.
inline Block pair_sums(Block a, Block b) {
    return __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30) +
           __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
}
inline Block interleave_low(Block a, Block b) {
    return __builtin_shufflevector(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
}
inline Block interleave_high(Block a, Block b) {
    return __builtin_shufflevector(a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
}
// Cells from their (x, y) pairs and (z, w) pairs.
inline Block join_low(Block xy, Block zw) {
    return __builtin_shufflevector(xy, zw, 0, 1, 16, 17, 2, 3, 18, 19, 4, 5, 20, 21, 6, 7, 22, 23);
}
inline Block join_high(Block xy, Block zw) {
    return __builtin_shufflevector(xy, zw, 8, 9, 24, 25, 10, 11, 26, 27, 12, 13, 28, 29, 14, 15, 30, 31);
}

// Stand-ins for std::min and std::max, which the linker could hand to the rest of the program.
inline int smaller(int a, int b) {
    return a < b ? a : b;
}
inline int larger(int a, int b) {
    return a > b ? a : b;
}

// First float of cell (0, j, k) in a padded array.
inline std::ptrdiff_t row_of(const StamTask& task, int j, int k) {
    return k * task.plane_stride + j * task.row_stride;
}
inline const float* pressure_row(const StamTask& task, int j, int k) {
    return task.pressure + (static_cast<std::ptrdiff_t>(k) * task.cells[1] + j) * task.pressure_pitch;
}

void mirror_floor(const StamTask& task, int k) {
    const Cell mirror = {1.0f, -1.0f, 1.0f, 1.0f};
    const float* const inside = task.velocity + row_of(task, 0, k);
    float* const below = task.velocity + row_of(task, -1, k);
    for (int i = 0; i < task.cells[0]; ++i)
        store(below + 4 * i, mirror * load<Cell>(inside + 4 * i));
}

void advect_plane(const StamTask& task, int k) {
    // Open: one cell beyond the outermost centre, where everything is ambient. Floor: at the face.
    constexpr float k_open = -1.0f, k_floor = -0.5f;
    const int nx = task.cells[0], ny = task.cells[1];
    const float high_x = static_cast<float>(nx), high_y = static_cast<float>(ny), high_z = static_cast<float>(task.cells[2]);
    const auto row_cells = static_cast<std::int32_t>(task.row_stride / 4);
    const auto plane_cells = static_cast<std::int32_t>(task.plane_stride / 4);
    const float speed = task.cells_per_speed;
    Points points;
    for (int j = 0; j < ny; ++j) {
        const float* const here = task.velocity + row_of(task, j, k);
        float* const result = task.advected + row_of(task, j, k);
        for (int i0 = 0; i0 < nx; i0 += k_run) {
            const int count = smaller(nx - i0, k_run);
            const float* const velocity = here + 4 * i0;
            prefetch_row(velocity + k_planes_ahead * task.plane_stride, count);
            for (int n = 0; n < count; ++n)
                points.offset[n] = 0;
            locate_axis(static_cast<float>(i0), 1.0f, k_open, high_x, 1, count, 0, velocity, speed, points);
            locate_axis(static_cast<float>(j), 0.0f, k_floor, high_y, row_cells, count, 1, velocity, speed, points);
            locate_axis(static_cast<float>(k), 0.0f, k_open, high_z, plane_cells, count, 2, velocity, speed, points);
            for (int n = 0; n < count; ++n)
                store(result + 4 * (i0 + n),
                      trilinear(task.velocity + 4 * static_cast<std::ptrdiff_t>(points.offset[n]), task.row_stride,
                                task.plane_stride, points.fraction[0][n], points.fraction[1][n], points.fraction[2][n]));
        }
        // For the divergence, whose ghost at an open boundary is the cell inside.
        store(result - 4, load<Cell>(result));
        store(result + 4 * nx, load<Cell>(result + 4 * (nx - 1)));
    }
}

void divergence_plane(const StamTask& task, int k) {
    const int nx = task.cells[0], ny = task.cells[1], nz = task.cells[2];
    const float* const field = task.advected;
    for (int j = 0; j < ny; ++j) {
        const float* const here = field + row_of(task, j, k);
        // The floor turns the sign of v: below the lowest row lies -v of the row itself.
        const float below_sign = j > 0 ? 1.0f : -1.0f;
        const float* const below = field + row_of(task, larger(j - 1, 0), k);
        const float* const above = field + row_of(task, smaller(j + 1, ny - 1), k);
        const float* const back = field + row_of(task, j, larger(k - 1, 0));
        const float* const front = field + row_of(task, j, smaller(k + 1, nz - 1));
        const BlockMask none = {};
        const BlockMask turned = (none + (j > 0 ? 0 : INT32_MIN)) & k_is_y;
        const auto differences = [&](int n) {
            const Block low = normal_components(here + n - 4, below + n, back + n);
            const Block high = normal_components(here + n + 4, above + n, front + n);
            return high - reinterpret_cast<Block>(reinterpret_cast<BlockMask>(low) ^ turned);
        };
        float* const result = task.divergence + (static_cast<std::size_t>(k) * ny + j) * nx;
        int i = 0;
        for (; i + 16 <= nx; i += 16) {
            const Block first = pair_sums(differences(4 * i), differences(4 * i + 16));
            const Block second = pair_sums(differences(4 * i + 32), differences(4 * i + 48));
            store(result + i, 0.5f * pair_sums(first, second));
        }
        for (; i < nx; ++i)
            result[i] = 0.5f * ((here[4 * i + 4] - here[4 * i - 4]) + (above[4 * i + 1] - below_sign * below[4 * i + 1]) +
                                (front[4 * i + 2] - back[4 * i + 2]));
    }
}

void gradient_plane(const StamTask& task, int k) {
    const int nx = task.cells[0], ny = task.cells[1], nz = task.cells[2];
    for (int j = 0; j < ny; ++j) {
        // p = 0 at the ghosts beyond open boundaries; the floor mirrors it. Along x, jacobi.h keeps ghosts.
        const float* const here = pressure_row(task, j, k);
        const float* const below = pressure_row(task, larger(j - 1, 0), k);
        const float* const above = pressure_row(task, smaller(j + 1, ny - 1), k);
        const float* const back = pressure_row(task, j, larger(k - 1, 0));
        const float* const front = pressure_row(task, j, smaller(k + 1, nz - 1));
        const float above_sign = j + 1 < ny ? 0.5f : 0.0f;
        const float back_sign = k > 0 ? 0.5f : 0.0f;
        const float front_sign = k + 1 < nz ? 0.5f : 0.0f;
        const float* const source = task.advected + row_of(task, j, k);
        float* const result = task.velocity + row_of(task, j, k);
        const auto subtract = [&](int cell, Block slope) { store(result + 4 * cell, load<Block>(source + 4 * cell) - slope); };
        int i = 0;
        for (; i + 16 <= nx; i += 16) {
            const Block none = {};
            const Block x = 0.5f * (load<Block>(here + i + 1) - load<Block>(here + i - 1));
            const Block y = above_sign * load<Block>(above + i) - 0.5f * load<Block>(below + i);
            const Block z = front_sign * load<Block>(front + i) - back_sign * load<Block>(back + i);
            const Block xy_low = interleave_low(x, y), xy_high = interleave_high(x, y);
            const Block zw_low = interleave_low(z, none), zw_high = interleave_high(z, none);
            subtract(i, join_low(xy_low, zw_low));
            subtract(i + 4, join_high(xy_low, zw_low));
            subtract(i + 8, join_low(xy_high, zw_high));
            subtract(i + 12, join_high(xy_high, zw_high));
        }
        for (; i < nx; ++i) {
            const Cell slope = {0.5f * (here[i + 1] - here[i - 1]), above_sign * above[i] - 0.5f * below[i],
                                front_sign * front[i] - back_sign * back[i], 0.0f};
            store(result + 4 * i, load<Cell>(source + 4 * i) - slope);
        }
    }
    mirror_floor(task, k);
}
