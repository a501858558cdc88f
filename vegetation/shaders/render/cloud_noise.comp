// Fills the map of the clouds' octaves, by cells of their noise: sky_light.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#define NOISE_MAP_FILL
#include "../numerics/cloud_layer.glsl"
#include "noise_map.glsl"

layout(set = 0, binding = 0, rgba16f) writeonly uniform image2D map;

void main() {
    vec2 cell = noise_map_place(k_cloud_noise_texel);
    if (noise_map_is_wanted())
        imageStore(map, noise_map_texel(imageSize(map)), vec4(windrow_octaves(cell, 5), windrow_octaves(cell, 4), 0.0, 0.0));
}
