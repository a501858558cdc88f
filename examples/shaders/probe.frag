// The wind at 80 x 45 places of the plane as floats, to compare with the CPU's: x, below it y, below it z.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "coupling/windrow_wind.glsl"
#include "plane.glsl"

layout(location = 0) out vec4 colour;

void main() {
    int component = int(gl_FragCoord.y) / 45;
    vec2 cell = vec2(gl_FragCoord.x, gl_FragCoord.y - float(45 * component)) / vec2(80.0, 45.0);
    vec2 p = (2.0 * cell - 1.0) * plane.half_size;
    colour = vec4(windrow_velocity(vec3(p.x, 0.0, p.y))[component]);
}
