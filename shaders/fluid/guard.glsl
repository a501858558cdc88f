// Guard against non-finite cells: they become ambient, without history. Before this text: Velocity as `velocity`, History as
// `history`.

bool broken(vec4 u) { return windrow_not_finite(u.x) || windrow_not_finite(u.y) || windrow_not_finite(u.z); }

// `elapsed`: [s] from the tick's start to the air's time.
void repair(ivec3 cell, int at, float elapsed) {
    velocity[now(at)] = velocity[ago(at)] = vec4(around_at(cell, elapsed, wind_at(cell, elapsed, is_on(WINDROW_GUSTS))), 0.0f);
    history[at] = vec4(0.0f);
    atomicAdd(control.nonfinite_cells, 1u);
}
