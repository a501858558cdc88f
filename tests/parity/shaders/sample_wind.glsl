// An outside shader: asks for the wind at the places of a buffer.
#define WINDROW_BINDING 2
#include "coupling/windrow_wind.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Places { vec4 places[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Winds { vec4 winds[]; }; // now, before and felt of each place

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= places.length())
        return;
    vec3 p = places[n].xyz;
    vec3 u = windrow_velocity(p);
    winds[3 * n] = vec4(u, 0.0);
    winds[3 * n + 1] = vec4(windrow_velocity_previous(p), 0.0);
    winds[3 * n + 2] = vec4(windrow_apparent(u, p, vec3(0.0)), 0.0);
}
