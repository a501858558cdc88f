// Light on strands: sun, lamps, sky, by the formulas of strand_light.glsl. After coat.glsl and shading.glsl.
#ifndef WINDROW_SHELLS_SHELL_LIGHT_GLSL
#define WINDROW_SHELLS_SHELL_LIGHT_GLSL

#include "../numerics/lamp.glsl"

struct ShellSurface {
    vec3 albedo;
    vec3 normal;
    vec3 tangent; // unit, along the strand
    float height; // of the strand's length, 0 to 1
    float open;   // share of light that neighbours leave
    float hair;   // 1 on strands, 0 on bare skin
};

// Radiance from a light of irradiance `beam` across it.
vec3 shell_lit(ShellSurface s, vec3 beam, vec3 to_light, vec3 to_eye) {
    float facing = windrow_cel(windrow_wrapped(dot(s.normal, to_light), coat.light.y), coat.cel.x, 0.2);
    vec3 half_way = windrow_half_way(to_light, to_eye, s.normal);
    float gloss = coat.light.z > 0.0 ? coat.light.z * windrow_plain_gloss(s.normal, half_way, coat.light.w) : 0.0;
    float sheen = coat.sheen.x > 0.0 ? coat.sheen.x * windrow_hair_sheen(s.tangent, half_way, coat.sheen.y) : 0.0;
    float through = coat.sheen.z * windrow_tips_through(s.height, -dot(to_eye, to_light));
    vec3 along = facing * (gloss + sheen * mix(vec3(0.04), s.albedo, 0.5)) + through * s.albedo;
    return 0.318309886 * beam * (s.open * facing * s.albedo + s.hair * s.height * along);
}

// `above` is where the sun is asked: out of the coat, whose own shade is `open`.
vec3 shell_radiance(ShellSurface s, vec3 position, vec3 above, vec3 to_eye) {
    vec3 to_sun = frame.sky.sun.xyz;
    vec3 radiance = shell_lit(s, frame.sunlight.rgb * sun_fraction(above, to_sun), to_sun, to_eye);
    radiance += s.open * s.albedo * windrow_around(s.normal, frame.skylight.rgb, frame.groundlight.rgb);
    for (int n = 0; n < coat.drawing.w; ++n) {
        vec3 offset = coat.lamps[n].place.xyz - position;
        float share = windrow_lamp_fraction(offset, coat.lamps[n].place.w);
        if (share > 0.0)
            radiance += shell_lit(s, share * coat.lamps[n].colour.rgb, normalize(offset), to_eye);
    }
    return radiance;
}

#endif
