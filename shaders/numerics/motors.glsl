// Motors: what a region weighs at a point, and what a law does to the air there.
//
//   weight of a region   w = (1 - s^2)^2 for s < 1, else 0;  s = distance / radius
//   force                u += dt w f
//   drive                u += (1 - exp(-E)) (U - u),  E = k w dt;  several: E and E U add up before they act
//   wake                 the same with the path integral of w in place of w dt
//
// The kernel (1 - s^2)^2 is 1 at the centre, has slope 0 there and at the rim, is a polynomial in the squared distance (no
// root) and so has a path integral in closed form. Volume of a sphere's weight: 32 pi R^3 / 105.
// Based on: the biweight kernel of Tukey (Beaton & Tukey 1974, Technometrics 16).
#ifndef WINDROW_MOTORS_GLSL
#define WINDROW_MOTORS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// (1 - s^2)^2 from the squared relative distance.
WINDROW_FN float windrow_falloff(float squared) {
    float rest = max(1.0f - squared, 0.0f);
    return rest * rest;
}

// Ball of `radius` [m] about the origin; `p` [m] from its centre.
WINDROW_FN float windrow_sphere_weight(vec3 p, float radius) {
    return windrow_falloff(dot(p, p) / (radius * radius));
}

// All within `radius` of the segment from -half_axis to half_axis.
WINDROW_FN float windrow_capsule_weight(vec3 p, vec3 half_axis, float radius) {
    float length_squared = dot(half_axis, half_axis);
    float along = length_squared > 0.0f ? clamp(dot(p, half_axis) / length_squared, -1.0f, 1.0f) : 0.0f;
    vec3 off = p - along * half_axis;
    return windrow_falloff(dot(off, off) / (radius * radius));
}

// Axis-aligned box with `half_size` [m].
WINDROW_FN float windrow_box_weight(vec3 p, vec3 half_size) {
    vec3 s = p / half_size;
    return windrow_falloff(s.x * s.x) * windrow_falloff(s.y * s.y) * windrow_falloff(s.z * s.z);
}

// Integral of (a - t^2)^2 from 0 to t.
WINDROW_FN float windrow_falloff_primitive(float a, float t) {
    float t2 = t * t;
    return t * (a * a - t2 * (2.0f * a / 3.0f - t2 / 5.0f));
}

// Path integral [m] of a ball's weight at `p` while its centre moves straight from `start` to `end`: additive over pieces
// of the path, 0 for a path of length 0, so it depends neither on the frame rate nor on the speed.
WINDROW_FN float windrow_wake_path(vec3 p, vec3 start, vec3 end, float radius) {
    vec3 path = end - start;
    float length_squared = dot(path, path);
    if (!(length_squared > 0.0f))
        return 0.0f;
    float path_length = sqrt(length_squared);
    vec3 direction = path / path_length;
    vec3 from_start = p - start;
    float along = dot(from_start, direction);
    vec3 off = from_start - along * direction;
    float a = 1.0f - dot(off, off) / (radius * radius);
    if (a <= 0.0f)
        return 0.0f;
    float reach = sqrt(a);
    float first = clamp(-along / radius, -reach, reach);
    float last = clamp((path_length - along) / radius, -reach, reach);
    return radius * (windrow_falloff_primitive(a, last) - windrow_falloff_primitive(a, first));
}

// Velocity after drives of total exponent E toward a mean velocity `toward` = (sum E U) / E.
WINDROW_FN vec3 windrow_drive(vec3 u, vec3 toward, float exponent) {
    return u + (1.0f - exp(-exponent)) * (toward - u);
}

// How thin a region may be: in cells, as a radius. Below it, cells could fall between.
WINDROW_FN float windrow_widened(float radius, float cell_size) {
    return max(radius, 1.5f * cell_size);
}

#endif
