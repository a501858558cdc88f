// One plane of a Jacobi sweep in a box with any sides. Apart from jacobi_plane.inl, whose sides the compiler knows: on rows of 32
// cells factors that are known at run time alone cost the yardstick a tenth of its time.

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
