// The colour pass of a layer: shell.frag, and shell_pixel.frag where each fragment asks the wind.
#ifndef WINDROW_SHELLS_SHELL_COLOUR_GLSL
#define WINDROW_SHELLS_SHELL_COLOUR_GLSL

#include "../render/shading.glsl"
#include "../numerics/motion_vector.glsl"
#include "../numerics/strand_light.glsl"
#include "coat.glsl"
#include "coat_places.glsl"
#include "shell_strand.glsl"
#include "shell_light.glsl"
#include "shell_fragment.glsl"

layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

// Unit vector away from the strand's middle, in the world: from the mesh's own space by what the pixel's neighbours have of both.
vec3 strand_outward(ShellHit hit, ShellFragment f) {
    vec3 n = k_pattern == 1 ? hit.root.n : vec3(0.0, 0.0, 1.0);
    vec2 share = in_plane_of(windrow_strand_gradient(hit.strand.outward, hit.strand.facet, n, coat.cel.y), f);
    vec3 world = share.x * f.p_dx + share.y * f.p_dy;
    float size = dot(world, world);
    return size > 1e-20 ? world / sqrt(size) : vec3(0.0);
}

// `n`: the layer's normal, away from the cloud's plane.
vec3 cloud_radiance(ShellSurface s, ShellHit hit, ShellFragment f, vec3 n, vec3 position) {
    vec3 to_sun = frame.sky.sun.xyz;
    vec3 up = hit.height < 0.0 ? -n : n;
    float height = coat.cloud.drift.w;
    // The sun's way across the plane, by what the pixel's neighbours have of both spaces.
    vec2 pixels = in_plane(windrow_across(to_sun, up), f.p_dx, f.p_dy);
    vec2 way = height * (pixels.x * f.dx.x + pixels.y * f.dy.x).xz;
    vec2 place = hit.root.x.xz - coat.low.xz - 0.5 / max(coat.extent.xz, vec2(1e-9));
    float depth = windrow_cloud_sunward(coat.cloud, place, hit.height, way, dot(to_sun, up));
    float glow = windrow_cel(windrow_cloud_glow(depth, dot(f.sight, to_sun)), coat.cel.x, 0.2);
    // Around a cloud is air: below it is lit by what other clouds and haze scatter, not by the meadow.
    vec3 below = mix(frame.groundlight.rgb, frame.skylight.rgb, 0.7);
    return s.albedo * (0.318309886 * frame.sunlight.rgb * sun_fraction(position, to_sun) * glow +
                       s.open * windrow_around(mix(-up, up, 0.5 + 0.5 * hit.height), frame.skylight.rgb, below));
}

void main() {
    ShellFragment f = shell_fragment();
    ShellHit hit = f.hit;
    bool cloud = k_pattern == 3;
    vec3 to_eye = -f.sight;
    vec3 at = position + hit.on_way * f.sight;
    float t = clamp(cloud ? 0.5 + 0.5 * hit.height : abs(hit.height) / max(hit.map, 1e-3), 0.0, 1.0);
    // Where strands are short they have no dark depth: what counts is how far below the tips a place lies.
    float lit_t = cloud ? t : 1.0 - min(hit.map, 1.0) * (1.0 - t);
    PlaceColour place = place_colour(hit.root.x, hit.root.uv, f.wide_on_pictures);

    float tone = f.bald ? 1.0 : windrow_strand_tone(hit.strand.key, coat.tip.w * (1.0 - hit.thin));
    float patches = windrow_strand_patch(91u, hit.root.x * coat.second.w);
    vec3 fur = windrow_strand_colour(coat.root.rgb, coat.tip.rgb, coat.second.rgb, patches, lit_t, coat.root.w, tone);
    ShellSurface surface;
    surface.hair = f.bald ? 0.0 : 1.0;
    surface.albedo = mix((f.bald ? coat.skin.rgb : fur) * place.factor, place.tint, place.tinted);
    surface.height = t;
    surface.open = f.bald ? 1.0 : windrow_strand_occlusion(lit_t, coat.light.x, coat.skin.w);

    vec3 n = normalize(normal);
    if (dot(n, to_eye) < 0.0 && coat.layers.z == 0)
        n = normalize(n + (0.02 - dot(n, to_eye)) * to_eye); // beyond the horizon: what is seen still turns to the eye
    vec3 outward = f.bald || cloud || hit.thin >= 1.0 ? vec3(0.0) : strand_outward(hit, f);
    vec3 own_normal = windrow_strand_blended(outward, n, t);
    if (coat.influence.w > 0.0) {
        // Cells that a whole strand is high, by what a pixel covers of both.
        float cells = coat.field.cells.x * (coat.form.z == 1 ? length(f.dx.x) : length(f.dx.uv)) / max(length(f.p_dx), 1e-9);
        float slope = windrow_strand_slope(coat.field, abs(hit.height) / max(hit.map, 1e-4), hit.strand.reach);
        own_normal = windrow_strand_sloped(outward, n, slope / max(cells * coat.shells.form.x * hit.map, 1e-4));
    }
    surface.normal = normalize(mix(n, own_normal, coat.sheen.w * (1.0 - hit.thin) * step(1e-6, dot(outward, outward))));
    surface.tangent = normalize(along);

    // The skin's own shade is looked up at the tips: the map has them too.
    vec3 above = cloud || f.bald ? at : at + coat.shells.form.x * (1.0 - abs(hit.height)) * n;
    vec3 radiance = cloud ? cloud_radiance(surface, hit, f, n, above) : shell_radiance(surface, at, above, to_eye);
    if (f.bald)
        radiance += place.glow;
    colour = vec4(fogged(radiance, position), 1.0);
    motion = windrow_motion_vector(clip_now, clip_before);
}

#endif
