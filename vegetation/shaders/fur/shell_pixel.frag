// A layer's fragment whose strand leans in the wind at its own root, however few vertices the mesh has.
#version 460
#extension GL_GOOGLE_include_directive : require
#define COAT_WIND_AT_PIXEL
#define WINDROW_SET 1
#include "shaders/coupling/windrow_plants.glsl"
#include "shell_colour.glsl"
