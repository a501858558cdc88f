// Fills the map of the ground's noise: ground_map.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#define NOISE_MAP_FILL
#include "ground_map.glsl"

layout(set = 0, binding = 0, rgba8) writeonly uniform image2D map;

void main() {
    if (noise_map_is_wanted())
        imageStore(map, noise_map_texel(imageSize(map)), vec4(ground_noise(noise_map_place(k_ground_texel)), 0.0));
}
