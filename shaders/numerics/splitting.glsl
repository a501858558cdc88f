// Drives and canopy drag in a second-order step: half of each at departure, half at arrival (Strang splitting).
//
//   departure   u -> C(D(u))
//   arrival     w' = D(C(w - s q)) + (1 - g^2) s q,   g = 1 - D's and C's damping factor
//
// D and C are the exact solutions of drive and drag over half a step. At arrival the pressure of that half is not known yet: the
// projection follows and subtracts all of it. So its prediction s q is subtracted before D and C, and added again after them.
// With g = 0 the two cancel. With g = 1 nothing is added, and the air has the speed of the drive. Adding all of it for any g
// grows without bound.
// Based on: Strang 1968, SIAM Journal on Numerical Analysis 5.
#ifndef WINDROW_SPLITTING_GLSL
#define WINDROW_SPLITTING_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "canopy.glsl"
#include "motors.glsl"

// Drives and canopy drag of a cell in a sub-step.
struct WindrowHold {
    vec4 drives; // (sum E U, E)
    float way;   // [s/m] of the canopy (canopy.glsl), over half a sub-step
};

// Part of the exponent E that acts at arrival; the rest acts at departure. It is E/2 while rate times dt is small and falls to 0
// for stiff drives, which have no second order to lose: held at arrival they overshot to 3.2 times their speed in a room 4 cells
// wide.
WINDROW_FN float windrow_arriving_exponent(float exponent) {
    float r = 0.25f * exponent;
    return 0.5f * exponent / (1.0f + r * r * r * r);
}

// u -> C(D(u)), at departure.
WINDROW_FN vec3 windrow_held_departing(vec3 u, WindrowHold hold) {
    if (hold.drives.w > 0.0f)
        u = windrow_driven(u, hold.drives, hold.drives.w - windrow_arriving_exponent(hold.drives.w));
    return windrow_canopy_slowed(u, hold.way);
}

// w -> w', at arrival; `pressure` [m/s] is s q.
WINDROW_FN vec3 windrow_held_arriving(vec3 arrived, vec3 pressure, WindrowHold hold) {
    vec3 free = arrived - pressure;
    if (!(hold.drives.w > 0.0f)) { // the same without exponentials
        float slowed = 1.0f / (1.0f + hold.way * length(free)), taken = 1.0f - slowed;
        return free / (1.0f + hold.way * length(free)) + (1.0f - taken * taken) * pressure;
    }
    float exponent = windrow_arriving_exponent(hold.drives.w);
    float kept = exp(-exponent) / (hold.way > 0.0f ? 1.0f + hold.way * length(free) : 1.0f);
    float lost = 1.0f - kept;
    return windrow_driven(windrow_canopy_slowed(free, hold.way), hold.drives, exponent) + (1.0f - lost * lost) * pressure;
}

#endif
