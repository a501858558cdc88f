// Advection along trajectories, then the half of forces, drives and drag at arrival (splitting.glsl):
//
//   x0 = x - dt u(x),  xd = x - dt/2 (u(x) + V(x0)),  w(x) = R(xd) + v . grad A + (dt/2) f
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 9
#include "fluid/pass.glsl"
#include "numerics/transport.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) readonly buffer Padded { vec4 padded[]; }; // R of all cells, then V, then A (pad.comp)
layout(std430, set = 0, binding = 4) readonly buffer Force { vec4 force[]; };
layout(std430, set = 0, binding = 5) readonly buffer Drives { vec4 drives[]; };
layout(std430, set = 0, binding = 6) readonly buffer History { vec4 history[]; };
layout(std430, set = 0, binding = 7) readonly buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Arrived { vec4 arrived[]; };
layout(std430, set = 0, binding = 11) readonly buffer Drag { float drag[]; };
#define WINDROW_SOLIDS 10
#include "fluid/prescribed.glsl"
#include "fluid/ghosts.glsl"
#include "fluid/hold.glsl"

layout(constant_id = 3) const bool k_one_sided = false; // bodies may be sub-grid, or rooms closed

ivec3 strides() {
    const int row = tick.cells.x + WINDROW_HALO;
    return ivec3(1, row, row * (tick.cells.y + WINDROW_HALO));
}

// The padded cell below a displaced one, and the distance from its centre. A periodic axis wraps, or ends at its last centres.
int locate(ivec3 cell, vec3 displacement, ivec3 stride, bool wraps, out vec3 fraction) {
    int offset = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const bool ends = !wraps && tick.period[axis] != 0.0f;
        const WindrowPlace place = windrow_place(float(cell[axis]), displacement[axis], ends ? 0.0f : tick.low[axis],
                                                 ends ? float(tick.cells[axis] - 1) : tick.high[axis],
                                                 ends ? 0.0f : tick.period[axis], ends ? 0.0f : tick.inverse_period[axis]);
        fraction[axis] = place.fraction;
        offset += (int(place.base) + WINDROW_HALO_LOW) * stride[axis];
    }
    return offset;
}

#include "fluid/one_sided.glsl"

vec3 lerp(vec3 a, vec3 b, float t) { return a + t * (b - a); }

vec3 read(int at) { return padded[at].xyz; }

vec3 sample_linear(int at, vec3 t, ivec3 s) {
    vec3 ends[2];
    for (int i = 0; i < 2; ++i) {
        const int line = at + i;
        const vec3 near = lerp(read(line), read(line + s.z), t.z);
        const vec3 over = lerp(read(line + s.y), read(line + s.y + s.z), t.z);
        ends[i] = lerp(near, over, t.y);
    }
    return lerp(ends[0], ends[1], t.x);
}

vec3 sum_nodes(vec3 before, vec3 here, vec3 after, vec3 beyond, vec3 w) {
    return here + w.x * (before - here) + w.y * (after - here) + w.z * (beyond - here);
}

vec3 sample_cubic(int at, vec3 t, ivec3 s) {
    const vec3 wx = windrow_cubic_weights(t.x), wy = windrow_cubic_weights(t.y), wz = windrow_cubic_weights(t.z);
    const int corner = at - s.x - s.y - s.z;
    vec3 planes[4];
    for (int k = 0; k < 4; ++k) {
        vec3 rows[4];
        for (int j = 0; j < 4; ++j) {
            const int row = corner + j * s.y + k * s.z;
            rows[j] = sum_nodes(read(row), read(row + 1), read(row + 2), read(row + 3), wx);
        }
        planes[k] = sum_nodes(rows[0], rows[1], rows[2], rows[3], wy);
    }
    return sum_nodes(planes[0], planes[1], planes[2], planes[3], wz);
}

// Between two rows of cells along `along`, each interpolated along `across`.
vec3 row_between(int at, int across, float t) { return lerp(read(at), read(at + across), t); }

// What a cubic adds to a linear value. The weights sum to 0.
vec3 added_by_cubic(vec3 before, vec3 here, vec3 after, vec3 beyond, vec3 w, float t) {
    return w.x * (before - here) + (w.y - t) * (after - here) + w.z * (beyond - here);
}

