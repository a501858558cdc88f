// The speed of the wind as colours: above from the side, through the walker, and below from above, a metre over the ground.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) in vec2 place;
layout(location = 0) out vec4 colour;

const float k_width = 24.0, k_height = 4.5, k_across = 9.0; // [m] of both slices; of the upper one; of the lower one
const float k_fastest = 9.0;                                // [m/s]

// Dark blue over green to yellow, even in lightness.
vec3 speed_colour(float share) {
    const vec3 k_stops[6] = vec3[](vec3(0.03, 0.02, 0.12), vec3(0.06, 0.10, 0.38), vec3(0.03, 0.30, 0.42), vec3(0.08, 0.52, 0.30),
                                   vec3(0.55, 0.72, 0.12), vec3(0.98, 0.92, 0.35));
    float at = 5.0 * clamp(share, 0.0, 1.0);
    int low = min(int(at), 4);
    return mix(k_stops[low], k_stops[low + 1], at - float(low));
}

void main() {
    const float k_gap = 0.006; // between the two
    float x = scene.walker.x + k_width * (place.x - 0.5);
    const float k_share = k_height / (k_height + k_across); // of the picture: a metre is as long in both
    bool side = place.y < k_share;
    vec3 p = side ? vec3(x, k_height * (1.0 - place.y / k_share), scene.walker.z)
                  : vec3(x, 1.0, scene.walker.z - 1.0 + k_across * ((place.y - k_share) / (1.0 - k_share) - 0.5));
    vec3 u = windrow_velocity(p);
    vec3 paint = speed_colour(length(u) / k_fastest);
    // Each metre per second a thin line, as on a map.
    float speed = length(u);
    float line = abs(fract(speed + 0.5) - 0.5) / max(fwidth(speed), 1e-4);
    paint *= mix(0.78, 1.0, smoothstep(0.3, 1.1, line));
    // The walker: a capsule of 1.7 m.
    vec2 from = side ? vec2(p.x - scene.walker.x, p.y) : vec2(p.x - scene.walker.x, p.z - scene.walker.z);
    float body = side ? length(vec2(from.x, from.y - clamp(from.y, 0.25, 1.45))) - 0.25 : length(from) - 0.25;
    paint = mix(vec3(0.95), paint, smoothstep(0.0, 0.03, body));
    colour = vec4(abs(place.y - k_share) < k_gap ? vec3(1.0) : paint, 1.0);
}
