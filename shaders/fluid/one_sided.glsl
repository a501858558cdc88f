// One-sided reads beside sub-grid bodies and in closed rooms, in the cells of a device (numerics/one_sided.glsl). `air`: of a closed
// room. Before this text: Padded as `padded`, solids.glsl, strides().

#include "numerics/one_sided.glsl"

vec3 windrow_lowest(bool air) { return tick.low.xyz; }
vec3 windrow_highest(bool air) { return tick.high.xyz; }

int windrow_cell_within(bool air, int cell, int axis) {
    const int count = tick.cells[axis];
    if (cell >= 0 && cell < count)
        return cell;
    return windrow_cell_beyond(cell, count, tick.period[axis] != 0.0f,
                               (cell < 0 ? tick.velocity_low : tick.velocity_high)[axis] > 0.0f);
}

bool windrow_blocked(bool air, ivec3 low, int axis) { return low.x < 0 ? air : (solid_byte(solid_number(low)) >> axis & 1) != 0; }

int padded_at(ivec3 cell) {
    for (int axis = 0; axis < 3; ++axis)
        cell[axis] = tick.period[axis] != 0.0f
                         ? windrow_cell_within(false, cell[axis], axis)
                         : clamp(cell[axis], -WINDROW_HALO_LOW, tick.cells[axis] + WINDROW_HALO - WINDROW_HALO_LOW - 1);
    const ivec3 stride = strides();
    cell += WINDROW_HALO_LOW;
    return cell.x + stride.y * cell.y + stride.z * cell.z;
}

// What is carried, the first field, is the wind less the prescribed one. A trace is the whole wind, and counts rows along y.
float windrow_wall_across(WindrowSidedField field, ivec3 low, ivec3 cell, int axis) {
    if (low.x < 0)
        return 0.0f;
    const int record = solid_record(low);
    const int n = record < 0 ? -1 : record_face(record, axis, 1);
    float speed = 0.0f;
    if (n >= 0) {
        const SolidFace face = solid_face(n);
        speed = face.wall / face.closed;
    }
    const bool traces = field.first > 0;
    if (is_on(WINDROW_GUSTS) && !field.air && !traces)
        speed -= padded[2 * strides().z * (tick.cells.z + WINDROW_HALO) + padded_at(cell)][axis];
    return traces && axis == 1 ? row_scale(windrow_cell_within(false, cell.y, 1)) * speed : speed;
}

vec3 windrow_stored(WindrowSidedField field, ivec3 cell) { return padded[field.first + padded_at(cell)].xyz; }
bool windrow_is_velocity(WindrowSidedField field) { return true; }
bool windrow_is_clamped(WindrowSidedField field) { return false; }

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

// The field at a point, by the nodes of its own side, or by all. `mixed` is set where one was on another.
vec3 one_sided_read(WindrowSidedField field, ivec3 from, WindrowWaypoint at, bool cubic, bool own_side, inout bool mixed) {
    const WindrowNodes nodes = windrow_nodes(from, at, cubic, cubic && is_on(WINDROW_CUBIC_32));
    const ivec3 low = nodes.base + nodes.first - 1;
    return windrow_one_sided(field, nodes, !own_side || open_around(low, low + nodes.count - 1), mixed);
}

// What replaces the result of the plain reads, `w`, which has its part of the prescribed wind already.
vec3 one_sided_result(vec3 w, ivec3 cell, vec3 u, bool room) {
    const WindrowSidedField carried = WindrowSidedField(room, 0),
                            trace = WindrowSidedField(room, strides().z * (tick.cells.z + WINDROW_HALO));
    const float cells_per_speed = WINDROW_OF_PLAN.substep_duration / tick.cell_size;
    const vec3 speed = cells_per_speed * u;
    const bool cubic = !is_on(WINDROW_LINEAR), gusts = is_on(WINDROW_GUSTS);
    bool mixed = false, ignored = false;
    const vec3 traced = one_sided_read(trace, cell, windrow_slide(room, cell, -speed, mixed), false, true, mixed);
    const WindrowWaypoint end = windrow_slide(room, cell, -0.5f * (speed + cells_per_speed * traced), mixed);
    const vec3 value = one_sided_read(carried, cell, end, cubic, true, mixed);
    if (room || (mixed && !gusts))
        return value;
    if (!mixed)
        return w;
    const vec3 crossing_trace = one_sided_read(trace, cell, windrow_straight(room, cell, -speed), false, false, ignored);
    const WindrowWaypoint crossing = windrow_straight(room, cell, -0.5f * (speed + cells_per_speed * crossing_trace));
    return w + value - one_sided_read(carried, cell, crossing, cubic, false, ignored);
}

// Whether the reads of a cell may pass through a sub-grid body, and whether it is air of a closed room.
bool is_beside_sub_grid(int byte) {
    if (!is_on(WINDROW_THIN) || (byte & (WINDROW_BYTE_INSIDE | WINDROW_BYTE_ROOM)) != 0)
        return false;
    // As far as a trajectory of 1.5 times the largest speed and a cubic read come, as Solids::reach_past_thin.
    float fastest = uintBitsToFloat(k_own_rows ? control.plan.fastest_in_rows : control.plan.fastest_component);
    if (push.substep <= 0)
        fastest += tick.duration * uintBitsToFloat(control.plan.largest_force) * (k_own_rows ? sqrt(rows[0].column) : 1.0f);
    const float cells = 1.5f * WINDROW_OF_PLAN.substep_duration / tick.cell_size * fastest;
    const int reach = int(min(ceil(max(cells, 0.5f)), 1000.0f)) + 2;
    const int from = byte >> WINDROW_BYTE_REACH_SHIFT;
    return reach > solids.farthest ? float(reach) > solids.thinnest : from > 0 && reach >= from;
}
