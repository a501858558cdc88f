// The outer wind around the box (numerics/levels.glsl): D and p of the padded box's cells, which the host writes behind the gust
// tile: at the tick's start and at its end, in turns. Passes of a wind without one hold no code for it.
#include "numerics/levels.glsl"

layout(constant_id = 10) const bool k_outer = false;

const int k_tile_texels = 128 * 16 * 128;

// Of a cell of the box or its halo, `time` [s] after the tick's start. Between ticks the start is now.
vec4 outer_at(ivec3 cell, float time) {
    const ivec3 size = tick.cells + WINDROW_HALO, place = cell + WINDROW_HALO_LOW;
    const int field = size.x * size.y * size.z, at = k_tile_texels + (place.z * size.y + place.y) * size.x + place.x;
    const int start = is_on(WINDROW_OUTER_TURNED) ? field : 0;
    if (!(tick.duration > 0.0f))
        return tile_texels[at + start];
    return windrow_outer_between(tile_texels[at + start], tile_texels[at + field - start],
                                 clamp(time / tick.duration, 0.0f, 1.0f));
}

// [m/s] The wind around the box there: `ambient` and D.
vec3 around_at(ivec3 cell, float time, vec3 ambient) { return k_outer ? ambient + outer_at(cell, time).xyz : ambient; }

// [m/s^2] dp over an axis, one-sided where the halo ends.
float outer_slope(ivec3 cell, int axis, float time) {
    ivec3 low = cell, high = cell;
    low[axis] = max(cell[axis] - 1, -WINDROW_HALO_LOW);
    high[axis] = min(cell[axis] + 1, tick.cells[axis] + WINDROW_HALO - WINDROW_HALO_LOW - 1);
    const float apart = axis == 1 ? row_height(high.y) - row_height(low.y) : tick.cell_size * float(high[axis] - low[axis]);
    return windrow_outer_slope(outer_at(low, time).w, outer_at(high, time).w, apart);
}

#ifndef WINDROW_BETWEEN_TICKS
// [m/s] Carried by a cell of the halo, where the ambient wind carries `ambient`.
vec3 outer_carried(ivec3 cell, vec3 ambient) {
    const float departs = windrow_outer_departs(WINDROW_OF_PLAN.substep_duration, has_past());
    vec3 u = ambient + outer_at(cell, elapsed()).xyz;
    for (int axis = 0; axis < 3; ++axis)
        u[axis] -= departs * outer_slope(cell, axis, elapsed());
    return u;
}

float end_of_substep() { return elapsed() + WINDROW_OF_PLAN.substep_duration; }

// Whether the neighbour of a cell at the low (0) or high (1) end of an axis is beyond an open boundary.
bool is_beyond_open(ivec3 cell, int axis, int end) {
    return cell[axis] == end * (tick.cells[axis] - 1) && (end == 0 ? tick.potential_low : tick.potential_high)[axis] == 0.0f;
}

ivec3 ghost_of(ivec3 cell, int axis, int end) {
    cell[axis] += 2 * end - 1;
    return cell;
}

// What a central difference has of the ghost's value.
float of_ghost(ivec3 cell, int axis, int end) { return (end == 0 ? -0.5f : 0.5f) * (axis == 1 ? row_scale(cell.y) : 1.0f); }

float outer_factor() { return windrow_outer_factor(WINDROW_OF_PLAN.substep_duration, has_past()); }

float outer_potential(ivec3 ghost) {
    return windrow_outer_potential(outer_at(ghost, end_of_substep()).w, outer_factor(), tick.cell_size);
}

// What the right-hand side of a cell at open boundaries has of the wind and the pressure beyond them; of another cell 0.
float outer_right_side(ivec3 cell) {
    float sum = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            if (!is_beyond_open(cell, axis, end))
                continue;
            const ivec3 ghost = ghost_of(cell, axis, end);
            const float time = end_of_substep(), factor = outer_factor();
            const float rise = windrow_outer_pushed(outer_at(ghost, time)[axis], factor, outer_slope(ghost, axis, time)) -
                               windrow_outer_pushed(outer_at(cell, time)[axis], factor, outer_slope(cell, axis, time));
            sum += of_ghost(cell, axis, end) * rise - exchange(cell, axis, end) * outer_potential(ghost);
        }
    return sum;
}

// What the gradient of phi there has of it.
vec3 outer_gradient(ivec3 cell) {
    vec3 slope = vec3(0.0f);
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            if (is_beyond_open(cell, axis, end))
                slope[axis] += of_ghost(cell, axis, end) * outer_potential(ghost_of(cell, axis, end));
    return slope;
}
#endif
