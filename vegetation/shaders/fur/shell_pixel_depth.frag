// The depth of what shell_pixel.frag shows.
#version 460
#extension GL_GOOGLE_include_directive : require
#define COAT_WIND_AT_PIXEL
#define WINDROW_SET 1
#include "shaders/coupling/windrow_plants.glsl"
#include "../render/frame.glsl"
#include "coat.glsl"
#include "coat_places.glsl"
#include "shell_strand.glsl"
#include "shell_fragment.glsl"

void main() { shell_fragment(); }
