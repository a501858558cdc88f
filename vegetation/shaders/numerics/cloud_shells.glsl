// A cloud out of shells: layers above and below a plane, each open where the heap does not reach.
//
//   f(x)     = sat(sat((noise((x - drift) / size) - least) / 0.7) - (1 - rim(x)))      how thick the heap is, 0 to 1
//   least    = c (0.3 + 0.25 c^2), c = 1 - 2 cover          near the noise's own quantiles: `cover` is about the share of sky
//                                                           covered
//   top(x)   = sqrt(f (2 - f))                              round: an arc over f
//   s(x, h)  = top - |h| / base - billow e          above 0: within. base 1 above the plane, its own below: flat or
//                                                   mirrored
//   e        = 1 - 2.2 sum of |noise| / 2^n         0 on puffs, near 1 in the creases between them
//   density  = sat(s / soft)                        1 beyond the soft edge
//   tau      = sum of 3 density ds / soft           way ds in half heights: the edge's depth is crossed by 3 / 2 of tau
//   rim      = smoothstep from the plane's edge inward      nothing at all within the edge, so that no edge is seen
//
// x [m] in the plane from its middle, h from -1 to 1 of half the cloud's height; noise by simplex octaves, evolving along their
// third axis, with a deviation of 0.24 for four octaves; cover 0 leaves none. `s` counts in heights; without billow it falls with
// |h|: layers nest. Drift by an offset is the pattern's shift: only x - drift is ever asked. Few layers look drawn (cel), 128
// look soft. Light: Wrenninge, Kulla & Lundqvist 2013, Oz: the great and volumetric (octaves of scattering, each deeper and
// weaker); their weights here are ours.
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
    vec4 kind;  // x octaves; y seed; z softness, 0 none; w 0
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
    uint seed = uint(int(cloud.kind.y)) + 77u;
    float puffs = abs(windrow_simplex_octaves(seed, fine, 1, 0.5f)) +
                  0.5f * abs(windrow_simplex_octaves(seed + 31u, 2.3f * fine, 1, 0.5f)) +
                  0.25f * abs(windrow_simplex_octaves(seed + 59u, 4.9f * fine, 1, 0.5f));
    return inside - cloud.form.w * max(1.0f - 1.6f * puffs, 0.0f);
}

// Optical depth of a way `ds` [half heights] at `inside` = s.
WINDROW_FN float windrow_cloud_thickness(float soft, float inside, float ds) {
    return 3.0f * ds / soft * clamp(inside / soft, 0.0f, 1.0f);
}

// Optical depth from a place toward the sun: four stretches, each twice as long as the one before, 0.75 half heights in all.
// `way` is how x and z change, `rise` how h does, in a half height along the ray. Light goes into a hard cloud too.
WINDROW_FN float windrow_cloud_sunward(WindrowCloudShells cloud, vec2 place, float h, vec2 way, float rise) {
    float soft = max(cloud.kind.z, 0.15f);
    float depth = 0.0f, ds = 0.05f, gone = 0.0f;
    for (int n = 0; n < 4; ++n) {
        float at = gone + 0.5f * ds;
        vec2 there = place + at * way;
        float up = h + at * rise;
        depth += windrow_cloud_thickness(soft, windrow_cloud_inside(cloud, there, up, windrow_cloud_heap(cloud, there)), ds);
        gone += ds;
        ds *= 2.0f;
    }
    return depth;
}

// Share of the sun's light that reaches the eye from a place at that depth: what came straight, and what was scattered on the way
// and so goes deeper; `forward` is the cosine of the angle between sight and sun. A thin edge against the sun is brighter than 1.
WINDROW_FN float windrow_cloud_glow(float depth, float forward) {
    float straight = exp(-depth), scattered = 0.30f * exp(-0.25f * depth) + 0.20f * exp(-0.04f * depth);
    float ahead = 0.5f + 0.5f * forward;
    return 0.50f * straight * (1.0f + 1.6f * ahead * ahead * ahead * ahead) + scattered;
}

#endif
