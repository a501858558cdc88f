// Values for cells that a shift of the box exposes. Before this text: Velocity, History, SourceFlow and Before as `velocity`,
// `history`, `source_flow` and `before`.

// Whether the cell came into the box as that moved by `shift`.
bool is_exposed(ivec3 cell, ivec3 shift) {
    const ivec3 source = cell + shift;
    return any(lessThan(source, ivec3(0))) || !inside(source, tick.cells);
}

// `fields`: bits of WINDROW_PLACE.
void place(int at, int fields, vec4 value) {
    if ((fields & WINDROW_PLACE_AIR) != 0)
        velocity[now(at)] = value;
    if ((fields & WINDROW_PLACE_PAST) != 0) {
        velocity[ago(at)] = value;
        history[at] = vec4(0.0f);
    }
    if ((fields & WINDROW_PLACE_SOURCE_FLOW) != 0)
        source_flow[at] = vec4(0.0f);
    if ((fields & WINDROW_PLACE_BEFORE) != 0)
        before[at] = value;
}
