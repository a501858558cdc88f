// Near the eye soil between the roots; afar the meadow's own mean colour, since blades end before the terrain does, and the waves
// that gusts draw in it.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_SET 1
#include "shaders/coupling/windrow_plants.glsl"
#include "canopy_lean.glsl"
#include "grass_light.glsl"
#include "shading.glsl"
#include "terrain.glsl"
#include "../numerics/motion_vector.glsl"

layout(std140, set = 2, binding = 0) uniform Look { PlantLook look; };

layout(std430, set = 2, binding = 1) readonly buffer Grown { float grown_values[]; };
layout(std140, set = 2, binding = 2) uniform Class { WindrowBlade blade_class; };
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

void main() {
    vec2 place = position.xz - frame.terrain.xy;
    float grain = windrow_place_noise(place / 0.045) * 0.6 + windrow_place_noise(place / 0.013) * 0.4;
    float distance = length(position - frame.eye.xyz);
    vec3 n = normalize(normal);
    vec3 to_sun = frame.sky.sun.xyz;

    // Afar one looks across tips and sees no soil.
    vec2 extent = frame.terrain.z * vec2(frame.terrain_size.xy - 1);
    float stands = windrow_grid_at(0, WindrowGrid(grown_corners, extent / vec2(grown_corners - 1)), place);
    float grown = stands * smoothstep(0.25, 1.0, distance / look.size.y);
    float clump = windrow_place_noise(place / 2.3 + 11.0);
    float own = 0.25 + 0.25 * (windrow_place_noise(place / 0.5) + windrow_place_noise(place / 31.0 + 5.0));
    vec3 leaf = grass_albedo(look, k_seen_height, clump, own, windrow_dryness(place));
    vec3 soil = mix(look.soil.rgb, 0.5 * look.soil.rgb + 0.5 * look.root.rgb, stands) * mix(0.55, 1.25, grain);

    float lit = sun_fraction(position, n);
    vec3 to_eye = (frame.eye.xyz - position) / distance;
    vec3 sun = frame.sunlight.rgb * lit;
    float shade = grass_self_shade(look, k_seen_height), open = grass_open(look, k_seen_height);
    vec3 bare = soil * (0.318309886 * sun * (max(dot(n, to_sun), 0.0) * mix(1.0, grass_self_shade(look, 0.2), stands)) +
                        mix(0.7, look.root.w, stands) * windrow_around(n, frame.skylight.rgb, frame.groundlight.rgb));
    vec3 canopy = n;
    float gloss = 0.0;
    // As far as two points of the picture lie within a gust.
    float apart = max(length(dFdx(position)), length(dFdy(position)));
    if (look.size.w > 0.0 && grown > 0.0) {
        float gust = 12.0 / max(windrow_frame.ambient.gust_texels, 1e-6); // its main wavelength [m]
        float sharp = clamp(0.5 * gust / max(apart, 1e-3) - 0.5, 0.0, 1.0);
        // The grass that hides this point stands before it, some of it farther than other.
        vec3 hidden = vec3(to_eye.x, 0.0, to_eye.z) * (blade_class.size.x / max(to_eye.y, 2.0 * blade_class.size.x / gust));
        vec2 lean =
            0.5 * (canopy_lean(blade_class, position + 0.4 * hidden, sharp) + canopy_lean(blade_class, position + hidden, sharp));
        float afar = smoothstep(0.3, 1.0, distance / look.size.y);
        canopy = grass_canopy_normal(look, n, afar * lean);
        gloss = afar * grass_canopy_gloss(look, lean);
    }
    vec3 meadow = grass_radiance(look, leaf, grass_through(look, leaf, k_seen_height), canopy, to_sun, to_eye, sun * shade,
                                 frame.skylight.rgb * open, frame.groundlight.rgb * open, gloss);
    vec3 radiance = mix(bare, meadow, grown);
    colour = vec4(fogged(radiance, position), 1.0);
    motion = windrow_motion_vector(clip_now, clip_before);
}
