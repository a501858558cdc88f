// Light of the sky in a direction, without the sun's disk.
#ifndef WINDROW_RENDER_SKY_LIGHT_GLSL
#define WINDROW_RENDER_SKY_LIGHT_GLSL

#include "frame.glsl"
#include "noise_map.glsl"

// Toward a place of the picture, by its clip space over w. A unit vector.
vec3 sky_direction(vec2 ndc) {
    vec4 far = frame.from_clip * vec4(ndc, 1.0, 1.0);
    return normalize(far.xyz / far.w - frame.eye.xyz);
}

// Optical depth of the clouds' sheet straight up, at a place [m from the anchor]: by 5 octaves or by 4.
float sheet_depth(sampler2D noise, vec2 place, int octaves) {
    vec2 cell = windrow_cloud_cell(frame.clouds, place);
    if (!noise_map_holds(noise, k_cloud_noise_texel, cell, windrow_cloud_cell(frame.clouds, frame.eye.xz)))
        return windrow_cloud_depth_of(frame.clouds, cell, octaves);
    vec2 octaves_here = noise_map_at(noise, k_cloud_noise_texel, cell).rg;
    return windrow_cloud_depth_by(frame.clouds, octaves == 5 ? octaves_here.x : octaves_here.y);
}

// As windrow_cloud_radiance.
vec4 clouds_toward(sampler2D noise, vec3 direction) {
    vec3 eye = frame.eye.xyz, to_sun = frame.sky.sun.xyz;
    if (!windrow_cloud_seen(frame.clouds, eye, direction))
        return vec4(0.0, 0.0, 0.0, 1.0);
    vec2 place = windrow_cloud_place(frame.clouds, eye, direction);
    float tau = sheet_depth(noise, place, 5);
    if (!(tau > 0.0))
        return vec4(0.0, 0.0, 0.0, 1.0);
    float before = sheet_depth(noise, place + windrow_cloud_sunward(frame.clouds, to_sun), 4);
    return windrow_cloud_shown(frame.clouds, to_sun, eye, direction, frame.sunlight.rgb, 0.318309886 * frame.skylight.rgb, tau,
                               before);
}

#endif
