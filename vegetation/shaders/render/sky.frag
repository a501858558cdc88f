// The sky behind everything, with the sun. It is endlessly far: only the camera's turn moves it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "sky_light.glsl"
#include "../numerics/motion_vector.glsl"

layout(constant_id = 0) const uint mapped = 1u;             // 0: each pixel works the clear sky out
layout(set = 2, binding = 0) uniform sampler2D sky_map;     // sky_map.frag
layout(set = 2, binding = 1) uniform sampler2D cloud_noise; // cloud_noise.comp
layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

void main() {
    vec3 direction = sky_direction(ndc);
    vec3 clear = mapped != 0u ? textureLod(sky_map, 0.5 * ndc + 0.5, 0.0).rgb : windrow_sky_radiance(frame.sky, direction);
    vec4 clouds = clouds_toward(cloud_noise, direction);
    vec3 radiance = clouds.rgb + clouds.a * (clear + windrow_sun_radiance(frame.sky, direction));
    colour = vec4(min(radiance, vec3(6e4)), 1.0); // what half floats hold
    motion = windrow_motion_vector((frame.view_projection * vec4(direction, 0.0)).xyw,
                                   (frame.view_projection_before * vec4(direction, 0.0)).xyw);
}
