// What a step of second order takes from the step before it, whose length may be another.
//
// A step knows two winds, u and u_old, and q = (dt_old/2) grad p, the pressure's part of the last step's arrival half. With
// s = dt/dt_old it carries R = u - s q along trajectories in (1 + s) u - s u_old, projects what arrives, w - grad phi, and keeps
//
//   q' = (1 - d/2) grad phi + (d/2) s q
//
// grad phi + s q is the pressure's impulse of the whole step. Half of it, d = 1, is the pressure of the step's middle: what the
// first step of a flow keeps, which has no q to rely on. grad phi alone, d = 0, is the pressure at its end, which is more exact;
// but then what is wrong in q stays for good, turns its sign with each step and grows by s: steps of 1 and 2 in turn make energy
// of it. So d follows how unequal the steps are. It is 0.05 for equal ones: half of what a blast or a shift leaves is gone after 14
// steps, and Taylor-Green vortices are 0.6 % less exact. Any d is of second order: what it leaves in q is a gradient, which the
// projection takes out of the wind.
// s ends at 2: beyond, q says little of so much longer a step.
// Based on: Hairer & Wanner 1996, Solving Ordinary Differential Equations II, chapter VII (the undamped multiplier of the
// trapezoidal rule).
#ifndef WINDROW_HISTORY_GLSL
#define WINDROW_HISTORY_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

struct WindrowPast {
    float scale; // s
    float share; // of grad phi in q'
    float kept;  // of q in q'
};

// `ratio`: dt / dt_old, 0 without a past.
WINDROW_FN WindrowPast windrow_past(float ratio) {
    WindrowPast past;
    past.scale = min(ratio, 2.0f);
    float damping = ratio > 0.0f ? clamp(max(ratio, 1.0f / ratio) - 1.0f, 0.05f, 1.0f) : 1.0f;
    past.share = 1.0f - 0.5f * damping;
    past.kept = 0.5f * damping * past.scale;
    return past;
}

#endif
