// What the clouds leave of the sun, from a map of the sheet about the eye that each frame draws (cloud_map.frag): its three
// octaves of noise are worked out once a texel, not at each vertex and pixel that is lit. A texel is a 128th of the largest
// lumps. Beyond the map the light is worked out.
#ifndef WINDROW_RENDER_CLOUD_MAP_GLSL
#define WINDROW_RENDER_CLOUD_MAP_GLSL

#include "frame.glsl"

float cloud_light(vec3 p) {
    vec3 to_sun = frame.sky.sun.xyz;
    if (!windrow_clouds_above(frame.clouds, to_sun, p))
        return 1.0;
    vec2 cell = windrow_cloud_cell(frame.clouds, windrow_cloud_place(frame.clouds, p, to_sun));
    vec2 uv = (cell - frame.cloud_map.xy) * frame.cloud_map.z;
    float rim = 0.5 * frame.cloud_map.w; // half a texel
    if (any(lessThan(uv, vec2(rim))) || any(greaterThan(uv, vec2(1.0 - rim))))
        return windrow_cloud_left(frame.clouds, cell);
    return textureLod(cloud_map, uv, 0.0).r;
}

#endif
