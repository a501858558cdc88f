// A lamp: a point of light beside the sun.
//
//   E = E_1 / d^2 (1 - (d / R)^4)^2, 0 beyond the reach R      [irradiance across the beam at distance d, E_1 at 1 m]
//
// Within a hundredth of its reach it is as bright as there: no pixel is infinite. Lights add: their sum is that of each alone.
// Based on: Karis 2013, Real shading in Unreal Engine 4 (the window that ends an inverse square).
#ifndef WINDROW_LAMP_GLSL
#define WINDROW_LAMP_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// Irradiance over that at 1 m, for an offset [m] from the point to the lamp.
WINDROW_FN float windrow_lamp_fraction(vec3 offset, float reach) {
    float square = dot(offset, offset);
    float share = square / (reach * reach);
    float window = max(1.0f - share * share, 0.0f);
    return window * window / max(square, 1e-4f * reach * reach);
}

#endif
