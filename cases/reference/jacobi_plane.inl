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
        // p = 0 at a ghost beyond an open side; a floor mirrors the cell inside.
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
