// What holds the air of a cell, drives and plants, over a step of second order.
//
// Each half of the step begins or ends with it, u' = D(C(u)) at the end and C(D(u)) at the start, as Strang's splitting has it.
// Between lie transport and pressure, and the pressure of the end is known only by the projection, which comes last and takes all
// of it. So its predicted half, s q, is taken before the air is held and given back after it:
//
//   w' = D(C(w - s q)) + (1 - g^2) s q,   g = 1 - the share of its velocity that the air keeps
//
// Where nothing holds the air the two are one; where it is held fast, g = 1, nothing is given back, and the air has the speed that
// it is held at. Giving back all of it grows without bound there.
// Based on: Strang 1968, SIAM Journal on Numerical Analysis 5.
#ifndef WINDROW_SPLITTING_GLSL
#define WINDROW_SPLITTING_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "canopy.glsl"
#include "motors.glsl"

// A sub-step's hold on a cell.
struct WindrowHold {
    vec4 drives; // (sum E U, E)
    float way;   // [s/m] of plants (canopy.glsl), of half of it
};

// E of the half at arrival; the rest acts at departure. Where a step is long for the drive it acts whole at departure: what it
// holds there so fast has no second order to lose, and held at arrival it drives narrow rooms to three times its own speed.
WINDROW_FN float windrow_arriving_exponent(float exponent) {
    float r = 0.25f * exponent;
    return 0.5f * exponent / (1.0f + r * r * r * r);
}

// C(D(u)), at departure.
WINDROW_FN vec3 windrow_held_departing(vec3 u, WindrowHold hold) {
    vec3 driven = windrow_driven(u, hold.drives, hold.drives.w - windrow_arriving_exponent(hold.drives.w));
    return windrow_canopy_slowed(driven, hold.way);
}

// w', from what arrives and the pressure's predicted half `pressure` [m/s].
WINDROW_FN vec3 windrow_held_arriving(vec3 arrived, vec3 pressure, WindrowHold hold) {
    vec3 free = arrived - pressure;
    float exponent = windrow_arriving_exponent(hold.drives.w);
    float kept = exp(-exponent) / (hold.way > 0.0f ? 1.0f + hold.way * length(free) : 1.0f);
    float lost = 1.0f - kept;
    return windrow_driven(windrow_canopy_slowed(free, hold.way), hold.drives, exponent) + (1.0f - lost * lost) * pressure;
}

#endif
