// The air between the eye and a point.
#ifndef WINDROW_RENDER_AIR_GLSL
#define WINDROW_RENDER_AIR_GLSL

#include "frame.glsl"

// rgb the light of the air before p, w share of its own light that comes through. Density falls upward as exp(-fall * height),
// integrated along the ray; what the air scatters in has the colour of the sky near the horizon there. Based on: Wenzel 2006,
// Real-time atmospheric effects in games (height fog in closed form).
vec4 air_before(vec3 p) {
    vec3 ray = p - frame.eye.xyz;
    float distance = length(ray);
    float fall = frame.skylight.w;
    float rise = fall * ray.y;
    float mean = abs(rise) < 1e-3 ? 1.0 - 0.5 * rise : (1.0 - exp(-rise)) / rise;
    float depth = frame.sunlight.w * exp(-fall * (frame.eye.y - frame.groundlight.w)) * distance * mean;
    vec3 level = normalize(vec3(ray.x, max(0.06 * length(ray.xz), ray.y), ray.z));
    return vec4(windrow_sky_radiance(frame.sky, level), exp(-depth));
}

#endif
