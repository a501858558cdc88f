// Advection of a scalar: one float a cell. Plain loops: a tracer serves tests and hosts and is not part of the step.

inline float scalar_lerp(float a, float b, float t) {
    return multiply_add(t, b - a, a);
}

inline float sample_scalar(const float* at, const PaddedStrides& s, const Linear::Weights& w, int n) {
    const float x = w.x[n], y = w.y[n], z = w.z[n];
    const float low = scalar_lerp(scalar_lerp(at[0], at[1], x), scalar_lerp(at[s.row], at[s.row + 1], x), y);
    const float* const up = at + s.plane;
    const float high = scalar_lerp(scalar_lerp(up[0], up[1], x), scalar_lerp(up[s.row], up[s.row + 1], x), y);
    return scalar_lerp(low, high, z);
}

inline float cubic_line(float before, float here, float after, float beyond, const Cubic::Weights& w, int axis, int n) {
    float sum = multiply_add(before - here, w.before[axis][n], here);
    sum = multiply_add(after - here, w.after[axis][n], sum);
    return multiply_add(beyond - here, w.beyond[axis][n], sum);
}

inline float sample_scalar(const float* at, const PaddedStrides& s, const Cubic::Weights& w, int n) {
    float planes[4];
    for (int k = 0; k < 4; ++k) {
        float lines[4];
        for (int j = 0; j < 4; ++j) {
            const float* const p = at + (k - 1) * s.plane + (j - 1) * s.row;
            lines[j] = cubic_line(p[-1], p[0], p[1], p[2], w, 0, n);
        }
        planes[k] = cubic_line(lines[0], lines[1], lines[2], lines[3], w, 1, n);
    }
    return cubic_line(planes[0], planes[1], planes[2], planes[3], w, 2, n);
}

inline float sample_scalar(const float* at, const PaddedStrides& s, const Cubic32::Weights& w, int n) {
    const float x = w.x[n], y = w.y[n], z = w.z[n];
    const auto linear = [](float t, const auto& value) { return scalar_lerp(value(0), value(1), t); };
    const auto added = [&](int axis, float t, const auto& value) {
        const float here = value(0);
        float sum = (value(-1) - here) * w.cubic.before[axis][n];
        sum = multiply_add(value(1) - here, w.cubic.after[axis][n] - t, sum);
        return multiply_add(value(2) - here, w.cubic.beyond[axis][n], sum);
    };
    const auto cell = [&](int i, int j, int k) { return at[k * s.plane + j * s.row + i]; };
    const auto along_x = [&](int j, int k) { return linear(x, [&](int i) { return cell(i, j, k); }); };
    const auto plane = [&](int k) { return linear(y, [&](int j) { return along_x(j, k); }); };
    const auto column = [&](int j) { return linear(z, [&](int k) { return along_x(j, k); }); };
    const auto inner = [&](int i) { return linear(z, [&](int k) { return linear(y, [&](int j) { return cell(i, j, k); }); }); };
    return linear(z, plane) + (added(0, x, inner) + (added(1, y, column) + added(2, z, plane)));
}

// `value` clamped to the eight cells around the departure point.
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
    for_each_run(task, plane, [&](const PaddedStrides& strides, const Points& points, const CellRun& run, const Displacements&) {
        const typename Interpolant::Weights weights(points, run.count);
        for (int n = 0; n < run.count; ++n) {
            const float* const at = task.padded_carried + points.offset[n];
            const float value = sample_scalar(at, strides, weights, n);
            task.result[run.first + n] = task.clamped ? clamp_to_corners(value, at, strides) : value;
        }
    });
}
