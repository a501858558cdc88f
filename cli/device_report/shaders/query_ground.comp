// The ground memory at the places of a buffer, now.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_GROUND_BINDING 2
#include "coupling/windrow_ground.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Places { vec4 places[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Grounds { vec4 grounds[]; };

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n < places.length())
        grounds[n] = windrow_ground(places[n].xyz);
}
