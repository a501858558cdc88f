// The plan of a tick (planning.glsl), with how long each sub-step diffuses. The passes of a recorded sub-step that does not run get
// no work groups; the first one always runs. Left out where one sub-step is recorded, which does not diffuse.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"
#include "fluid/planning.glsl"

// How many passes a sub-step has, and the work groups of each; then those of each sub-step after the first.
layout(std430, set = 0, binding = 2) readonly buffer Shapes {
    uint passes;
    uint groups[];
};
layout(std430, set = 0, binding = 3) writeonly buffer Commands { uint commands[]; };

void main() {
    WindrowPlan plan = planned();
    barrier(); // all have read what the first now writes
    if (gl_GlobalInvocationID.x == 0) {
        const float h = tick.cell_size, part = plan.substep_duration;
        float undiffused = plan.undiffused_time;
        float least_square = h * h; // of the distance between two cells
        if (k_own_rows)
            least_square /= rows[0].column;
        if (is_on(WINDROW_DIFFUSES))
            for (int n = 0; n < plan.substeps; ++n) {
                undiffused += part;
                const bool acts = tick.viscosity * undiffused / least_square >= windrow_least_diffusion;
                // A hair below the limit, which the ratio made of it must not pass (viscosity.glsl).
                const float most = is_on(WINDROW_ONE_PASS)
                                       ? 0.99999f * windrow_most_explicit_diffusion * least_square / tick.viscosity
                                       : undiffused;
                control.diffused_time[n] = acts ? min(undiffused, most) : 0.0f;
                undiffused -= control.diffused_time[n];
            }
        plan.undiffused_time = undiffused;
        control.plan = plan;
        count_repaired(plan.nonfinite_cells);
    }
    const uint entries = uint(tick.recorded_substeps - 1) * passes;
    for (uint n = gl_LocalInvocationIndex; n < entries; n += gl_WorkGroupSize.x) {
        const bool runs = 1u + n / passes < uint(plan.substeps);
        for (uint axis = 0u; axis < 3u; ++axis)
            commands[3u * n + axis] = runs ? groups[3u * (n % passes) + axis] : 0u;
    }
}
