// A cloud out of shells: layers above and below a plane, each open where the heap does not reach.
//
//   f(x)     = sat(sat((noise((x - drift) / size) - least) / 0.7) - (1 - rim(x)))      how thick the heap is, 0 to 1
//   least    = c (0.3 + 0.25 c^2), c = 1 - 2 cover          near the noise's own quantiles: `cover` is about the share of sky
//                                                           covered
//   top(x)   = sqrt(f (2 - f))                              round: an arc over f
//   s(x, h)  = top - |h| / base - billow (1 + detail) / 2   above 0: within. base 1 above the plane, its own below: flat or
//                                                           mirrored
//   rim      = smoothstep from the plane's edge inward      nothing at all within the edge, so that no edge is seen
//
// x [m] in the plane from its middle, h from -1 to 1 of half the cloud's height; noise by simplex octaves, evolving along their
// third axis, with a deviation of 0.24 for four octaves; cover 0 leaves none. `s` counts in heights; without billow it falls with
// |h|: layers nest. Drift by an offset is the pattern's shift: only x - drift is ever asked. Few layers look drawn (cel), 128
// look soft.
// Based on: Curoe's shell-textured worlds (mirrored shells, threshold by height); Perlin 1985, An image synthesizer (octaves);
// Schneider 2015, The real-time volumetric cloudscapes of Horizon Zero Dawn (a detail that eats the base form).
#ifndef WINDROW_CLOUD_SHELLS_GLSL
#define WINDROW_CLOUD_SHELLS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "simplex.glsl"

// fur::CloudShellSettings (vegetation/fur/cloud_shell.h) says more of each value. Usable in std140.
struct WindrowCloudShells {
    vec4 form;  // x cover; y [1/m] noise units a metre; z base; w billow
    vec4 rim;   // xy [m] half sizes of the plane; z [m] width of the fading; w 1: the plane is an ellipse
    vec4 drift; // xy [m] the pattern's shift; z [noise units] how far it has evolved; w [m] half the cloud's height
    vec4 kind;  // x octaves; y seed; zw 0
};

// 0 at the plane's rim and beyond, 1 from the fading's width inward.
WINDROW_FN float windrow_cloud_rim(WindrowCloudShells cloud, vec2 place) {
    vec2 inward = vec2(cloud.rim) - abs(place);
    float distance = min(inward.x, inward.y);
    if (cloud.rim.w > 0.5f) {
        vec2 share = place / vec2(cloud.rim);
        distance = (1.0f - sqrt(dot(share, share))) * min(cloud.rim.x, cloud.rim.y);
    }
    float s = clamp(distance / cloud.rim.z, 0.0f, 1.0f);
    return s * s * (3.0f - 2.0f * s);
}

// f; the same for all layers of a place.
WINDROW_FN float windrow_cloud_heap(WindrowCloudShells cloud, vec2 place) {
    float rim = windrow_cloud_rim(cloud, place);
    if (!(rim > 0.0f) || !(cloud.form.x > 0.0f))
        return 0.0f;
    vec2 at = (place - vec2(cloud.drift)) * cloud.form.y;
    float noise = windrow_simplex_octaves(uint(int(cloud.kind.y)), vec3(at.x, cloud.drift.z, at.y), int(cloud.kind.x), 0.5f);
    float clear = 1.0f - 2.0f * cloud.form.x;
    float thick = (noise - clear * (0.3f + 0.25f * clear * clear)) * (1.0f / 0.7f);
    return clamp(min(thick, 1.0f) - (1.0f - rim), 0.0f, 1.0f);
}

// top of a heap.
WINDROW_FN float windrow_cloud_top(float heap) { return sqrt(max(heap * (2.0f - heap), 0.0f)); }

// s above 0: within the cloud. `heap` from windrow_cloud_heap.
WINDROW_FN float windrow_cloud_inside(WindrowCloudShells cloud, vec2 place, float h, float heap) {
    float away = h < 0.0f ? -h / cloud.form.z : h;
    float inside = windrow_cloud_top(heap) - away;
    if (!(heap > 0.0f))
        return -1.0f - away;
    if (!(cloud.form.w > 0.0f) || inside <= 0.0f)
        return inside;
    vec2 at = (place - vec2(cloud.drift)) * cloud.form.y;
    float up = h * cloud.drift.w * cloud.form.y;
    vec3 fine = 3.7f * vec3(at.x, up + cloud.drift.z, at.y);
    float detail = windrow_simplex_octaves(uint(int(cloud.kind.y)) + 77u, fine, 2, 0.5f);
    return inside - cloud.form.w * (0.5f + 0.5f * detail);
}

// The heap's own normal at a place within it, y up: from its slope, by differences over `step` [m].
WINDROW_FN vec3 windrow_cloud_normal(WindrowCloudShells cloud, vec2 place, float h, float heap, float step) {
    float top = windrow_cloud_top(heap);
    float dx = (windrow_cloud_top(windrow_cloud_heap(cloud, place + vec2(step, 0.0f))) - top) / step;
    float dz = (windrow_cloud_top(windrow_cloud_heap(cloud, place + vec2(0.0f, step))) - top) / step;
    float side = h < 0.0f ? -1.0f / cloud.form.z : 1.0f;
    // s = top(x) - |h| / base, with h = y / height.
    vec3 n = vec3(-dx * cloud.drift.w, side, -dz * cloud.drift.w);
    return n / sqrt(dot(n, n));
}

#endif
