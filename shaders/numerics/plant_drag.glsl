// Bend of a stalk in a wind: drag against stiffness.
//
//   Ca = rho C_d w L^3 U^2 / (2 E I)                     Cauchy number: drag over what the stiffness bears; k U^2 with k of the
//                                                        host
//   theta'' = -Ca int_s^1 cos^2 theta' cos(theta' - theta) ds',   theta(0) = 0, theta'(1) = 0        s along the stalk over L
//
// theta is the angle from upright: drag acts along the normal, by the normal part U cos(theta) of the wind, and turns with the
// stalk. Tip angle T(Ca): Ca / 6 for small Ca (even load on a cantilever), pi/2 - O(1/Ca) for large; a rational function with
// both limits, fitted to the numerical solution: within 0.1 degrees over [1e-3, 1e3] and monotone beyond
// (tests/plants/elastica_test.cpp). The sharpness b of the shape (plant_masks.glsl) follows from T alone, so that a spring may
// carry the bend: with b the whole curve is within 0.5 % of L of the solution over the same range.
// What the stalk does not do by bending, a crown does by closing up: its load falls as (1 + U^2/U_r^2)^(V/2), V <= 0 its Vogel
// exponent. The wind along the stalk's axis, gravity and lift are left out.
// Based on: Luhar & Nepf 2011, Flow-induced reconfiguration of buoyant and flexible aquatic vegetation, eq. 4 without buoyancy;
// Gosselin, de Langre & Machado-Almeida 2010, Drag reduction of flexible plates by reconfiguration; Vogel 1989, Drag and
// reconfiguration of broad leaves in high winds.
#ifndef WINDROW_PLANT_DRAG_GLSL
#define WINDROW_PLANT_DRAG_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// What a wind meets. Usable in a std140 block; the same layout as windrow::DragBlock (coupling/drag.h).
struct WindrowDrag {
    vec4 load; // x [s2/m2] k = Ca / U^2; y Vogel exponent, 0 or below; z [m/s] U_r above 0; w [rad] most bend, pi/2 unless set
};

// Tip angle over pi/2 as a function of the Cauchy number, 0 or more; held at 1e6, where it is 1 within 1e-3.
WINDROW_FN float windrow_tip_fraction(float cauchy) {
    float c = min(cauchy, 1e6f);
    float rise = c * (0.1061032954f + c * (0.02558361462f + c * (0.0028873041f + c * 1.046902554e-5f)));
    float fall = 1.0f + c * (0.2411198872f + c * (0.05854303149f + c * (0.003269139167f + c * 1.046902554e-5f)));
    return rise / fall;
}

// Sharpness b of the shape whose tip has this share of pi/2; a spring may swing beyond 1. Held where Ca = 2400: the root of a
// stalk that is pressed flatter would bend within less than the four points of its integral see.
WINDROW_FN float windrow_sharpness(float tip_fraction) {
    float q = min(tip_fraction, 0.985f);
    return 0.157094423f * q * q * q / (1.0f - 0.957184039f * q * q);
}

// Cauchy number over U^2 [s2/m2] at a speed [m/s], for a plant `stiffness` times as stiff as its class.
WINDROW_FN float windrow_load_at(WindrowDrag drag, float speed, float stiffness) {
    float k = drag.load.x / stiffness;
    if (drag.load.y < 0.0f)
        k *= pow(1.0f + speed * speed / (drag.load.z * drag.load.z), 0.5f * drag.load.y);
    return k;
}

// [rad] The bend that a wind holds: direction of lean times the angle of the tip, at right angles to the axis of the stalk. `u`
// [m/s] is the apparent wind (windrow_felt of u minus the plant's own velocity). This is what a spring follows. 0 for what is not
// finite.
WINDROW_FN vec3 windrow_drag_bend(WindrowDrag drag, vec3 axis, vec3 u, float stiffness) {
    vec3 across = u - dot(u, axis) * axis;
    float square = dot(across, across);
    bool known = square <= 1e12f; // false for NaN and infinity
    square = known ? square : 0.0f;
    float speed = sqrt(square);
    float tip = 1.57079633f * windrow_tip_fraction(windrow_load_at(drag, speed, stiffness) * square);
    vec3 bend = across * (min(tip, drag.load.w) / max(speed, 1e-12f));
    return known ? bend : vec3(0.0f);
}

#endif
