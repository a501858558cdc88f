// Solid things: set 2. The same layouts as in vegetation/render/solids.h and bodies.h.
#ifndef WINDROW_RENDER_SOLID_GLSL
#define WINDROW_RENDER_SOLID_GLSL

#include "frame.glsl"

struct SolidVertex {
    vec4 position; // w: its part of the body, whose places follow one another
    vec4 normal;
    vec4 colour;
};
struct SolidPlace {
    mat4 now;
    mat4 before;
};

layout(std430, set = 2, binding = 0) readonly buffer SolidVertices { SolidVertex solid_vertices[]; };
layout(std430, set = 2, binding = 1) readonly buffer SolidPlaces { SolidPlace solid_places[]; };

#endif