// 32 of those cells: LLL + BLL + LBL + LLB (fluid/cpu/kernels/advect.inl, Cubic32).
vec3 sample_cubic_32(int at, vec3 t, ivec3 s) {
    const vec3 wx = windrow_cubic_weights(t.x), wy = windrow_cubic_weights(t.y), wz = windrow_cubic_weights(t.z);
    vec3 inner[4];
    for (int i = 0; i < 4; ++i) {
        const int from = at + i - 1;
        inner[i] = lerp(row_between(from, s.y, t.y), row_between(from + s.z, s.y, t.y), t.z);
    }
    vec3 ends[2];
    for (int i = 0; i < 2; ++i) {
        const int from = at + i;
        ends[i] = added_by_cubic(row_between(from - s.y, s.z, t.z), row_between(from, s.z, t.z),
                                 row_between(from + s.y, s.z, t.z), row_between(from + 2 * s.y, s.z, t.z), wy, t.y) +
                  added_by_cubic(row_between(from - s.z, s.y, t.y), row_between(from, s.y, t.y),
                                 row_between(from + s.z, s.y, t.y), row_between(from + 2 * s.z, s.y, t.y), wz, t.z);
    }
    return sum_nodes(inner[0], inner[1], inner[2], inner[3], wx) + lerp(ends[0], ends[1], t.x);
}

// The lee of plants, which is carried as the velocity is.
float sample_lee(int at, vec3 t, ivec3 s) {
    const bool linear = is_on(WINDROW_LINEAR);
    const vec3 wx = windrow_cubic_weights(t.x), wy = windrow_cubic_weights(t.y), wz = windrow_cubic_weights(t.z);
    const vec4 lx = vec4(0.0f, 1.0f - t.x, t.x, 0.0f), ly = vec4(0.0f, 1.0f - t.y, t.y, 0.0f),
               lz = vec4(0.0f, 1.0f - t.z, t.z, 0.0f);
    vec4 x = lx, y = ly, z = lz;
    if (!linear) {
        x = vec4(wx.x, 1.0f - wx.x - wx.y - wx.z, wx.y, wx.z);
        y = vec4(wy.x, 1.0f - wy.x - wy.y - wy.z, wy.y, wy.z);
        z = vec4(wz.x, 1.0f - wz.x - wz.y - wz.z, wz.y, wz.z);
    }
    float sum = 0.0f;
    if (is_on(WINDROW_CUBIC_32)) {
        for (int k = 0; k < 4; ++k)
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i) {
                    const float w = x[i] * ly[j] * lz[k] + lx[i] * ((y[j] - ly[j]) * lz[k] + ly[j] * (z[k] - lz[k]));
                    if (w != 0.0f)
                        sum += w * padded[at + (i - 1) * s.x + (j - 1) * s.y + (k - 1) * s.z].w;
                }
        return sum;
    }
    for (int k = linear ? 1 : 0; k < (linear ? 3 : 4); ++k)
        for (int j = linear ? 1 : 0; j < (linear ? 3 : 4); ++j)
            for (int i = linear ? 1 : 0; i < (linear ? 3 : 4); ++i)
                sum += x[i] * y[j] * z[k] * padded[at + (i - 1) * s.x + (j - 1) * s.y + (k - 1) * s.z].w;
    return sum;
}

// As a factor of the mean wind.
float bend_at(int at, float t, ivec3 s) {
    if (!is_on(WINDROW_PROFILE) || is_on(WINDROW_LINEAR))
        return 0.0f;
    return windrow_profile_bend(t, padded[at].w, padded[at + s.y].w);
}

// What the perturbation carries of the prescribed background wind, beside `w`, which was carried along `displacement` [cells]:
// fluid/cpu/kernels/advect.inl, carry_prescribed.
vec3 prescribed_carried(vec3 w, ivec3 cell, int at, vec3 displacement, ivec3 s) {
    vec3 v = w;
    if (is_on(WINDROW_HAS_SOURCE_FLOW))
        v += source_flow[at].xyz;
    const float square = dot(v, v), gusts = tick.gust_strength * tick.gust_strength;
    if (!(square > tick.sleep_speed * tick.sleep_speed))
        return vec3(0.0f);
    const int first = 2 * s.z * (tick.cells.z + WINDROW_HALO);
    vec3 t;
    int from = first + locate(cell, displacement, s, false, t);
    const vec3 departed = sample_linear(from, t, s) + bend_at(from, t.y, s) * tick.wind.mean.xyz;
    if (k_own_rows)
        v.y *= row_scale(cell.y);
    from = first + locate(cell, displacement + (WINDROW_OF_PLAN.substep_duration / tick.cell_size) * v, s, false, t);
    const vec3 own = sample_linear(from, t, s) + bend_at(from, t.y, s) * tick.wind.mean.xyz;
    const vec3 end = wind_at(cell, elapsed() + WINDROW_OF_PLAN.substep_duration, true);
    return departed - lerp(end, own, gusts / (gusts + square));
}

