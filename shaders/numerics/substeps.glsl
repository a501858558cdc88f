// Number of sub-steps: as many as keep the Courant number below its limit, or the most with limited speeds.
//
//   CFL = (u + dt f) dt / h          u, f the largest components
//   n   = ceil(CFL / max_cfl)        at least 1
//   u  <= max_cfl n_most h / dt      where n is above n_most
#ifndef WINDROW_SUBSTEPS_GLSL
#define WINDROW_SUBSTEPS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

const float windrow_speed_rounding = 1.00001f; // of a speed that was limited and advected

WINDROW_FN float windrow_courant(float speed, float force, float dt, float cell_size) {
    return (speed + dt * force) * dt / cell_size;
}

WINDROW_FN float windrow_wanted_substeps(float courant, float max_cfl) { return max(ceil(courant / max_cfl), 1.0f); }

// What is not a number is limited as the fastest air is.
WINDROW_FN int windrow_substeps(float wanted, int most) { return wanted < float(most) ? max(int(wanted), 1) : most; }

// [m/s] Speed that the most sub-steps carry.
WINDROW_FN float windrow_fastest_carried(float max_cfl, int most, float cell_size, float dt) {
    return max_cfl * float(most) * cell_size / dt;
}

#endif
