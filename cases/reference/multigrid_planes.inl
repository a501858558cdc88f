// The passes of multigrid.h, a plane a task: rows in unit stride, neighbours by weights that are 0 beyond walls and open faces.

// What a row of L needs: the rows beside it and their weights.
struct LevelRow {
    const float *here, *below, *above, *back, *front;
    const float *low, *high; ///< weights along the row
    float low_y, high_y, low_z, high_z;
    const float *diagonal, *inverse, *source;

    // Sum of the weighted neighbours.
    float around(int i) const {
        return (low[i] * here[i - 1] + high[i] * here[i + 1]) + (low_y * below[i] + high_y * above[i]) +
               (low_z * back[i] + high_z * front[i]);
    }
};

inline LevelRow level_row(const MultigridLevel& level, const float* field, int j, int k) {
    const int ny = level.cells[1], nz = level.cells[2];
    const std::ptrdiff_t pitch = level.pitch, plane = ny * pitch, row = k * plane + j * pitch;
    const float* const here = field + row;
    // Beyond a wall or an open face the weight is 0, and the row itself stands in.
    const auto beside = [&](int axis, int index, int count, int side, std::ptrdiff_t stride) {
        const int other = index + side;
        if (other >= 0 && other < count)
            return here + side * stride;
        return level.periodic[axis] ? here - side * (count - 1) * stride : here;
    };
    const std::ptrdiff_t kinds = (level.kind[0][j] * level.kinds_of_z + level.kind[1][k]) * level.row_pitch;
    return {.here = here,
            .below = beside(1, j, ny, -1, pitch),
            .above = beside(1, j, ny, +1, pitch),
            .back = beside(2, k, nz, -1, plane),
            .front = beside(2, k, nz, +1, plane),
            .low = level.low[0],
            .high = level.high[0],
            .low_y = level.low[1][j],
            .high_y = level.high[1][j],
            .low_z = level.low[2][k],
            .high_z = level.high[2][k],
            .diagonal = level.diagonal + kinds,
            .inverse = level.inverse + kinds,
            .source = level.source + row};
}

inline void wrap_row(float* row, int count) {
    row[-1] = row[count - 1];
    row[count] = row[0];
}

void multigrid_smooth(const MultigridSmooth& task, int k) {
    const int nx = task.level.cells[0], ny = task.level.cells[1];
    const float weight = task.weight, kept = 1.0f - weight;
    for (int j = 0; j < ny; ++j) {
        const LevelRow row = level_row(task.level, task.now != nullptr ? task.now : task.next, j, k);
        float* const result = task.next + (static_cast<std::ptrdiff_t>(k) * ny + j) * task.level.pitch;
        if (task.now == nullptr) {
            WINDROW_INDEPENDENT
            for (int i = 0; i < nx; ++i)
                result[i] = -weight * row.inverse[i] * row.source[i];
        } else {
            WINDROW_INDEPENDENT
            for (int i = 0; i < nx; ++i)
                result[i] = kept * row.here[i] + weight * row.inverse[i] * (row.around(i) - row.source[i]);
        }
        if (task.level.periodic[0])
            wrap_row(result, nx);
    }
}

// First cell beyond those that a coarse cell holds: two each, the last one what is left.
inline int end_of_children(int coarse, int coarse_count, int count) {
    return coarse + 1 < coarse_count ? 2 * coarse + 2 : count;
}
inline int parent_of(int cell, int coarse_count) {
    return cell / 2 < coarse_count ? cell / 2 : coarse_count - 1;
}

