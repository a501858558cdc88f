// Pressure history and extrapolation of a second-order step whose length may differ from the step before it.
//
//   s  = dt / dt_old, at most 2
//   R  = u - s q                                carried along trajectories in (1 + s) u - s u_old
//   q' = (1 - d/2) grad phi + (d/2) s q         kept for the next step; q = (dt/2) grad p
//   d  = max(s, 1/s) - 1, between 0.05 and 1    1 in the first step of a flow
//
// grad phi + s q is the pressure impulse of the whole step. d = 1 keeps half of it, the pressure at mid-step: the first step of
// a flow has no q to add, and is only rehearsed so. d = 0 keeps grad phi alone, the pressure at the end of the step, which is
// more accurate. But then an
// error of q changes its sign in every step, grows by s and is never damped: alternating steps of 1 and 2 create energy.
// The floor of 0.05 halves such an error within 14 equal steps and makes Taylor-Green vortices 0.6 % less accurate. Every d is
// of second order: the error of q is a gradient, and the projection removes it from the wind.
#ifndef WINDROW_HISTORY_GLSL
#define WINDROW_HISTORY_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

struct WindrowPast {
    float scale;  // s
    float weight; // of grad phi in q'
    float kept;   // of q in q'
};

// `ratio`: dt / dt_old, 0 without a past.
WINDROW_FN WindrowPast windrow_past(float ratio) {
    WindrowPast past;
    past.scale = min(ratio, 2.0f);
    float damping = ratio > 0.0f ? clamp(max(ratio, 1.0f / ratio) - 1.0f, 0.05f, 1.0f) : 1.0f;
    past.weight = 1.0f - 0.5f * damping;
    past.kept = 0.5f * damping * past.scale;
    return past;
}

// The first step of a flow has no past; a rehearsal of it, of which nothing else is kept, gives one. Not where air crosses more
// cells in a sub-step than its two winds tell of: `cfl` of all sub-steps.
WINDROW_FN bool windrow_rehearses(float cfl, int substeps) { return cfl <= 2.5f * float(substeps); }

#endif
