// Ghost values beyond a boundary, as NormalGhost of fluid/cpu/kernels/kernels.h.

// The cell next to `cell` along an axis, and the factor on its value.
ivec3 neighbour(ivec3 cell, int axis, int step, vec4 low, vec4 high, out float factor) {
    ivec3 next = cell;
    next[axis] += step;
    factor = 1.0f;
    if (next[axis] < 0) {
        next[axis] = tick.low_source[axis];
        factor = low[axis];
    } else if (next[axis] >= tick.cells[axis]) {
        next[axis] = tick.high_source[axis];
        factor = high[axis];
    }
    return next;
}
