// Radial weight of a foot, a hand or a wheel: 1 at its middle, (1 - r^2 / R^2)^2 within its radius R, 0 from
// there on. The slope is 0 at both ends, so that the edge of the push is invisible.
#ifndef WINDROW_RADIAL_GLSL
#define WINDROW_RADIAL_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// Of a distance r from the middle, `square` = r^2; radius in the same unit, 0 or more.
WINDROW_FN float windrow_radial_weight(float square, float radius) {
    float rest = max(1.0f - square / max(radius * radius, 1e-30f), 0.0f);
    return rest * rest;
}

#endif
