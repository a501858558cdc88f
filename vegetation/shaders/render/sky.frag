// The sky behind everything, with the sun. It is endlessly far: only the camera's turn moves it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "../numerics/motion_vector.glsl"

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

void main() {
    vec4 far = frame.from_clip * vec4(ndc, 1.0, 1.0);
    vec3 direction = normalize(far.xyz / far.w - frame.eye.xyz);
    vec3 radiance = windrow_sky_radiance(frame.sky, direction) + windrow_sun_radiance(frame.sky, direction);
    vec4 clouds = windrow_cloud_radiance(frame.clouds, frame.sky.sun.xyz, frame.eye.xyz, direction, frame.sunlight.rgb,
                                         0.318309886 * frame.skylight.rgb);
    radiance = clouds.rgb + clouds.a * radiance;
    colour = vec4(min(radiance, vec3(6e4)), 1.0); // what half floats hold
    motion = windrow_motion_vector((frame.view_projection * vec4(direction, 0.0)).xyw,
                                   (frame.view_projection_before * vec4(direction, 0.0)).xyw);
}
