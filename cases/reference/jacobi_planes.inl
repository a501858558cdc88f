// One plane of a Jacobi sweep: rows in unit stride, sides by an affine image of the row inside, so that the loop has no branch.

struct Neighbour {
    const float* values;
    float scale;
};

void jacobi_plane(const JacobiTask& task, int k) {
    const int nx = task.cells[0], ny = task.cells[1], nz = task.cells[2];
    const auto row = [&](int j, int plane) { return (static_cast<std::size_t>(plane) * ny + j) * task.pitch; };
    for (int j = 0; j < ny; ++j) {
        const float* const here = task.now + row(j, k);
        // p = 0 at a ghost beyond an open boundary; a floor mirrors the cell inside.
        const Neighbour below = j > 0 ? Neighbour{task.now + row(j - 1, k), 1.0f} : Neighbour{here, 1.0f};
        const Neighbour above = j + 1 < ny ? Neighbour{task.now + row(j + 1, k), 1.0f} : Neighbour{here, 0.0f};
        const Neighbour back = k > 0 ? Neighbour{task.now + row(j, k - 1), 1.0f} : Neighbour{here, 0.0f};
        const Neighbour front = k + 1 < nz ? Neighbour{task.now + row(j, k + 1), 1.0f} : Neighbour{here, 0.0f};
        const float* const source = task.source + (static_cast<std::size_t>(k) * ny + j) * nx;
        float* const result = task.next + row(j, k);
        WINDROW_INDEPENDENT
        for (int i = 0; i < nx; ++i)
            result[i] = (1.0f / 6.0f) * ((here[i - 1] + here[i + 1]) + (below.values[i] + above.scale * above.values[i]) +
                                         (back.scale * back.values[i] + front.scale * front.values[i]) - source[i]);
        result[-1] = 0.0f;
        result[nx] = 0.0f;
    }
}

// --- Any sides. Apart from the above, whose sides the compiler knows: on rows of 32 cells factors that are known at run time alone
// cost the yardstick a tenth of its time.

// The row beside one row along y or z, `stride` floats from it; `side` is -1 or 1.
inline Neighbour neighbour_of(const JacobiTask& task, int axis, int index, int side, std::ptrdiff_t stride, const float* here) {
    const int last = task.cells[axis] - 1;
    if (side < 0 ? index > 0 : index < last)
        return {here + side * stride, 1.0f};
    if (task.periodic[axis])
        return {here - side * last * stride, 1.0f};
    return {here, task.ghost[axis][side < 0 ? 0 : 1]};
}

void jacobi_plane_any_sides(const JacobiTask& task, int k) {
    const int nx = task.cells[0], ny = task.cells[1];
    const auto pitch = static_cast<std::ptrdiff_t>(task.pitch);
    const float weight = task.weight;
    for (int j = 0; j < ny; ++j) {
        const std::ptrdiff_t row = (static_cast<std::ptrdiff_t>(k) * ny + j) * pitch;
        const float* const here = task.now + row;
        const Neighbour below = neighbour_of(task, 1, j, -1, pitch, here), above = neighbour_of(task, 1, j, 1, pitch, here);
        const Neighbour back = neighbour_of(task, 2, k, -1, ny * pitch, here),
                        front = neighbour_of(task, 2, k, 1, ny * pitch, here);
        const float* const source = task.source + (static_cast<std::size_t>(k) * ny + j) * nx;
        float* const result = task.next + row;
        WINDROW_INDEPENDENT
        for (int i = 0; i < nx; ++i)
            result[i] = weight * ((here[i - 1] + here[i + 1]) + (below.scale * below.values[i] + above.scale * above.values[i]) +
                                  (back.scale * back.values[i] + front.scale * front.values[i]) - source[i]);
        result[-1] = task.periodic[0] ? result[nx - 1] : task.ghost[0][0] * result[0];
        result[nx] = task.periodic[0] ? result[0] : task.ghost[0][1] * result[nx - 1];
    }
}