void multigrid_restrict(const MultigridRestrict& task, int coarse_k) {
    const int nx = task.fine.cells[0], ny = task.fine.cells[1], nz = task.fine.cells[2];
    const int coarse_nx = task.coarse_cells[0], coarse_ny = task.coarse_cells[1], coarse_nz = task.coarse_cells[2];
    const float* const share = task.share[0];
    alignas(64) float sum[k_longest_row];
    for (int coarse_j = 0; coarse_j < coarse_ny; ++coarse_j) {
        bool first = true;
        for (int k = 2 * coarse_k; k < end_of_children(coarse_k, coarse_nz, nz); ++k)
            for (int j = 2 * coarse_j; j < end_of_children(coarse_j, coarse_ny, ny); ++j) {
                const LevelRow row = level_row(task.fine, task.now, j, k);
                const float of_row = task.share[1][j] * task.share[2][k];
                const auto left = [&](int i) {
                    return of_row * (row.source[i] - (row.around(i) - row.diagonal[i] * row.here[i]));
                };
                if (first) {
                    WINDROW_INDEPENDENT
                    for (int i = 0; i < nx; ++i)
                        sum[i] = left(i);
                } else {
                    WINDROW_INDEPENDENT
                    for (int i = 0; i < nx; ++i)
                        sum[i] += left(i);
                }
                first = false;
            }
        float* const result = task.coarse + (static_cast<std::ptrdiff_t>(coarse_k) * coarse_ny + coarse_j) * task.coarse_pitch;
        const int last = coarse_nx - 1;
        for (int i = 0; i < last; ++i)
            result[i] = share[2 * i] * sum[2 * i] + share[2 * i + 1] * sum[2 * i + 1];
        result[last] = 0.0f;
        for (int i = 2 * last; i < nx; ++i)
            result[last] += share[i] * sum[i];
    }
}

void multigrid_prolong(const MultigridProlong& task, int k) {
    const int nx = task.cells[0], ny = task.cells[1];
    const int coarse_nx = task.coarse_cells[0], coarse_ny = task.coarse_cells[1], coarse_nz = task.coarse_cells[2];
    alignas(64) float line[k_longest_row + 2];
    float* const coarse = line + 1;
    for (int j = 0; j < ny; ++j) {
        const auto coarse_row = [&](int coarse_j, int coarse_k) {
            return task.coarse + (static_cast<std::ptrdiff_t>(coarse_k) * coarse_ny + coarse_j) * task.coarse_pitch;
        };
        const int own_j = parent_of(j, coarse_ny), own_k = parent_of(k, coarse_nz);
        const int beside_j = task.neighbour_cell[1][j], beside_k = task.neighbour_cell[2][k];
        const float *const a = coarse_row(own_j, own_k), *const b = coarse_row(beside_j, own_k);
        const float *const c = coarse_row(own_j, beside_k), *const d = coarse_row(beside_j, beside_k);
        const float y = task.parent[1][j], beside_y = task.neighbour[1][j];
        const float z = task.parent[2][k], beside_z = task.neighbour[2][k];
        WINDROW_INDEPENDENT
        for (int i = 0; i < coarse_nx; ++i)
            coarse[i] = z * (y * a[i] + beside_y * b[i]) + beside_z * (y * c[i] + beside_y * d[i]);
        wrap_row(coarse, coarse_nx);
        float* const row = task.now + (static_cast<std::ptrdiff_t>(k) * ny + j) * task.pitch;
        // Left children look to the left, right ones to the right; the last coarse cell may hold one or three.
        const int last = coarse_nx - 1;
        WINDROW_INDEPENDENT
        for (int i = 0; i < last; ++i) {
            row[2 * i] += task.parent[0][2 * i] * coarse[i] + task.neighbour[0][2 * i] * coarse[i - 1];
            row[2 * i + 1] += task.parent[0][2 * i + 1] * coarse[i] + task.neighbour[0][2 * i + 1] * coarse[i + 1];
        }
        for (int i = 2 * last; i < nx; ++i)
            row[i] += task.parent[0][i] * coarse[last] + task.neighbour[0][i] * coarse[task.neighbour_cell[0][i]];
        if (task.periodic_x)
            wrap_row(row, nx);
    }
}
