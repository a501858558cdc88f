// A layer of clouds: one level sheet of optical depth that drifts, seen from below, and the share of the sun that it leaves.
//
//   f(x)   = sum_k 2^-k noise(2^k x + o_k) / sum_k 2^-k      value noise, 0 to 1; x = (place + offset) / size
//   tau(x) = depth * s(f; 1 - c', 1.3 - c')                  c' moves with the cover; s smoothstep; 0 where the sky is clear
//   T      = exp(-tau m)                                     what passes along a ray of air mass m (1 straight up)
//   L      = E_sun (P(cos) + a(tau_s)) (1 - T) + L_around (1 - T)
//            P Henyey and Greenstein's, a the light that came there by many scatterings, falling with the depth toward the sun
//
// Depth toward the sun is taken from the sheet itself a little way along the sun's azimuth: the side that faces the sun is
// bright, the other grey. It is a picture's cloud, not a physicist's: `a` and that way are ours. Positions [m] from the anchor.
// Based on: Henyey & Greenstein 1941; Perlin 1985, An image synthesizer (sums of octaves); Schneider 2015, The real-time
// volumetric cloudscapes of Horizon Zero Dawn (remapping noise by cover, light toward the sun).
#ifndef WINDROW_CLOUD_LAYER_GLSL
#define WINDROW_CLOUD_LAYER_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "../../../shaders/numerics/place_noise.glsl"
#include "sky.glsl"

struct WindrowClouds {
    vec4 place; // xy noise's cell at the anchor, drift included; z [m] height above the anchor; w [1/m] cells a metre
    vec4 form;  // x cover, 0 (none) to 1 (all); y optical depth of the thickest; z asymmetry of a droplet's scattering; w 0
};

// Sum of octaves, 0 to 1; where it is below `least`, 0 as soon as the octaves that are left cannot lift it there.
WINDROW_FN float windrow_octaves_above(vec2 at, int count, float least) {
    float sum = 0.0f;
    float share = 1.0f;
    float left = 2.0f - 1.0f / float(1 << (count - 1)); // of all shares
    float all = left;
    for (int k = 0; k < count; ++k) {
        sum += share * windrow_place_noise(at);
        left -= share;
        if (sum + left < least * all - 1e-4f)
            return 0.0f;
        share *= 0.5f;
        at = 2.03f * vec2(0.8f * at.x - 0.6f * at.y, 0.6f * at.x + 0.8f * at.y) + 17.3f; // turned, so that no axis shows
    }
    return sum / all;
}

WINDROW_FN float windrow_octaves(vec2 at, int count) { return windrow_octaves_above(at, count, 0.0f); }

// [m] Place on the sheet along a ray that climbs, from `from`; xz of it. `up` is the ray's y, above 0.
WINDROW_FN vec2 windrow_cloud_place(WindrowClouds clouds, vec3 from, vec3 ray) {
    float way = (clouds.place.z - from.y) / ray.y;
    return vec2(from.x, from.z) + way * vec2(ray.x, ray.z);
}

// Cell of the noise at a place on the sheet [m from the anchor].
WINDROW_FN vec2 windrow_cloud_cell(WindrowClouds clouds, vec2 place) { return vec2(clouds.place) + place * clouds.place.w; }

// What octaves leave clear lies below this sum of them: they rarely leave 0.16 to 0.84.
WINDROW_FN float windrow_cloud_clear_below(WindrowClouds clouds) { return 0.78f - 0.62f * clouds.form.x; }

// Optical depth straight up through the sheet by a sum of octaves.
WINDROW_FN float windrow_cloud_depth_by(WindrowClouds clouds, float f) {
    float t = clamp((f - windrow_cloud_clear_below(clouds)) / 0.3f, 0.0f, 1.0f);
    return clouds.form.y * t * t * (3.0f - 2.0f * t);
}

// The same at a cell of the noise.
WINDROW_FN float windrow_cloud_depth_of(WindrowClouds clouds, vec2 cell, int octaves) {
    if (!(clouds.form.x > 0.0f))
        return 0.0f;
    return windrow_cloud_depth_by(clouds, windrow_octaves_above(cell, octaves, windrow_cloud_clear_below(clouds)));
}

