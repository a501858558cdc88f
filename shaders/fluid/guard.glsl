// The guard against cells that are no number: they become ambient, with no past. Before this text: Velocity as `velocity`,
// VelocityOld as `velocity_old`, History as `history`.

bool broken(vec4 u) { return windrow_broken(u.x) || windrow_broken(u.y) || windrow_broken(u.z); }

void repair(ivec3 cell, int at) {
    velocity[at] = velocity_old[at] = vec4(wind_at(cell, 0.0f, is_on(WINDROW_GUSTS)), 0.0f);
    history[at] = vec4(0.0f);
    atomicAdd(control.broken_cells, 1u);
    atomicAdd(control.repaired_cells, 1u);
}
