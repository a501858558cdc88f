// Advection beside thin bodies and in closed rooms, as fluid/cpu/thin_advection.cpp: a trajectory slides along the closed faces
// that it meets, and a read takes the nodes of its own side. Before this text: Padded as `padded`, solids.glsl, locate().

// A point of a trajectory: the cell that holds it, and its distance from the first cell's centre, in cells.
struct Point {
    ivec3 cell;
    vec3 place;
};

const int k_most_crossings = 512;

// The cell of the box that a cell beyond it mirrors, repeats or continues.
int cell_within(int cell, int axis) {
    const int count = tick.cells[axis];
    if (cell >= 0 && cell < count)
        return cell;
    if (tick.period[axis] != 0.0f)
        return (cell % count + count) % count;
    const bool low = cell < 0;
    if ((low ? tick.velocity_low : tick.velocity_high)[axis] > 0.0f) // open
        return low ? 0 : count - 1;
    return clamp(low ? -1 - cell : 2 * count - 1 - cell, 0, count - 1);
}

// The number of the low cell of a face; -1 where there is none inside the box.
int face_between(ivec3 cell, int axis, int side) {
    ivec3 next = cell;
    next[axis] += side;
    for (int a = 0; a < 3; ++a) {
        cell[a] = cell_within(cell[a], a);
        next[a] = cell_within(next[a], a);
    }
    const int apart = next[axis] - cell[axis];
    if (apart == 0)
        return -1;
    const bool across = apart != 1 && apart != -1; // a periodic boundary
    const bool cell_is_low = across ? apart < 0 : apart > 0;
    return solid_number(cell_is_low ? cell : next);
}

bool closed_between(ivec3 cell, int axis, int side, bool room) {
    const int low = face_between(cell, axis, side);
    return low < 0 ? room : (solid_byte(low) >> axis & 1) != 0;
}

int padded_at(ivec3 cell, ivec3 stride) {
    for (int axis = 0; axis < 3; ++axis)
        cell[axis] = tick.period[axis] != 0.0f
                         ? cell_within(cell[axis], axis)
                         : clamp(cell[axis], -WINDROW_HALO_LOW, tick.cells[axis] + WINDROW_HALO - WINDROW_HALO_LOW - 1);
    cell += WINDROW_HALO_LOW;
    return cell.x + stride.y * cell.y + stride.z * cell.z;
}

// [m/s] Across a closed face of its body, less the prescribed wind's.
float wall_between(ivec3 cell, int axis, int side, bool room, ivec3 stride) {
    const int low = face_between(cell, axis, side);
    if (low < 0)
        return 0.0f;
    const int record = solid_record(solid_cell(low));
    const int n = record < 0 ? -1 : record_face(record, axis, 1);
    float speed = 0.0f;
    if (n >= 0) {
        const SolidFace face = solid_face(n);
        speed = face.wall / face.closed;
    }
    if (is_on(WINDROW_GUSTS) && !room)
        speed -= padded[2 * stride.z * (tick.cells.z + WINDROW_HALO) + padded_at(cell, stride)][axis];
    return speed;
}

// Of a node that a trace reads: along y it counts rows.
float trace_scale(int axis, ivec3 cell, bool traces) { return traces && axis == 1 ? row_scale(cell_within(cell.y, 1)) : 1.0f; }

vec3 legal_displacement(ivec3 from, vec3 displacement) {
    vec3 way;
    for (int axis = 0; axis < 3; ++axis) {
        way[axis] = min(max(displacement[axis], tick.low[axis] - float(from[axis])), tick.high[axis] - float(from[axis]));
        if (windrow_not_finite(way[axis]))
            way[axis] = 0.0f;
    }
    return way;
}

Point careful_walk(ivec3 from, vec3 displacement, bool room, inout bool stopped) {
    vec3 left = legal_displacement(from, displacement);
    Point at;
    at.cell = from;
    at.place = vec3(0.0f);
    for (int crossed = 0; crossed < k_most_crossings; ++crossed) {
        int axis = -1;
        float way = 1.0f;
        for (int a = 0; a < 3; ++a) {
            if (left[a] == 0.0f)
                continue;
            const float face = float(at.cell[a] - from[a]) + (left[a] > 0.0f ? 0.5f : -0.5f);
            const float part = (face - at.place[a]) / left[a];
            if (part < way) {
                way = part;
                axis = a;
            }
        }
        way = max(way, 0.0f);
        at.place += way * left;
        if (axis < 0)
            break;
        left *= 1.0f - way;
        if (left[axis] == 0.0f)
            continue;
        const int side = left[axis] > 0.0f ? 1 : -1;
        if (closed_between(at.cell, axis, side, room)) {
            stopped = true;
            left[axis] = 0.0f;
        } else {
            at.cell[axis] += side;
        }
    }
    return at;
}

Point straight_walk(ivec3 from, vec3 displacement) {
    Point at;
    at.place = legal_displacement(from, displacement);
    at.cell = from + ivec3(floor(at.place + 0.5f));
    return at;
}

// Whether no face of the cells from `low` to `high` is closed, all in the box.
bool open_around(ivec3 low, ivec3 high) {
    if (any(lessThan(low, ivec3(0))) || any(greaterThanEqual(high, tick.cells)))
        return false;
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                if ((solid_byte(solid_number(ivec3(x, y, z))) & 7) != 0)
                    return false;
    return true;
}

// Nodes 0 to 3 in an order in which the own one, 1 or 2, comes first.
int outward(int own, int n) {
    return own == 0 ? (n == 0 ? 1 : n == 1 ? 2 : n == 2 ? 0 : 3) : (n == 0 ? 2 : n == 1 ? 1 : n == 2 ? 3 : 0);
}