// The same at a place on the sheet [m from the anchor].
WINDROW_FN float windrow_cloud_depth(WindrowClouds clouds, vec2 place, int octaves) {
    return windrow_cloud_depth_of(clouds, windrow_cloud_cell(clouds, place), octaves);
}

// Share of the sun's beam that a cell of the noise leaves. Light that is scattered forward arrives too.
WINDROW_FN float windrow_cloud_left(WindrowClouds clouds, vec2 cell) {
    return 0.3f + 0.7f * exp(-0.6f * windrow_cloud_depth_of(clouds, cell, 3));
}

// Whether the sheet is between p [m] and the sun.
WINDROW_FN bool windrow_clouds_above(WindrowClouds clouds, vec3 to_sun, vec3 p) {
    return clouds.form.x > 0.0f && to_sun.y > 0.02f && p.y < clouds.place.z;
}

// Share of the sun's beam that reaches p [m]; 1 above the sheet and with no clouds. Blurred as by a sheet that is not thin.
WINDROW_FN float windrow_cloud_light(WindrowClouds clouds, vec3 to_sun, vec3 p) {
    if (!windrow_clouds_above(clouds, to_sun, p))
        return 1.0f;
    return windrow_cloud_left(clouds, windrow_cloud_cell(clouds, windrow_cloud_place(clouds, p, to_sun)));
}

// Whether a ray [unit vector] from the eye meets the sheet.
WINDROW_FN bool windrow_cloud_seen(WindrowClouds clouds, vec3 eye, vec3 ray) {
    return clouds.form.x > 0.0f && ray.y > 0.005f && eye.y < clouds.place.z;
}

// [m] Way along the sheet toward the sun's azimuth, after which the depth that shades a place is taken.
WINDROW_FN vec2 windrow_cloud_sunward(WindrowClouds clouds, vec3 to_sun) {
    return vec2(to_sun.x, to_sun.z) * (0.11f / (clouds.place.w * max(to_sun.y, 0.2f)));
}

// xyz radiance of a cloud that a ray meets, w fraction of what lies behind that still shines through. `sunlight` is the beam's
// irradiance, `around` the sky's radiance there; depths straight up: `tau` by 5 octaves where the ray meets the sheet, `before` by
// 4 sunward of it.
WINDROW_FN vec4 windrow_cloud_shown(WindrowClouds clouds, vec3 to_sun, vec3 eye, vec3 ray, vec3 sunlight, vec3 around, float tau,
                                    float before) {
    float slant = min(1.0f / ray.y, 6.0f);
    float passed = exp(-tau * slant);
    float lit = 0.75f * exp(-0.9f * before) + 0.25f;
    float forward = windrow_haze_phase(dot(ray, to_sun), clouds.form.z) * exp(-tau);
    vec3 radiance = sunlight * (0.16f * lit + min(forward, 1.5f)) + 0.75f * around;
    // Far clouds drown in the air's own light.
    float near = exp(-(clouds.place.z - eye.y) / (ray.y * 14000.0f));
    float cover = (1.0f - passed) * near;
    vec3 shown = radiance * cover;
    return vec4(shown.x, shown.y, shown.z, 1.0f - cover);
}

// The same along any ray from the eye; 0, 0, 0 and 1 where it meets none.
WINDROW_FN vec4 windrow_cloud_radiance(WindrowClouds clouds, vec3 to_sun, vec3 eye, vec3 ray, vec3 sunlight, vec3 around) {
    vec2 place = vec2(0.0f);
    float tau = 0.0f;
    if (windrow_cloud_seen(clouds, eye, ray)) {
        place = windrow_cloud_place(clouds, eye, ray);
        tau = windrow_cloud_depth(clouds, place, 5);
    }
    if (!(tau > 0.0f))
        return vec4(0.0f, 0.0f, 0.0f, 1.0f);
    float before = windrow_cloud_depth(clouds, place + windrow_cloud_sunward(clouds, to_sun), 4);
    return windrow_cloud_shown(clouds, to_sun, eye, ray, sunlight, around, tau, before);
}

#endif
