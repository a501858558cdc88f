// Stencils on unpadded fields: divergence, gradient, seven-point diffusion. A neighbour beyond a boundary is an image of a cell
// inside (NormalGhost, HaloRule), so a row's loop is the same inside and at a boundary.

// A neighbouring row with the rule that makes its values.
struct ScalarRow {
    const float* values;
    float scale;
};

inline ScalarRow neighbour_row(const float* field, std::size_t row_floats, std::size_t axis_stride, std::size_t row, int index,
                               int count, int side, const NormalGhost& ghost) {
    const int neighbour = index + side;
    if (neighbour >= 0 && neighbour < count)
        return {field + (row + side * static_cast<std::ptrdiff_t>(axis_stride)) * row_floats, 1.0f};
    return {field + (row + (ghost.source - index) * static_cast<std::ptrdiff_t>(axis_stride)) * row_floats, ghost.scale};
}

// Sums of differences over two cells, a row at a time: (x1 - x0) + ((y1 - y0) + (z1 - z0)).
class DivergenceRow {
  public:
    DivergenceRow(const DivergenceTask& task, int plane, int j)
        : cells_(task.cells[0]),
          here_(task.velocity + 4 * (static_cast<std::size_t>(plane) * task.cells[1] + j) * task.cells[0]) {
        const int ny = task.cells[1], nz = task.cells[2];
        const std::size_t row = static_cast<std::size_t>(plane) * ny + j, row_floats = 4 * static_cast<std::size_t>(cells_);
        y_[0] = neighbour_row(task.velocity, row_floats, 1, row, j, ny, -1, task.ghosts[1][0]);
        y_[1] = neighbour_row(task.velocity, row_floats, 1, row, j, ny, +1, task.ghosts[1][1]);
        z_[0] = neighbour_row(task.velocity, row_floats, ny, row, plane, nz, -1, task.ghosts[2][0]);
        z_[1] = neighbour_row(task.velocity, row_floats, ny, row, plane, nz, +1, task.ghosts[2][1]);
        if (task.row_scales != nullptr)
            y_[0].scale *= task.row_scales[j], y_[1].scale *= task.row_scales[j];
        low_ = task.ghosts[0][0].scale * here_[4 * task.ghosts[0][0].source];
        high_ = task.ghosts[0][1].scale * here_[4 * task.ghosts[0][1].source];
        if (cells_ < k_native_lanes)
            return;
        // Neighbours of the row's outermost registers, including values beyond the row.
        first_[0] = low_;
        last_[4 * (k_native_cells - 1)] = high_;
        for (int cell = 1; cell < k_native_cells; ++cell) {
            first_[4 * cell] = here_[4 * (cell - 1)];
            last_[4 * (cell - 1)] = here_[4 * (cells_ - k_native_cells + cell)];
        }
    }

    float at(int i) const {
        const float dy = y_[1].scale * y_[1].values[4 * i + 1] - y_[0].scale * y_[0].values[4 * i + 1];
        const float dz = z_[1].scale * z_[1].values[4 * i + 2] - z_[0].scale * z_[0].values[4 * i + 2];
        const float left = i > 0 ? here_[4 * (i - 1)] : low_;
        const float right = i < cells_ - 1 ? here_[4 * (i + 1)] : high_;
        return (right - left) + (dy + dz);
    }

    // Cells i to i + k_native_lanes - 1, all inside the row, i a multiple of k_native_lanes.
    Native block_at(int i) const {
        CellRegisters differences;
#pragma GCC unroll 4
        for (int part = 0; part < 4; ++part) {
            const int cell = i + part * k_native_cells;
            const float* const left = cell > 0 ? here_ + 4 * (cell - 1) : first_;
            const float* const right = cell + k_native_cells < cells_ ? here_ + 4 * (cell + 1) : last_;
            differences.part[part] = by_axis(right, y_[1], z_[1], cell) - by_axis(left, y_[0], z_[0], cell);
        }
        const Components d = dealt_components_of(differences);
        return undeal(d.x + (d.y + d.z));
    }

  private:
    static Native by_axis(const float* x, const ScalarRow& y, const ScalarRow& z, int cell) {
        const Native along_y = y.scale * load_native(y.values + 4 * cell), along_z = z.scale * load_native(z.values + 4 * cell);
        return k_is_x ? load_native(x) : k_is_y ? along_y : along_z;
    }

