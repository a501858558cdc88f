#version 300 es
// Soil between the roots; beyond the blades the meadow's own mean colour, and the waves that gusts draw in it.
#include "plants.glsl"
in vec3 position;
uniform sampler2D patches_map;
out vec4 colour;

void main() {
    vec2 place = position.xz;
    float distance = length(eye.xyz - position);
    vec3 n = normalize(cross(dFdy(position), dFdx(position)));
    n = n.y < 0.0 ? -n : n;
    vec3 to_eye = (eye.xyz - position) / distance;
    vec2 off = abs(place - middle.xy);
    float far_off = max(off.x, off.y);
    float grown = windrow_grass_ramp(far_off, level[LEVELS - 1].y - 7.0, level[LEVELS - 1].z);
    float lit = sun_fraction(position);
    vec4 patch_ = texture(patches_map, place / 102.4);
    float grain = 0.6 * texture(patches_map, place / 9.3).a + 0.4 * patch_.a;
    float dry = patch_.r, clump = patch_.g, own = 0.25 + 0.5 * patch_.b;
    vec3 bare = vec3(0.0);
    if (grown < 1.0) {
        // Among the blades: soil, and the short ones that are not drawn.
        vec3 low = mix(look.soil.rgb, grass_albedo(look, 0.42, clump, own, dry), 0.35 + 0.55 * grain);
        float open = grass_open(look, 0.25);
        bare = low * (0.318309886 * sunlight.rgb * lit * max(dot(n, sky.sun.xyz), 0.0) * grass_self_shade(look, 0.5) +
                           open * windrow_around(n, skylight.rgb, groundlight.rgb));
    }
    vec3 radiance = bare;
    if (grown > 0.0) {
        vec2 lean = vec2(0.0);
        if (distance < 120.0 && cells.y == 7) // a slow machine leaves the far waves out
            lean = windrow_swing_held(blade_class, vec3(0.0, 1.0, 0.0), uvec2(0x80000000u), windrow_velocity(position + vec3(0.0, 0.3, 0.0)));
        vec3 leaf = grass_albedo(look, k_seen_height, clump, own, dry);
        vec3 canopy = grass_canopy_normal(look, n, lean);
        float shade = lit * grass_self_shade(look, k_seen_height), seen = grass_open(look, k_seen_height);
        vec3 meadow = grass_radiance(look, leaf, grass_through(look, leaf, k_seen_height), canopy, sky.sun.xyz, to_eye,
                                     sunlight.rgb * shade, skylight.rgb * seen, groundlight.rgb * seen, grass_canopy_gloss(look, lean));
        radiance = mix(bare, meadow, grown);
    }
    colour = vec4(toned(fogged(radiance, position)), 1.0);
}
