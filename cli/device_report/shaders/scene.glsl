// What the shaders of the meadow share. Positions [m] from the middle of the meadow.
#define WINDROW_BINDING 1
#include "coupling/windrow_plants.glsl"

layout(std140, set = 0, binding = 0) uniform Scene {
    mat4 view_projection;
    vec4 eye;    // w number of blades
    vec4 walker; // xyz feet; w 0: blades in a fan before the eye, else [m] half of the side of a square field
    WindrowBlade grass;
    // clang-format off
} scene;
// clang-format on

const vec3 k_to_sun = normalize(vec3(-0.62, 0.45, -0.60));
const vec3 k_sunlight = vec3(1.30, 1.14, 0.88), k_skylight = vec3(0.36, 0.47, 0.60);

vec3 sky_colour(vec3 direction) {
    vec3 sky = mix(vec3(0.76, 0.83, 0.88), vec3(0.12, 0.32, 0.68), 1.0 - exp(-4.0 * max(direction.y, 0.0)));
    return sky + vec3(0.7, 0.5, 0.26) * 0.5 * pow(max(dot(direction, k_to_sun), 0.0), 8.0);
}

// Air between the eye and p; none from above.
vec3 hazed(vec3 colour, vec3 p) {
    if (scene.walker.w > 0.0)
        return colour;
    vec3 ray = p - scene.eye.xyz;
    return mix(sky_colour(normalize(vec3(ray.x, 0.0, ray.z))), colour, exp(-pow(length(ray) / 70.0, 2.0)));
}
