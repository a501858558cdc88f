// The same for a scalar: one float a cell. Plain loops: a tracer is a test and a service, not the step.

inline float scalar_lerp(float a, float b, float t) { return multiply_add(t, b - a, a); }

inline float sample_scalar(Linear, const float* at, const PaddedStrides& s, Cell t) {
    const float low = scalar_lerp(scalar_lerp(at[0], at[1], t[0]), scalar_lerp(at[s.row], at[s.row + 1], t[0]), t[1]);
    const float* const up = at + s.plane;
    const float high = scalar_lerp(scalar_lerp(up[0], up[1], t[0]), scalar_lerp(up[s.row], up[s.row + 1], t[0]), t[1]);
    return scalar_lerp(low, high, t[2]);
}

inline float cubic_line(float before, float here, float after, float beyond, const CubicWeights& w, int axis) {
    float sum = multiply_add(before - here, w.before[axis], here);
    sum = multiply_add(after - here, w.after[axis], sum);
    return multiply_add(beyond - here, w.beyond[axis], sum);
}

inline float sample_scalar(Cubic, const float* at, const PaddedStrides& s, Cell t) {
    const CubicWeights w(t);
    float planes[4];
    for (int k = 0; k < 4; ++k) {
        float lines[4];
        for (int j = 0; j < 4; ++j) {
            const float* const p = at + (k - 1) * s.plane + (j - 1) * s.row;
            lines[j] = cubic_line(p[-1], p[0], p[1], p[2], w, 0);
        }
        planes[k] = cubic_line(lines[0], lines[1], lines[2], lines[3], w, 1);
    }
    return cubic_line(planes[0], planes[1], planes[2], planes[3], w, 2);
}

// `value` kept within the eight cells around the departure point.
inline float clamp_to_corners(float value, const float* at, const PaddedStrides& s) {
    float least = at[0], most = at[0];
    for (int corner = 1; corner < 8; ++corner) {
        const float neighbour = at[(corner & 1) + ((corner >> 1) & 1) * s.row + (corner >> 2) * s.plane];
        least = neighbour < least ? neighbour : least;
        most = neighbour > most ? neighbour : most;
    }
    value = value < least ? least : value;
    return value > most ? most : value;
}

template <class Interpolant>
void advect_scalar_plane(const AdvectTask& task, int plane) {
    const Locator locator(task);
    std::ptrdiff_t offsets[k_row_chunk];
    Cell fractions[k_row_chunk];
    for (int j = 0; j < task.cells[1]; ++j) {
        for (int i0 = 0; i0 < task.cells[0]; i0 += k_row_chunk) {
            const int left = task.cells[0] - i0;
            const int count = left < k_row_chunk ? left : k_row_chunk;
            trace_row(task, locator, i0, j, plane, count, offsets, fractions);
            float* const result = task.result + (static_cast<std::size_t>(plane) * task.cells[1] + j) * task.cells[0] + i0;
            for (int n = 0; n < count; ++n) {
                const float* const at = task.padded_carried + offsets[n];
                const float value = sample_scalar(Interpolant{}, at, locator.strides, fractions[n]);
                result[n] = task.clamped ? clamp_to_corners(value, at, locator.strides) : value;
            }
        }
    }
}
