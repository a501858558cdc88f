// The air as combed noise: the mean of a noise along the streamline through each pixel, so that the streaks follow the wind; its speed
// as a colour. Based on: Cabral & Leedom 1993, Imaging vector fields using line integral convolution.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "coupling/windrow_wind.glsl"
#include "plane.glsl"

layout(location = 0) out vec4 colour;

const int k_steps = 16;      // each way
const float k_step = 0.055;  // [m]
const float k_grain = 0.05;  // [m] of the noise
const float k_fastest = 9.0; // [m/s] end of the colours

vec2 wind_at(vec2 p) { return windrow_velocity(vec3(p.x, 0.0, p.y)).xz; }

float noise_at(vec2 p) {
    uvec2 cell = uvec2(ivec2(floor(p / k_grain)) + 65536);
    uint bits = (cell.x * 2654435769u) ^ (cell.y * 2246822519u);
    bits = (bits ^ (bits >> 15u)) * 2654435769u;
    bits = (bits ^ (bits >> 14u)) * 2246822519u;
    return float((bits ^ (bits >> 16u)) >> 8u) / 16777216.0;
}

// Midpoint rule, in steps of one length: slow air has streaks as long as fast air.
float streak(vec2 from, float way) {
    float sum = 0.0;
    vec2 p = from;
    for (int n = 0; n < k_steps; ++n) {
        vec2 first = wind_at(p);
        vec2 middle = wind_at(p + 0.5 * way * k_step * first / max(length(first), 1e-3));
        p += way * k_step * middle / max(length(middle), 1e-3);
        sum += noise_at(p);
    }
    return sum;
}

vec3 colour_of(float speed) {
    const vec3 k_colours[6] = vec3[6](vec3(0.05, 0.07, 0.22), vec3(0.10, 0.24, 0.50), vec3(0.10, 0.46, 0.58),
                                      vec3(0.32, 0.66, 0.50), vec3(0.80, 0.80, 0.36), vec3(1.00, 0.93, 0.70));
    float t = 5.0 * clamp(speed / k_fastest, 0.0, 1.0);
    int low = min(int(t), 4);
    return mix(k_colours[low], k_colours[low + 1], t - float(low));
}

// [m] From a rectangle, negative within.
float from_rectangle(vec2 p, vec2 half_size) {
    vec2 d = abs(p) - half_size;
    return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}

void main() {
    vec2 place = (2.0 * gl_FragCoord.xy / plane.pixels - 1.0) * plane.half_size;
    float pixel = 2.0 * plane.half_size.x / plane.pixels.x;
    float combed = (noise_at(place) + streak(place, 1.0) + streak(place, -1.0)) / float(2 * k_steps + 1);
    float light = clamp(0.5 + 3.2 * (combed - 0.5), 0.0, 1.0);
    vec3 seen = colour_of(length(wind_at(place))) * mix(0.45, 1.25, light);

    // The corners of the box, and what stands in the air: roofs, with the shadow of a low sun.
    vec2 corner = plane.box_half - abs(place);
    float rim = abs(from_rectangle(place, plane.box_half));
    if (max(corner.x, corner.y) < 1.2)
        seen = mix(vec3(1.0), seen, smoothstep(0.5 * pixel, 2.0 * pixel, rim));
    float body = min(length(place - plane.tower.xy) - plane.tower.z, from_rectangle(place - plane.house.xy, plane.house.zw));
    seen *= mix(0.35, 1.0, smoothstep(0.0, 0.5, body));
    seen = mix(vec3(0.86, 0.83, 0.80), seen, smoothstep(-0.5 * pixel, 0.5 * pixel, body));
    seen = mix(vec3(0.30, 0.28, 0.28), seen, smoothstep(0.5 * pixel, 2.0 * pixel, abs(body + pixel)));
    colour = vec4(seen, 1.0);
}
