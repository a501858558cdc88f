// The diffusion of a sub-step.
#include "numerics/diffusion.glsl"

// 0 where the sub-step is too short: its time is added to a later one.
float diffusion_ratio() { return tick.viscosity * control.diffused_time[substep()] / (tick.cell_size * tick.cell_size); }

// By the least distance between two cells.
bool is_implicit() {
    const float ratio = diffusion_ratio();
    return (k_own_rows ? ratio * rows[0].column : ratio) > windrow_most_explicit_diffusion;
}

// [m/s] The wind that diffusion leaves as it is: what is solved far from all walls.
vec3 still_wind() { return is_on(WINDROW_GUSTS) ? vec3(0.0f) : tick.ambient; }
