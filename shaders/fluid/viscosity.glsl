// Which diffusion a sub-step asks for; fluid/cpu/diffusion.cpp.

// r = viscosity dt / h^2; 0 where the sub-step is too short for floats: its time is added to a later one.
float diffusion_ratio() { return tick.viscosity * control.diffused_time[substep()] / (tick.cell_size * tick.cell_size); }

bool is_implicit() { return diffusion_ratio() > 1.0f / 12.0f; }

// [m/s] The wind that diffusion leaves as it is: what is solved far from all walls.
vec3 still_wind() { return is_on(WINDROW_GUSTS) ? vec3(0.0f) : tick.ambient; }
