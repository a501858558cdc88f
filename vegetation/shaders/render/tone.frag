// From light to a picture: exposure, and a film's curve. Based on: Narkowicz 2015, ACES filmic tone mapping curve.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"

layout(set = 2, binding = 0) uniform sampler2D light;
layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 colour;

void main() {
    vec3 x = frame.eye.w * texelFetch(light, ivec2(gl_FragCoord.xy), 0).rgb;
    colour = vec4(clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0), 1.0);
}
