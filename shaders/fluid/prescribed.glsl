// Prescribed background wind: the flow of the volume sources, and the ambient wind while it gusts.
// Before this text: Velocity as `velocity`, SourceFlow as `source_flow`, Force as `force`, WINDROW_SOLIDS as in solids.glsl.
#include "fluid/solids.glsl"

// Whether no wind is prescribed at a cell while it gusts: in closed rooms.
bool is_sheltered(ivec3 cell) { return has_rooms() && record_is(solid_record(cell), WINDROW_SHELTERED); }

// [m/s] Prescribed background wind of a cell, `elapsed` [s] after the start of the tick.
vec3 prescribed_part(ivec3 cell, int at, float elapsed) {
    vec3 u = vec3(0.0f);
    if (is_on(WINDROW_HAS_SOURCE_FLOW))
        u += source_flow[at].xyz;
    if (is_on(WINDROW_GUSTS) && !is_sheltered(cell))
        u += wind_at(cell, elapsed, true);
    return u;
}

// [m/s] What the step carries and projects of a cell.
vec3 solved_part(ivec3 cell, int at) {
    vec3 u = velocity[now(at)].xyz;
    if (is_on(WINDROW_STABLE_FLUIDS) && is_on(WINDROW_PUSHES)) // the classic split: forces act first, and whole
        u += WINDROW_OF_PLAN.substep_duration * force[at].xyz;
    if (is_on(WINDROW_HAS_SOURCE_FLOW))
        u -= source_flow[at].xyz;
    if (is_on(WINDROW_GUSTS) && !is_sheltered(cell))
        u -= wind_at(cell, elapsed(), true);
    return u;
}
