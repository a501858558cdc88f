// The wind at the places of a buffer, now, by the texture unit's weights: what a sample costs.
#define WINDROW_BINDING 2
#include "coupling/windrow_wind.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Places { vec4 places[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Winds { vec4 winds[]; };

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n < places.length())
        winds[n] = vec4(windrow_velocity(places[n].xyz), 0.0);
}