// The pressure's history, inside of bodies that of the air beside them.
vec3 history_of(ivec3 cell, int at) {
    const int record = record_at(cell);
    vec3 sum = vec3(0.0f);
    for (int n = 0; n < term_count(record); ++n) {
        const AirTerm term = term_of(cell, record, n);
        sum += term.weight * windrow_slipped(history[cell_index(term.cell)].xyz, term.normal, 0.0f);
    }
    return term_count(record) > 0 ? sum : history[at].xyz;
}

// Drives and drag act on the total wind.
vec3 held(vec3 w, ivec3 cell, int at) {
    const WindrowHold hold = hold_of(cell, at);
    if (!(hold.drives.w > 0.0f || hold.way > 0.0f))
        return w;
    const vec3 prescribed = prescribed_part(cell, at, elapsed() + WINDROW_OF_PLAN.substep_duration);
    const vec3 pressure = is_fresh() ? vec3(0.0f) : past().scale * history_of(cell, at);
    return windrow_held_arriving(w + prescribed, pressure, hold) - prescribed;
}

// The velocity that a trajectory begins with.
vec3 velocity_of(ivec3 cell) {
    const int at = cell_index(cell);
    vec3 u = velocity[now(at)].xyz;
    if (is_on(WINDROW_STABLE_FLUIDS) && is_on(WINDROW_PUSHES))
        u += WINDROW_OF_PLAN.substep_duration * force[at].xyz;
    return u;
}

// The same inside of bodies too: what advection brings there counts where a face is open in part.
vec3 departing_velocity(ivec3 cell) {
    const int record = record_at(cell);
    vec3 sum = vec3(0.0f);
    for (int n = 0; n < max(term_count(record), 1); ++n) {
        const AirTerm term = term_of(cell, record, n);
        sum += term.weight * windrow_slipped(velocity_of(term.cell), term.normal, term.wall);
    }
    return sum;
}

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (!inside(cell, tick.cells))
        return;
    if (cell == ivec3(0) && push.substep == 0) { // what is found from here on is of the next tick
        control.fastest_component = control.largest_force = control.nonfinite_cells = control.fastest_in_rows = 0u;
        for (int n = 3; n > 0; --n)
            control.left_before[n] = control.left_before[n - 1];
        control.left_before[0] = control.left_fastest;
        control.left_still = still_ticks();
        control.left_fastest = control.left_in_rows = control.left_apart = 0u;
    }
    const int at = cell_index(cell);
    const ivec3 stride = strides();
    const float dt = WINDROW_OF_PLAN.substep_duration;
    const bool classic = is_on(WINDROW_STABLE_FLUIDS);
    vec3 result;
    float lee = 0.0f;
    if (is_on(WINDROW_ADVECTS)) {
        vec3 u = departing_velocity(cell);
        if (k_own_rows) // the trace counts rows too
            u.y *= row_scale(cell.y);
        const float cells_per_speed = dt / tick.cell_size;
        const int traces = stride.z * (tick.cells.z + WINDROW_HALO);
        vec3 t;
        int from = locate(cell, -cells_per_speed * u, stride, true, t);
        const vec3 traced = sample_linear(traces + from, t, stride);
        const vec3 displacement = -0.5f * cells_per_speed * (u + traced);
        from = locate(cell, displacement, stride, true, t);
        result = is_on(WINDROW_LINEAR)     ? sample_linear(from, t, stride)
                 : is_on(WINDROW_CUBIC_32) ? sample_cubic_32(from, t, stride)
                                           : sample_cubic(from, t, stride);
        if (has_lee())
            lee = sample_lee(from, t, stride);
        if (is_on(WINDROW_GUSTS))
            result += prescribed_carried(result, cell, at, displacement, stride);
        if (k_one_sided && has_obstacles()) {
            const int byte = solid_byte(solid_number(cell));
            const bool room = (byte & WINDROW_BYTE_ROOM) != 0;
            if (room || is_beside_sub_grid(byte))
                result = one_sided_result(result, cell, u, room);
        }
    } else {
        const ivec3 place = cell + WINDROW_HALO_LOW;
        const int from = place.x + stride.y * place.y + stride.z * place.z;
        result = read(from);
        lee = padded[from].w;
    }
    if (!classic && is_on(WINDROW_PUSHES))
        result += 0.5f * dt * force[at].xyz;
    if (!classic && anything_holds())
        result = held(result, cell, at);
    arrived[at] = vec4(result, lee);
}
