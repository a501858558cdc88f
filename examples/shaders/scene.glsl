// What every shader of the example is told, as push constants: 128 bytes, which every device has. Positions [m] from the anchor.
layout(push_constant) uniform Scene {
    mat4 view_projection;
    vec4 eye;      // w blades of grass
    vec4 walker;   // xyz his feet, w [rad] where he heads, from x toward z
    vec4 fan;      // xyz its hub, w [rad] how far its rotor has turned
    vec4 fan_axis; // xyz where it blows, w [m] its radius
    // clang-format off
} scene;
// clang-format on

const vec3 k_to_sun = normalize(vec3(-0.62, 0.40, -0.67));
const vec3 k_sunlight = vec3(1.35, 1.16, 0.86);
const vec3 k_skylight = vec3(0.36, 0.48, 0.62);

vec3 sky_colour(vec3 direction) {
    float up = max(direction.y, 0.0);
    vec3 sky = mix(vec3(0.78, 0.84, 0.87), vec3(0.10, 0.30, 0.68), 1.0 - exp(-4.5 * up));
    float toward = max(dot(direction, k_to_sun), 0.0);
    return sky + vec3(0.75, 0.52, 0.26) * (0.45 * pow(toward, 8.0) + 0.9 * pow(toward, 160.0)) + step(0.9996, toward);
}

// Air between the eye and p: far things take the colour of the sky above the horizon.
vec3 hazed(vec3 colour, vec3 p) {
    vec3 ray = p - scene.eye.xyz;
    float distance = length(ray);
    return mix(sky_colour(normalize(vec3(ray.x, 0.0, ray.z))), colour, exp(-pow(distance / 62.0, 2.0)));
}

// A number from 0 to 1 that looks random; another one for each seed. The factor, 2^32 over the golden ratio, carries low bits up;
// shifts bring high bits down.
float random_of(uint seed) {
    const uint factor = 2654435769u;
    uint bits = (seed + 1u) * factor;
    bits = (bits ^ (bits >> 15u)) * factor;
    bits = (bits ^ (bits >> 14u)) * factor;
    return float((bits ^ (bits >> 16u)) >> 8u) / 16777216.0;
}
