// Sine and cosine of turns, within 2e-7: a polynomial on a quarter turn, since a GPU's own sine may err by 5e-4.
#ifndef WINDROW_TURN_SINE_GLSL
#define WINDROW_TURN_SINE_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "stem.glsl"

// sin 2 pi x.
WINDROW_FN float windrow_turn_sine(float x) {
    float f = x - floor(x + 0.5f);
    float folded = 6.28318530718f * (abs(f) > 0.25f ? (f < 0.0f ? -0.5f : 0.5f) - f : f);
    return folded * windrow_sine_fraction(folded * folded);
}

// cos 2 pi x.
WINDROW_FN float windrow_turn_cosine(float x) { return windrow_turn_sine(x + 0.25f); }

#endif
