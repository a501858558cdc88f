// Stencils on unpadded fields: divergence, gradient, seven-point diffusion. A neighbour beyond a side is an image
// of a cell inside (NormalGhost, HaloRule), so a row's loop is the same inside and at a side.

// A neighbouring row with the rule that makes its values.
struct ScalarRow {
    const float* values;
    float scale;
};

inline ScalarRow neighbour_row(const float* field, std::size_t row_floats, std::size_t axis_stride, std::size_t row, int index, int count,
                               int side, const NormalGhost& ghost) {
    const int neighbour = index + side;
    if (neighbour >= 0 && neighbour < count)
        return {field + (row + side * static_cast<std::ptrdiff_t>(axis_stride)) * row_floats, 1.0f};
    return {field + (row + (ghost.source - index) * static_cast<std::ptrdiff_t>(axis_stride)) * row_floats, ghost.scale};
}

void divergence_plane(const DivergenceTask& task, int plane) {
    const int nx = task.cells[0], ny = task.cells[1], nz = task.cells[2];
    const std::size_t row_floats = 4 * static_cast<std::size_t>(nx);
    for (int j = 0; j < ny; ++j) {
        const std::size_t row = static_cast<std::size_t>(plane) * ny + j;
        const float* const here = task.velocity + row * row_floats;
        const ScalarRow y0 = neighbour_row(task.velocity, row_floats, 1, row, j, ny, -1, task.ghosts[1][0]);
        const ScalarRow y1 = neighbour_row(task.velocity, row_floats, 1, row, j, ny, +1, task.ghosts[1][1]);
        const ScalarRow z0 = neighbour_row(task.velocity, row_floats, ny, row, plane, nz, -1, task.ghosts[2][0]);
        const ScalarRow z1 = neighbour_row(task.velocity, row_floats, ny, row, plane, nz, +1, task.ghosts[2][1]);
        float* const result = task.result + row * task.pitch;
        const auto across = [&](int i) {
            const float dy = y1.scale * y1.values[4 * i + 1] - y0.scale * y0.values[4 * i + 1];
            const float dz = z1.scale * z1.values[4 * i + 2] - z0.scale * z0.values[4 * i + 2];
            return dy + dz;
        };
        const NormalGhost& x0 = task.ghosts[0][0];
        const NormalGhost& x1 = task.ghosts[0][1];
        const float low = x0.scale * here[4 * x0.source];
        const float high = x1.scale * here[4 * x1.source];
        for (int i = 1; i < nx - 1; ++i)
            result[i] = task.scale * ((here[4 * (i + 1)] - here[4 * (i - 1)]) + across(i));
        result[0] = task.scale * (((nx > 1 ? here[4] : high) - low) + across(0));
        if (nx > 1)
            result[nx - 1] = task.scale * ((high - here[4 * (nx - 2)]) + across(nx - 1));
    }
}

void gradient_plane(const GradientTask& task, int plane) {
    const int nx = task.cells[0], ny = task.cells[1], nz = task.cells[2];
    const std::size_t row_floats = task.pitch;
    const Cell scale = splat(task.scale);
    for (int j = 0; j < ny; ++j) {
        const std::size_t row = static_cast<std::size_t>(plane) * ny + j;
        const float* const here = task.potential + row * row_floats;
        const ScalarRow y0 = neighbour_row(task.potential, row_floats, 1, row, j, ny, -1, task.ghosts[1][0]);
        const ScalarRow y1 = neighbour_row(task.potential, row_floats, 1, row, j, ny, +1, task.ghosts[1][1]);
        const ScalarRow z0 = neighbour_row(task.potential, row_floats, ny, row, plane, nz, -1, task.ghosts[2][0]);
        const ScalarRow z1 = neighbour_row(task.potential, row_floats, ny, row, plane, nz, +1, task.ghosts[2][1]);
        float* const velocity = task.velocity + 4 * row * nx;
        float* const gradient = task.gradient != nullptr ? task.gradient + 4 * row * nx : nullptr;
        const auto put = [&](int i, float left, float right) {
            const Cell slope = scale * Cell{right - left, y1.scale * y1.values[i] - y0.scale * y0.values[i],
                                            z1.scale * z1.values[i] - z0.scale * z0.values[i], 0.0f};
            store_cell(velocity + 4 * i, load_cell(velocity + 4 * i) - slope);
            if (gradient != nullptr)
                store_cell(gradient + 4 * i, slope);
        };
        const float low = task.ghosts[0][0].scale * here[task.ghosts[0][0].source];
        const float high = task.ghosts[0][1].scale * here[task.ghosts[0][1].source];
        put(0, low, nx > 1 ? here[1] : high);
        for (int i = 1; i < nx - 1; ++i)
            put(i, here[i - 1], here[i + 1]);
        if (nx > 1)
            put(nx - 1, here[nx - 2], high);
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
        const auto put = [&](int i, Cell left, Cell right) {
            const Cell value = load_cell(here + 4 * i);
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
