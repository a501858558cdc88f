// Choice of the number of sub-steps: as many as keep the Courant number below its limit, or the maximal number with limited
// speeds. Where fewer are recorded, the remaining time is carried over to the next tick. The passes of a recorded sub-step that
// does not run get no work groups; the first one always runs.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"
#include "numerics/diffusion.glsl"
#include "numerics/substeps.glsl"

// How many passes a sub-step has, and the work groups of each; then those of each sub-step after the first.
layout(std430, set = 0, binding = 2) readonly buffer Shapes {
    uint passes;
    uint groups[];
};
layout(std430, set = 0, binding = 3) writeonly buffer Commands { uint commands[]; };

void main() {
    const float dt = tick.duration, h = tick.cell_size, max_cfl = tick.max_cfl;
    const float cfl = windrow_courant(uintBitsToFloat(control.fastest_component), uintBitsToFloat(control.largest_force), dt, h);
    const bool catches_up = control.carried_time > 0.0f;
    const float time = dt + control.carried_time; // [s] from where the air is to the tick's end
    const bool capped =
        is_on(WINDROW_ADVECTS) && windrow_wanted_substeps(cfl, max_cfl) > float(tick.max_substeps) && is_on(WINDROW_LIMITS);
    int substeps = 1;
    float part = time;
    if (tick.forced_substeps > 0) {
        substeps = tick.forced_substeps;
        part = time / float(substeps);
    } else if (is_on(WINDROW_ADVECTS)) {
        // Courant numbers of all this time, once speeds are cut.
        const float courant =
            min(catches_up ? cfl * (time / dt) : cfl, capped ? max_cfl * float(tick.max_substeps) * (time / dt) : 3.0e38f);
        substeps = windrow_substeps(windrow_wanted_substeps(courant, max_cfl), tick.recorded_substeps);
        part = courant > windrow_speed_rounding * max_cfl * float(substeps) ? time * (max_cfl / courant) : time / float(substeps);
    }
    barrier(); // all have read what the first now writes
    if (gl_GlobalInvocationID.x == 0) {
        float undiffused = control.undiffused_time;
        float least_square = h * h; // of the distance between two cells
        if (k_own_rows)
            least_square /= rows[0].column;
        if (is_on(WINDROW_DIFFUSES))
            for (int n = 0; n < substeps; ++n) {
                undiffused += part;
                const bool acts = tick.viscosity * undiffused / least_square >= windrow_least_diffusion;
                // A hair below the limit, which the ratio made of it must not pass (viscosity.glsl).
                const float most = is_on(WINDROW_ONE_PASS)
                                       ? 0.99999f * windrow_most_explicit_diffusion * least_square / tick.viscosity
                                       : undiffused;
                control.diffused_time[n] = acts ? min(undiffused, most) : 0.0f;
                undiffused -= control.diffused_time[n];
            }
        control.first_slot = slot_now();
        control.substeps = substeps;
        control.capped = capped ? 1 : 0;
        control.undiffused_time = undiffused;
        control.begin = -control.carried_time;
        control.carried_time = part * float(substeps) < 0.99999f * time ? time - part * float(substeps) : 0.0f;
        control.previous_duration = control.substep_duration;
        control.substep_duration = part;
        control.max_speed = capped ? windrow_fastest_carried(max_cfl, tick.max_substeps, h, dt) : 1.0e30f;
        control.cfl = cfl;
    }
    const uint entries = uint(tick.recorded_substeps - 1) * passes;
    for (uint n = gl_LocalInvocationIndex; n < entries; n += gl_WorkGroupSize.x) {
        const bool runs = 1u + n / passes < uint(substeps);
        for (uint axis = 0u; axis < 3u; ++axis)
            commands[3u * n + axis] = runs ? groups[3u * (n % passes) + axis] : 0u;
    }
}
