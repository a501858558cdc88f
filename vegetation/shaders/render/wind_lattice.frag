// The colour of a speed; a slice leaves every other pixel to what lies behind it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "wind_lattice.glsl"
#include "../numerics/motion_vector.glsl"
#include "../numerics/speed_colour.glsl"

layout(location = 0) in vec3 shown;
layout(location = 1) in vec3 clip_now;
layout(location = 2) in vec3 clip_before;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (shown.z > 0.5 && ((pixel.x + pixel.y) & 1) == 1)
        discard;
    colour = vec4(windrow_speed_colour(shown.x / lattice.look.x) / frame.eye.w, 1.0); // as it is, whatever the exposure
    motion = windrow_motion_vector(clip_now, clip_before);
}