    int cells_;
    const float* here_;
    ScalarRow y_[2], z_[2];
    float low_, high_; ///< beyond the row's ends
    alignas(64) float first_[k_native_lanes] = {};
    alignas(64) float last_[k_native_lanes] = {};
};

// A row of task.scale times the divergence.
inline void divergence_row(const DivergenceTask& task, int plane, int j, float* result) {
    const DivergenceRow row(task, plane, j);
    const Native scale = task.scale - Native{};
    int i = 0;
    for (; i + k_native_lanes <= task.cells[0]; i += k_native_lanes)
        store_native(result + i, scale * row.block_at(i));
    for (; i < task.cells[0]; ++i)
        result[i] = task.scale * row.at(i);
}

void divergence_plane(const DivergenceTask& task, int plane) {
    for (int j = 0; j < task.cells[1]; ++j)
        divergence_row(task, plane, j, task.result + (static_cast<std::size_t>(plane) * task.cells[1] + j) * task.pitch);
}

double divergence_squares(const DivergenceTask& task, const float* wanted, int plane, int first_row, int last_row) {
    const int nx = task.cells[0];
    const Native scale = task.scale - Native{};
    Native squares = {};
    float rest = 0.0f;
    for (int j = first_row; j < last_row; ++j) {
        const DivergenceRow row(task, plane, j);
        const float* const row_wanted =
            wanted != nullptr ? wanted + (static_cast<std::size_t>(plane) * task.cells[1] + j) * nx : nullptr;
        int i = 0;
        for (; i + k_native_lanes <= nx; i += k_native_lanes) {
            Native left = scale * row.block_at(i);
            if (row_wanted != nullptr)
                left -= load_native(row_wanted + i);
            squares += left * left;
        }
        for (; i < nx; ++i) {
            const float left = task.scale * row.at(i) - (row_wanted != nullptr ? row_wanted[i] : 0.0f);
            rest += left * left;
        }
    }
    double sum = static_cast<double>(rest);
    for (int lane = 0; lane < k_native_lanes; ++lane)
        sum += static_cast<double>(squares[lane]);
    return sum;
}

void gradient_plane(const GradientTask& task, int plane) {
    const int nx = task.cells[0], ny = task.cells[1], nz = task.cells[2];
    const std::size_t row_floats = task.pitch;
    const Native scale = task.scale - Native{}, weight = task.weight - Native{}, kept = task.kept - Native{};
    const bool keeps = task.kept != 0.0f;
    alignas(64) float line[k_max_row + 2]; // the row and the values beyond its ends
    for (int j = 0; j < ny; ++j) {
        const std::size_t row = static_cast<std::size_t>(plane) * ny + j;
        const float* const here = task.potential + row * row_floats;
        ScalarRow y0 = neighbour_row(task.potential, row_floats, 1, row, j, ny, -1, task.ghosts[1][0]);
        ScalarRow y1 = neighbour_row(task.potential, row_floats, 1, row, j, ny, +1, task.ghosts[1][1]);
        if (task.row_scales != nullptr)
            y0.scale *= task.row_scales[j], y1.scale *= task.row_scales[j];
        const ScalarRow z0 = neighbour_row(task.potential, row_floats, ny, row, plane, nz, -1, task.ghosts[2][0]);
        const ScalarRow z1 = neighbour_row(task.potential, row_floats, ny, row, plane, nz, +1, task.ghosts[2][1]);
        float* const velocity = task.velocity + 4 * row * nx;
        float* const gradient = task.gradient != nullptr ? task.gradient + 4 * row * nx : nullptr;
        line[0] = task.ghosts[0][0].scale * here[task.ghosts[0][0].source];
        line[nx + 1] = task.ghosts[0][1].scale * here[task.ghosts[0][1].source];
        __builtin_memcpy(line + 1, here, sizeof(float) * static_cast<std::size_t>(nx));
        int i = 0;
        for (; i + k_native_lanes <= nx; i += k_native_lanes) {
            const CellRegisters slopes =
                cells_of({scale * (load_native(line + i + 2) - load_native(line + i)),
                          scale * (y1.scale * load_native(y1.values + i) - y0.scale * load_native(y0.values + i)),
                          scale * (z1.scale * load_native(z1.values + i) - z0.scale * load_native(z0.values + i))});
#pragma GCC unroll 4
            for (int part = 0; part < 4; ++part) {
                const std::ptrdiff_t at = 4 * i + part * k_native_lanes;
                store_native(velocity + at, load_native(velocity + at) - slopes.part[part]);
                if (gradient == nullptr)
                    continue;
                Native next = weight * slopes.part[part];
                if (keeps)
                    next += kept * load_native(gradient + at);
                store_native(gradient + at, next);
            }
        }
        for (; i < nx; ++i) {
            const Cell slope = splat(task.scale) * Cell{line[i + 2] - line[i], y1.scale * y1.values[i] - y0.scale * y0.values[i],
                                                        z1.scale * z1.values[i] - z0.scale * z0.values[i], 0.0f};
            store_cell(velocity + 4 * i, load_cell(velocity + 4 * i) - slope);
            if (gradient == nullptr)
                continue;
            Cell next = splat(task.weight) * slope;
            if (keeps)
                next += splat(task.kept) * load_cell(gradient + 4 * i);
            store_cell(gradient + 4 * i, next);
        }
    }
}

