#version 300 es
// The patches of the meadow as a picture, once: what the ground would otherwise sum of eight noises in each pixel.
precision highp float;
precision highp int;
#include "shaders/numerics/place_noise.glsl"
in vec2 ndc;
out vec4 colour; // r how dry, g clump, b own chance, a grain
void main() {
    vec2 place = (0.5 + 0.5 * ndc) * 102.4 + 512.0;
    colour = vec4(windrow_dryness(place), windrow_place_noise(place / 2.3),
                  0.5 * (windrow_place_noise(place / 0.5) + windrow_place_noise(place / 31.0)),
                  0.6 * windrow_place_noise(place / 0.4) + 0.4 * windrow_place_noise(place / 1.1));
}
