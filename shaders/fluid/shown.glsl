// Velocity of a cell as a frame shows it: between the last two ticks. Define WINDROW_BETWEEN_TICKS, and the buffers `velocity`
// and `before`.
vec4 shown_cell(int at, float factor) {
    const vec4 u = velocity[now(at)];
    precise const vec4 between = before[at] + factor * (u - before[at]); // the bits of SavedAir::fill
    // Non-finite values are not shown: after a repair the output is the current air.
    return factor == 1.0f || control.plan.nonfinite_cells + control.nonfinite_cells > 0u ? u : between;
}
