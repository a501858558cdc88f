// What a layer casts: the strands that the eye sees there, without the walk between layers.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "coat.glsl"
#include "coat_places.glsl"
#include "shell_strand.glsl"

layout(location = 0) in vec4 rest;
layout(location = 1) in vec3 rest_normal;
layout(location = 2) in vec2 uv;

void main() {
    float h = abs(rest.w);
    if (h <= 0.0 && coat.layers.z == 0)
        return;
    ShellRoot root = ShellRoot(rest.xyz, normalize(rest_normal), uv);
    ShellRoot dx = ShellRoot(dFdx(rest.xyz), vec3(0.0), dFdx(uv)), dy = ShellRoot(dFdy(rest.xyz), vec3(0.0), dFdy(uv));
    if (k_pattern == 3) {
        vec2 place = root.x.xz - coat.low.xz - 0.5 / max(coat.extent.xz, vec2(1e-9));
        if (windrow_cloud_inside(coat.cloud, place, rest.w, windrow_cloud_heap(coat.cloud, place)) <= 0.0)
            discard;
        return;
    }
    float pixel = cells_across(dx, dy);
    float wide = projected_width(length(dx.x), length(dx.uv));
    float map = place_length(root.x, root.uv, wide);
    if (map < coat.tousle.w || h > map)
        discard;
    // Strands thinner than a texel: as many texels as their share.
    float far = smoothstep(0.6, 1.4, pixel);
    float chance = windrow_fraction(windrow_plant_hash(uvec2(ivec2(gl_FragCoord.xy)) + uvec2(floatBitsToUint(h), 0u)).x);
    bool open = far >= 0.5 ? mean_fraction(h, map) <= chance : strand_at(root, h, map).inside < 0.0;
    if (open)
        discard;
}
