#version 300 es
// Speed or pressure in a slice, by colour.
#include "page.glsl"
#include "shaders/coupling/windrow_wind.glsl"
in vec3 position, within;
uniform sampler3D pressure;
uniform vec2 scale; // x [m/s] or [m2/s2] of the last colour; y 1: pressure
out vec4 colour;
// Dark blue, green, yellow: as bright as it is fast. A fit of viridis (Smith & van der Walt 2015) by three cosines.
vec3 ramp(float t) {
    vec3 low = vec3(0.27, 0.0, 0.33), middle = vec3(0.13, 0.57, 0.55), high = vec3(0.99, 0.91, 0.15);
    return t < 0.5 ? mix(low, middle, 2.0 * t) : mix(middle, high, 2.0 * t - 1.0);
}
void main() {
    if (scale.y > 0.5) {
        float p = texture(pressure, within).x / scale.x;
        colour = vec4(mix(vec3(0.95), p > 0.0 ? vec3(0.75, 0.1, 0.1) : vec3(0.1, 0.25, 0.8), clamp(abs(p), 0.0, 1.0)), 0.75);
    } else
        colour = vec4(ramp(clamp(length(windrow_velocity(position)) / scale.x, 0.0, 1.0)), 0.72);
}
