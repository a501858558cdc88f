// The lee of plants: a carried number s that shortens the mixing length behind them.
//
//   ds/dt + u . grad s = a |du/dy| (1 - s) - c |u| s,   l = s l_free      s from 0.4 to 1, which is free air
//
// Plants break the eddies that come to them as they take their momentum, by c |u|; shear makes large ones again, at the rate of a
// shear layer. Without the lower bound a dense belt leaves a third less wind than is measured.
//
// A step carries e = 1 - s as the fourth component of the velocity, read by the same interpolation: 0 at inflow, in new cells, and
// wherever there are no plants. Implicit in both terms; an interpolation may leave its bounds a little, a step brings it back.
// Based on: Wilson 1985, Journal of Wind Engineering and Industrial Aerodynamics 21 (eddies behind a windbreak); Raupach & Shaw
// 1982, Boundary-Layer Meteorology 22 (what plants take of them).
#ifndef WINDROW_LEE_GLSL
#define WINDROW_LEE_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

const float WINDROW_DEEPEST_LEE = 0.6f; // most that e may be

// e after a step. `shear`: |du/dy| times the step; `broken`: c |u| times the step.
WINDROW_FN float windrow_lee(float lee, float shear, float broken) {
    float before = lee > 0.0f ? min(lee, WINDROW_DEEPEST_LEE) : 0.0f;
    return min((before + broken) / (1.0f + 0.2f * shear + broken), WINDROW_DEEPEST_LEE);
}

// Factor on the square of the mixing length at the face between two cells: s there is the lesser of theirs.
WINDROW_FN float windrow_lee_mixing(float low, float high) {
    float most = max(low, high), left = 1.0f - (most > 0.0f ? min(most, WINDROW_DEEPEST_LEE) : 0.0f);
    return left * left;
}

#endif
