// Choice of the number of sub-steps: as many as keep the Courant number below its limit, or the maximal number with limited
// speeds. The passes of a sub-step that does not run get no work groups.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"
#include "numerics/diffusion.glsl"

// Work groups of each pass, and how many passes a sub-step has; then what each of them is to run, sub-step by sub-step.
layout(std430, set = 0, binding = 2) readonly buffer Shapes {
    uint passes;
    uint groups[];
};
layout(std430, set = 0, binding = 3) writeonly buffer Commands { uint commands[]; };

void main() {
    const float dt = tick.duration, h = tick.cell_size, max_cfl = tick.max_cfl;
    const float fastest = uintBitsToFloat(control.fastest_component) + dt * uintBitsToFloat(control.largest_force);
    const float cfl = fastest * dt / h;
    int substeps = 1, most = tick.max_substeps;
    bool capped = false;
    if (is_on(WINDROW_ADVECTS) && cfl > max_cfl) {
        const float wanted = ceil(cfl / max_cfl);
        capped = wanted > float(most);
        substeps = capped ? most : int(wanted);
    }
    if (tick.forced_substeps > 0)
        substeps = tick.forced_substeps;
    if (gl_GlobalInvocationID.x == 0) {
        const float part = dt / float(substeps);
        float undiffused = is_on(WINDROW_DIFFUSED_WHOLE) ? 0.0f : control.undiffused_time;
        if (is_on(WINDROW_DIFFUSES))
            for (int n = 0; n < substeps; ++n) {
                undiffused += part;
                const bool acts = tick.viscosity * undiffused / (h * h) >= windrow_least_diffusion;
                // A hair below the limit, which the ratio made of it must not pass (viscosity.glsl).
                const float most =
                    is_on(WINDROW_ONE_PASS) ? 0.99999f * windrow_most_explicit_diffusion * h * h / tick.viscosity : undiffused;
                control.diffused_time[n] = acts ? min(undiffused, most) : 0.0f;
                undiffused -= control.diffused_time[n];
            }
        control.substeps = substeps;
        control.capped = capped ? 1 : 0;
        control.undiffused_time = undiffused;
        control.previous_duration = control.substep_duration;
        control.substep_duration = part;
        control.max_speed = max_cfl * float(substeps) * h / dt;
        control.cfl = cfl;
    }
    // The first pass of all is the cut of speeds, which runs only when more sub-steps were wanted.
    const uint entries = 1u + uint(most) * passes;
    for (uint n = gl_LocalInvocationIndex; n < entries; n += gl_WorkGroupSize.x) {
        const uint pass = n == 0u ? 0u : 1u + (n - 1u) % passes;
        const bool runs = n == 0u ? capped : (n - 1u) / passes < uint(substeps);
        for (uint axis = 0u; axis < 3u; ++axis)
            commands[3u * n + axis] = runs ? groups[3u * pass + axis] : 0u;
    }
}