// A neighbouring row of cells with the rule that makes its values.
struct CellRow {
    const float* values;
    Cell scale, offset;
    Cell at(int i) const { return scale * load_cell(values + 4 * i) + offset; }
};

inline CellRow cell_row(const DiffuseTask& task, const HaloRule& rule, std::size_t source_row) {
    const float* const values = task.field + 4 * source_row * task.cells[0];
    if (rule.ambient)
        return {values, splat(0.0f), load_cell(task.ambient)};
    return {values, load_cell(rule.scale), load_cell(rule.offset)};
}

void diffuse_plane(const DiffuseTask& task, int plane) {
    const int nx = task.cells[0], ny = task.cells[1];
    const Cell ratio = splat(task.ratio), six = splat(6.0f);
    const std::size_t plane_rows = ny;
    for (int j = 0; j < ny; ++j) {
        const std::size_t row = plane * plane_rows + j;
        const auto y_row = [&](int side) {
            const HaloRule& rule = task.rules[1][j + side + k_halo_low];
            return cell_row(task, rule, plane * plane_rows + rule.source);
        };
        const auto z_row = [&](int side) {
            const HaloRule& rule = task.rules[2][plane + side + k_halo_low];
            return cell_row(task, rule, rule.source * plane_rows + j);
        };
        const CellRow y0 = y_row(-1), y1 = y_row(+1), z0 = z_row(-1), z1 = z_row(+1);
        const float* const here = task.field + 4 * row * nx;
        float* const result = task.result + 4 * row * nx;
        const auto x_ghost = [&](int index) {
            const HaloRule& rule = task.rules[0][index + k_halo_low];
            if (rule.ambient)
                return load_cell(task.ambient);
            return load_cell(rule.scale) * load_cell(here + 4 * rule.source) + load_cell(rule.offset);
        };
        const bool stretched = task.row_scales != nullptr;
        const Cell four = splat(4.0f), below = splat(stretched ? task.row_scales[j] * task.links[j] : 1.0f),
                   above = splat(stretched ? task.row_scales[j] * task.links[j + 1] : 1.0f);
        const auto put = [&](int i, Cell left, Cell right) {
            const Cell value = load_cell(here + 4 * i);
            if (stretched) {
                const Cell level = ((left + right) + (z0.at(i) + z1.at(i))) - four * value;
                const Cell upright = below * (y0.at(i) - value) + above * (y1.at(i) - value);
                return store_cell(result + 4 * i, value + ratio * (level + upright));
            }
            const Cell sum = ((left + right) + (y0.at(i) + y1.at(i))) + (z0.at(i) + z1.at(i));
            store_cell(result + 4 * i, value + ratio * (sum - six * value));
        };
        put(0, x_ghost(-1), nx > 1 ? load_cell(here + 4) : x_ghost(1));
        for (int i = 1; i < nx - 1; ++i)
            put(i, load_cell(here + 4 * (i - 1)), load_cell(here + 4 * (i + 1)));
        if (nx > 1)
            put(nx - 1, load_cell(here + 4 * (nx - 2)), x_ghost(nx));
    }
}
