// Near the eye soil between the roots; afar the meadow's own mean colour, since blades end before the terrain does, and the waves
// that gusts draw in it.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_SET 1
#include "shaders/coupling/windrow_plants.glsl"
#include "canopy_lean.glsl"
#include "grass_light.glsl"
#include "ground_map.glsl"
#include "shading.glsl"
#include "terrain.glsl"
#include "../numerics/motion_vector.glsl"

layout(std140, set = 2, binding = 0) uniform Look { PlantLook look; };

layout(std430, set = 2, binding = 1) readonly buffer Grown { float grown_values[]; };
layout(std140, set = 2, binding = 2) uniform Class { WindrowBlade blade_class; };
layout(set = 2, binding = 3) uniform sampler2D ground_map;
layout(push_constant) uniform Told { layout(offset = 8) ivec2 grown_corners; };

#define WINDROW_GRID int
float windrow_grid_value(int grid, ivec2 corner, int across) { return grown_values[corner.y * across + corner.x]; }
#include "shaders/numerics/height_grid.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 clip_now;
layout(location = 3) in vec3 clip_before;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

// Soil between the roots. `stands` 0 to 1, where grass grows.
vec3 bare_radiance(vec2 place, float stands, vec3 n, vec3 sun) {
    float grain = windrow_place_noise(place / 0.045) * 0.6 + windrow_place_noise(place / 0.013) * 0.4;
    vec3 soil = mix(look.soil.rgb, 0.5 * look.soil.rgb + 0.5 * look.root.rgb, stands) * mix(0.55, 1.25, grain);
    float shade = mix(1.0, grass_self_shade(look, 0.2), stands);
    return soil * (0.318309886 * sun * (max(dot(n, frame.sky.sun.xyz), 0.0) * shade) +
                   mix(0.7, look.root.w, stands) * windrow_around(n, frame.skylight.rgb, frame.groundlight.rgb));
}

// Grass that is too far to be drawn by blades. `apart` [m] between two points of the picture here.
vec3 meadow_radiance(vec2 place, vec3 n, vec3 sun, float distance, float apart) {
    bool held = noise_map_holds(ground_map, k_ground_texel, place, frame.eye.xz - frame.terrain.xy);
    vec3 noise = held ? noise_map_at(ground_map, k_ground_texel, place).rgb : ground_noise(place);
    vec3 leaf = grass_albedo(look, k_seen_height, noise.x, 0.25 + 0.5 * noise.y, noise.z);
    float shade = grass_self_shade(look, k_seen_height), open = grass_open(look, k_seen_height);
    vec3 to_eye = (frame.eye.xyz - position) / distance;
    vec3 canopy = n;
    float gloss = 0.0;
    if (look.size.w > 0.0) {
        float gust = 12.0 / max(windrow_frame.ambient.gust_texels, 1e-6); // its main wavelength [m]
        // As far as two points of the picture lie within a gust.
        float sharp = clamp(0.5 * gust / max(apart, 1e-3) - 0.5, 0.0, 1.0);
        // The grass that hides this point stands before it, some of it farther than other.
        vec3 hidden = vec3(to_eye.x, 0.0, to_eye.z) * (blade_class.size.x / max(to_eye.y, 2.0 * blade_class.size.x / gust));
        vec2 lean =
            0.5 * (canopy_lean(blade_class, position + 0.4 * hidden, sharp) + canopy_lean(blade_class, position + hidden, sharp));
        float afar = smoothstep(0.3, 1.0, distance / look.size.y);
        canopy = grass_canopy_normal(look, n, afar * lean);
        gloss = afar * grass_canopy_gloss(look, lean);
    }
    return grass_radiance(look, leaf, grass_through(look, leaf, k_seen_height), canopy, frame.sky.sun.xyz, to_eye, sun * shade,
                          frame.skylight.rgb * open, frame.groundlight.rgb * open, gloss);
}

void main() {
    vec2 extent = frame.terrain.z * vec2(frame.terrain_size.xy - 1);
    // At the edge a pixel's middle may lie beyond the ground, which only some of its samples see: the map is not filled there.
    vec2 place = clamp(position.xz - frame.terrain.xy, vec2(0.0), extent);
    float distance = length(position - frame.eye.xyz);
    vec3 n = normalize(normal);
    float apart = max(length(dFdx(position)), length(dFdy(position)));

    // Afar one looks across tips and sees no soil.
    float stands = windrow_grid_at(0, WindrowGrid(grown_corners, extent / vec2(grown_corners - 1)), place);
    float grown = stands * smoothstep(0.25, 1.0, distance / look.size.y);
    vec3 sun = frame.sunlight.rgb * sun_fraction(position, n);
    vec3 bare = vec3(0.0), meadow = vec3(0.0); // what is not seen is not worked out
    if (grown < 1.0)
        bare = bare_radiance(place, stands, n, sun);
    if (grown > 0.0)
        meadow = meadow_radiance(place, n, sun, distance, apart);
    colour = vec4(fogged(mix(bare, meadow, grown), position), 1.0);
    motion = windrow_motion_vector(clip_now, clip_before);
}