// The field that begins at `field` at a point, by the nodes of its own side, or by all. `mixed` is set where one was on another.
vec3 careful_read(int field, ivec3 from, Point at, bool cubic, bool own_side, bool room, ivec3 stride, inout bool mixed) {
    const int first = cubic ? 0 : 1, end = cubic ? 4 : 3;
    const vec3 whole = floor(at.place), t = at.place - whole;
    const ivec3 base = from + ivec3(whole), own = clamp(at.cell - base, ivec3(0), ivec3(1));
    const bool open = !own_side || open_around(base + first - 1, base + end - 2);
    mat4x3 weights; // [node][axis]
    if (cubic) {
        const vec3 a = t - 1.0f, b = t - 2.0f, c = t + 1.0f;
        weights[0] = t * a * b * (-1.0f / 6.0f);
        weights[2] = c * t * b * -0.5f;
        weights[3] = c * t * a * (1.0f / 6.0f);
        weights[1] = 1.0f - (weights[0] + weights[2] + weights[3]);
    } else {
        weights[0] = weights[3] = vec3(0.0f);
        weights[1] = 1.0f - t;
        weights[2] = t;
    }
    vec3 values[64];
    uvec2 reached = uvec2(0u); // a bit a node: for an array of bools Mesa's compiler for AMD takes 24 GB and more than a minute
    const vec3 own_value = padded[field + padded_at(base + own, stride)].xyz;
    vec3 sum = vec3(0.0f); // about the own node's value, so that a uniform wind stays uniform
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                const ivec3 node = ivec3(outward(own.x, i), outward(own.y, j), outward(own.z, k));
                if (any(lessThan(node, ivec3(first))) || any(greaterThanEqual(node, ivec3(end))))
                    continue;
                const ivec3 cell = base + node - 1;
                bool here = open || node == own + 1;
                vec3 before_sum = vec3(0.0f);
                float count = 0.0f;
                for (int axis = 0; axis < 3 && !here; ++axis) {
                    const int away = node[axis] - (own[axis] + 1);
                    if (away == 0)
                        continue;
                    const int back = away > 0 ? -1 : 1;
                    ivec3 before = node;
                    before[axis] += back;
                    const int source = (before.z * 4 + before.y) * 4 + before.x;
                    const bool blocked = closed_between(cell, axis, back, room),
                               had = (reached[source >> 5] >> (source & 31) & 1u) != 0u;
                    here = had && !blocked;
                    before_sum += values[source];
                    if (had && blocked)
                        before_sum[axis] +=
                            2.0f * (trace_scale(axis, cell, field > 0) * wall_between(cell, axis, back, room, stride) -
                                    values[source][axis]);
                    count += 1.0f;
                }
                const int n = (node.z * 4 + node.y) * 4 + node.x;
                if (here)
                    reached[n >> 5] |= 1u << (n & 31);
                mixed = mixed || !here;
                const vec3 value = here ? padded[field + padded_at(cell, stride)].xyz : before_sum / count;
                values[n] = value;
                sum += weights[node.z].z * weights[node.y].y * weights[node.x].x * (value - own_value);
            }
    return own_value + sum;
}

// What replaces the result of the plain reads, `w`, which has its part of the prescribed wind already.
vec3 careful_result(vec3 w, ivec3 cell, vec3 u, bool room, ivec3 stride) {
    const int traces = stride.z * (tick.cells.z + WINDROW_HALO);
    const vec3 speed = control.substep_duration / tick.cell_size * u;
    const bool cubic = !is_on(WINDROW_LINEAR), gusts = is_on(WINDROW_GUSTS);
    bool mixed = false, ignored = false;
    const Point start = careful_walk(cell, -speed, room, mixed);
    const vec3 traced = careful_read(traces, cell, start, false, true, room, stride, mixed);
    const Point end = careful_walk(cell, -0.5f * (speed + control.substep_duration / tick.cell_size * traced), room, mixed);
    const vec3 value = careful_read(0, cell, end, cubic, true, room, stride, mixed);
    if (room || (mixed && !gusts))
        return value;
    if (!mixed)
        return w;
    const vec3 crossing_trace = careful_read(traces, cell, straight_walk(cell, -speed), false, false, false, stride, ignored);
    const vec3 crossing_way = -0.5f * (speed + control.substep_duration / tick.cell_size * crossing_trace);
    return w + value - careful_read(0, cell, straight_walk(cell, crossing_way), cubic, false, false, stride, ignored);
}

// Whether the reads of a cell may pass through a thin body, and whether it is air of a closed room.
bool is_beside_thin(int byte) {
    if (!is_on(WINDROW_THIN) || (byte & (WINDROW_BYTE_INSIDE | WINDROW_BYTE_ROOM)) != 0)
        return false;
    // As far as a trajectory of 1.5 times the largest speed and a cubic read come, as Solids::reach_past_thin.
    float fastest = uintBitsToFloat(k_own_rows ? control.fastest_in_rows : control.fastest_component);
    if (push.substep <= 0)
        fastest += tick.duration * uintBitsToFloat(control.largest_force) * (k_own_rows ? sqrt(rows[0].column) : 1.0f);
    const float cells = 1.5f * control.substep_duration / tick.cell_size * fastest;
    const int reach = int(min(ceil(max(cells, 0.5f)), 1000.0f)) + 2;
    const int from = byte >> WINDROW_BYTE_REACH_SHIFT;
    return reach > solids.farthest ? float(reach) > solids.thinnest : from > 0 && reach >= from;
}
