// What all passes of the page share: the frame's block, fog, the film's curve, the shadow map, heights.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;
precision highp sampler2DShadow;
#define WINDROW_ES
#define LEVELS 3

#include "vegetation/shaders/numerics/sky.glsl"
#include "vegetation/shaders/render/plant_look.glsl"

layout(std140) uniform Page {
    mat4 to_clip;
    mat4 from_clip;
    mat4 to_shadow;
    vec4 eye;         // xyz [m]; w exposure
    vec4 sunlight;    // rgb irradiance of the beam; w [1/m] density of the air's fog
    vec4 skylight;    // rgb; w [1/m] its fall with the height
    vec4 groundlight; // rgb; w 1: there are shadows
    WindrowSky sky;
    vec4 heights;     // xy [m] corner of the grid, zw [m] its extent; 0: level ground
    vec4 grid;        // xy corners of the grid, z [m] height of level ground, w 1: there is a memory of the ground
    vec4 level[LEVELS];  // x [m] between blades, y [m] from which they fade out, z to which, w factor of the width
    ivec4 base[LEVELS];  // xy lowest cell now, zw a frame ago
    ivec4 cells;      // x along a level's side, y rows of vertices near, z 1: blades go on from the frame before, w seed
    vec4 middle;      // xy [m] middle of the levels, z [m] radius of a pixel over its distance, w [s] time
    vec4 far;         // xy [m] middle of the hills, z from which they rise, w their height
    vec4 air[2];      // rgb the air's light near the horizon, under the sun and opposite
};

uniform sampler2D height_texels;
uniform sampler2DShadow shadow_map;
uniform sampler2D sky_map;

#define WINDROW_GRID sampler2D
float windrow_grid_value(sampler2D grid_texels, ivec2 corner, int across) { return texelFetch(grid_texels, corner, 0).x; }
#include "shaders/numerics/height_grid.glsl"
#include "shaders/numerics/place_noise.glsl"

// [m] Of the ground.
float ground_height(vec2 place) {
    if (heights.z > 0.0)
        return grid.z + windrow_grid_at(height_texels, WindrowGrid(ivec2(grid.xy), heights.zw / (grid.xy - 1.0)), place - heights.xy);
    return grid.z;
}

// Share of the sun's beam.
float sun_fraction(vec3 position) {
    if (groundlight.w < 0.5)
        return 1.0;
    vec3 at = 0.5 * (to_shadow * vec4(position, 1.0)).xyz + 0.5;
    if (any(lessThan(at.xy, vec2(0.002))) || any(greaterThan(at.xy, vec2(0.998))) || at.z > 1.0)
        return 1.0;
    float texel = 0.7 / 1024.0, z = at.z - 0.0015;
    return 0.25 * (texture(shadow_map, vec3(at.xy + texel * vec2(-1.0, -0.4), z)) + texture(shadow_map, vec3(at.xy + texel * vec2(0.4, -1.0), z)) +
                   texture(shadow_map, vec3(at.xy + texel * vec2(1.0, 0.4), z)) + texture(shadow_map, vec3(at.xy + texel * vec2(-0.4, 1.0), z)));
}

vec3 sky_of(vec3 direction) {
    float turn = atan(direction.z, direction.x) * 0.15915494 + 0.5;
    return textureLod(sky_map, vec2(turn, clamp(0.5 + 0.5 * sign(direction.y) * sqrt(abs(direction.y)), 0.504, 0.998)), 0.0).rgb;
}

// Light of the air before p, and the share of p's own that comes through (vegetation/shaders/render/air.glsl).
vec3 fogged(vec3 radiance, vec3 p) {
    vec3 ray = p - eye.xyz;
    float distance = length(ray);
    float rise = skylight.w * ray.y;
    float mean = abs(rise) < 1e-3 ? 1.0 - 0.5 * rise : (1.0 - exp(-rise)) / rise;
    float depth = sunlight.w * exp(-skylight.w * (eye.y - grid.z)) * distance * mean;
    float toward = 0.5 + 0.5 * dot(ray.xz, sky.sun.xz) * inversesqrt(max(dot(ray.xz, ray.xz) * dot(sky.sun.xz, sky.sun.xz), 1e-9));
    return mix(mix(air[1].rgb, air[0].rgb, toward * toward * toward), radiance, exp(-depth));
}

vec3 toned(vec3 radiance) {
    vec3 x = eye.w * radiance;
    vec3 film = clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
    // The screen's own curve, by roots: off by 0.007 at most above 0.001.
    vec3 root = sqrt(film), fourth = sqrt(root);
    return max(0.662002687 * root + 0.684122060 * fourth - 0.323583601 * sqrt(fourth) - 0.0225411470 * film, 0.0);
}
