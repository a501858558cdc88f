// Sources, guard and reduction: the effect of the motors on a cell, gathered from those that reach it; non-finite cells become
// ambient; the largest speed and force determine the sub-steps.
//
//   drives          E and E U summed over the motors; the classic split acts on u at once, u += (1 - exp(-E)) (U - u)
//   force           f = sum w f_m
//   volume source   S = sum w S0
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 10
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"
#include "numerics/canopy.glsl"
#include "numerics/motors.glsl"

layout(std430, set = 0, binding = 2) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Before { vec4 before[]; };
layout(std430, set = 0, binding = 4) buffer History { vec4 history[]; };
layout(std430, set = 0, binding = 5) writeonly buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 6) writeonly buffer Force { vec4 force[]; };
layout(std430, set = 0, binding = 7) writeonly buffer Drives { vec4 drives[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Expansion { float expansion[]; };
layout(std430, set = 0, binding = 9) readonly buffer Motors { WindrowMotor motors[]; };
layout(std430, set = 0, binding = 12) readonly buffer Drag { float drag[]; };

#define WINDROW_SOLIDS 11
#include "fluid/solids.glsl"
#include "fluid/exposed.glsl"
#include "fluid/guard.glsl"

shared uint group_largest;
shared uint group_force;
shared uint group_in_rows;

vec3 from(float v[3]) { return vec3(v[0], v[1], v[2]); }

// Weight of a motor in a cell, and its push there.
struct Effect {
    float weight;
    vec3 push;
};

Effect effect_at(int n, vec3 p) {
    const uint shape = motors[n].shape;
    const vec3 centre = from(motors[n].centre), extent = from(motors[n].extent);
    const float radius = motors[n].radius, end_radius = motors[n].end_radius;
    Effect effect;
    effect.push = vec3(0.0f);
    effect.weight = windrow_motor_weight(shape, motors[n].law, p, centre, extent, radius, end_radius);
    if (!(effect.weight > 0.0f))
        return effect;
    effect.push = windrow_motor_push(shape, p - centre, from(motors[n].push), extent, radius, end_radius, motors[n].lift);
    if (motors[n].eddies > 0.0f)
        effect.push += windrow_motor_eddies(shape, effect.weight, motors[n].eddies) *
                       windrow_tile_at(0, ivec3(0), from(motors[n].tile_place) + motors[n].texels * p);
    return effect;
}

Effect effect_in(int n, ivec3 cell) {
    vec3 p = centre_of(cell);
    if (!k_own_rows)
        return effect_at(n, p);
    const float low = 0.5f * (row_height(cell.y - 1) + row_height(cell.y)),
                thickness = 0.5f * (row_height(cell.y) + row_height(cell.y + 1)) - low;
    const int heights = windrow_motor_heights(motors[n].shape, from(motors[n].extent), motors[n].radius, motors[n].end_radius,
                                              thickness, tick.cell_size);
    if (heights == 1)
        return effect_at(n, p);
    Effect sum;
    sum.weight = 0.0f;
    sum.push = vec3(0.0f);
    for (int k = 0; k < heights; ++k) {
        p.y = low + thickness * ((float(k) + 0.5f) / float(heights));
        const Effect each = effect_at(n, p);
        sum.weight += each.weight;
        sum.push += each.weight * each.push;
    }
    if (sum.weight > 0.0f)
        sum.push /= sum.weight;
    sum.weight /= float(heights);
    return sum;
}

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (gl_LocalInvocationIndex == 0) {
        group_largest = 0;
        group_force = 0;
        group_in_rows = 0;
    }
    barrier();
    if (inside(cell, tick.cells)) {
        const int at = cell_index(cell);
        vec3 pushed = vec3(0.0f);
        vec4 driven = vec4(0.0f);
        float let_in = 0.0f;
        const int record = has_obstacles() ? solid_record(cell) : -1;
        const int motors_here = record_is(record, WINDROW_INSIDE) ? 0 : tick.motors; // they act on the air alone
        for (int n = 0; n < motors_here; ++n) {
            if (any(lessThan(cell, ivec3(motors[n].low[0], motors[n].low[1], motors[n].low[2]))) ||
                any(greaterThanEqual(cell, ivec3(motors[n].high[0], motors[n].high[1], motors[n].high[2]))))
                continue;
            const Effect effect = effect_in(n, cell);
            if (!(effect.weight > 0.0f))
                continue;
            const uint law = motors[n].law;
            if (law == windrow_force) {
                pushed += effect.weight * effect.push;
            } else if (law == windrow_drive) {
                const float exponent = effect.weight * motors[n].amount;
                driven += vec4(exponent * effect.push, exponent);
            } else {
                let_in += effect.weight * motors[n].amount;
            }
        }
        if (tick.exposes != 0 && is_exposed(cell, tick.shift)) {
            const bool ambient = tick.exposed_value == WINDROW_PLACE_AMBIENT;
            const vec3 wind = ambient ? wind_at(cell, elapsed(), is_on(WINDROW_GUSTS)) : vec3(0.0f);
            place(at, tick.exposes, vec4(around_at(cell, elapsed(), wind), 0.0f));
        }
        vec4 u = velocity[now(at)];
        if (is_on(WINDROW_KEEPS))
            before[at] = u;
        if (is_on(WINDROW_STABLE_FLUIDS)) {
            float way =
                tick.canopy_drag * tick.duration * windrow_canopy_fraction(float(cell.y), tick.canopy_ground, tick.canopy_top);
            if (is_on(WINDROW_DRAG))
                way += tick.duration * drag[at];
            u = vec4(windrow_canopy_slowed(windrow_driven(u.xyz, driven, driven.w), way), u.w);
            if (driven.w > 0.0f || way > 0.0f)
                velocity[now(at)] = u;
        }
        float fastest = 0.0f;
        if (!is_on(WINDROW_RENEWS_SOURCE_FLOW)) { // else once their flow is in the velocity
            if (broken(u)) {
                repair(cell, at, elapsed());
                u = velocity[now(at)];
            }
            fastest = largest_component(u.xyz);
            if (k_own_rows)
                atomicMax(group_in_rows, floatBitsToUint(largest_component(in_rows(u.xyz, cell.y))));
        }
        if (is_on(WINDROW_DRIVES) && !is_on(WINDROW_STABLE_FLUIDS)) {
            drives[at] = driven;
            if (driven.w > 0.0f && !broken(u))
                fastest = max(fastest, largest_component(windrow_driven(u.xyz, driven, driven.w)));
        }
        if (is_on(WINDROW_PUSHES))
            force[at] = vec4(pushed, 0.0f);
        if (is_on(WINDROW_EXPANDS))
            expansion[at] = let_in;
        atomicMax(group_largest, floatBitsToUint(fastest));
        atomicMax(group_force, floatBitsToUint(largest_component(pushed)));
    }
    barrier();
    if (gl_LocalInvocationIndex == 0) {
        atomicMax(control.fastest_component, group_largest);
        atomicMax(control.largest_force, group_force);
        if (k_own_rows)
            atomicMax(control.fastest_in_rows, group_in_rows);
    }
}
