// What every fragment of a layer begins with: its root on the skin, the way of its ray, the strand that it meets; discards what
// is open.
#ifndef WINDROW_SHELLS_SHELL_FRAGMENT_GLSL
#define WINDROW_SHELLS_SHELL_FRAGMENT_GLSL

#include "../render/sample_bits.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 rest;
layout(location = 3) in vec3 rest_normal;
layout(location = 4) in vec2 uv;
layout(location = 5) in vec3 along;
layout(location = 6) in vec3 clip_now;
layout(location = 7) in vec3 clip_before;
layout(location = 8) flat in vec2 neighbours; // heights of the next inner and outer layer

struct ShellFragment {
    ShellHit hit;
    vec3 sight;             // unit, from the eye
    vec3 p_dx, p_dy;        // [m] the position's change to the next pixel
    ShellRoot dx, dy;       // the root's
    bool bald;              // the skin where nothing grows
    float wide_on_pictures; // what a pixel covers of them
};

// a, b with a dx + b dy of the root = v, a vector along the strands' place: [cells].
vec2 in_plane_of(vec3 v, ShellFragment f) {
    vec3 dx = k_pattern == 1 ? f.dx.x : vec3(f.dx.uv, 0.0);
    vec3 dy = k_pattern == 1 ? f.dy.x : vec3(f.dy.uv, 0.0);
    return in_plane(v / coat.field.cells.x, dx, dy);
}

ShellFragment shell_fragment() {
    ShellFragment f;
    f.p_dx = dFdx(position);
    f.p_dy = dFdy(position);
    f.dx = ShellRoot(dFdx(rest.xyz), dFdx(rest_normal), dFdx(uv));
    f.dy = ShellRoot(dFdy(rest.xyz), dFdy(rest_normal), dFdy(uv));
    vec3 n_dx = dFdx(normal), n_dy = dFdy(normal);
    vec3 n = normalize(normal);
    float wide = sqrt(max(dot(f.dx.x, f.dx.x), dot(f.dy.x, f.dy.x)));
    float wide_uv = sqrt(max(dot(f.dx.uv, f.dx.uv), dot(f.dy.uv, f.dy.uv)));
    f.wide_on_pictures = projected_width(wide, wide_uv);

    ShellRoot root = ShellRoot(rest.xyz, normalize(rest_normal), uv);
    float h = abs(rest.w);
    float map = place_length(root.x, root.uv, f.wide_on_pictures);
    f.sight = normalize(position - frame.eye.xyz);
    f.bald = coat.form.w == 1 || map < coat.tousle.w;
    uvec2 pixel = windrow_plant_hash(uvec2(ivec2(gl_FragCoord.xy)) + uvec2(floatBitsToUint(h), 0u));
    float chance = windrow_fraction(pixel.x);
    if (h <= 0.0 && coat.layers.z == 0) { // the skin
        f.hit.root = root;
        f.hit.height = 0.0;
        f.hit.map = max(map, 1e-3);
        f.hit.coverage = 1.0;
        f.hit.on_way = 0.0;
        f.hit.thin = 1.0;
        f.hit.strand = windrow_strand_none();
        gl_SampleMask[0] = (1 << coat.drawing.y) - 1;
        return f;
    }
    // From within: only the rim of what the skin does not hide, sqrt(2 L k) of a skin whose curvature is k.
    float cosine = dot(f.sight, n);
    if (coat.layers.z == 0 && cosine > 0.0) {
        vec3 aside = windrow_across(f.sight, n);
        vec2 pixels = in_plane(aside, f.p_dx, f.p_dy);
        float curved = max(dot(pixels.x * n_dx + pixels.y * n_dy, aside) / max(dot(aside, aside), 1e-6), 0.0);
        if (cosine > 0.05 + 1.3 * sqrt(2.0 * coat.shells.form.x * h * curved))
            discard;
    }
    ShellRay ray = shell_ray(f.sight, n, along, h, neighbours.x, neighbours.y, f.p_dx, f.p_dy, n_dx, n_dy);
#ifdef COAT_WIND_AT_PIXEL
    // The strand that is seen here stands upwind: once by the wind here, once more by that at the root.
    ShellRoot straight = root;
    vec3 foot = position - h * coat.shells.form.x * n;
    for (int n_th = 0; n_th < 2; ++n_th) {
        vec3 wind = coat.levels.z * windrow_wind_on(foot + 0.5 * coat.shells.form.x * n, vec3(0.0));
        vec3 load = windrow_shell_load(coat.shells, n, max(map, 0.05), wind) + feet_on(foot, n);
        ray.load = length(load);
        if (!(ray.load > 1e-6))
            break;
        vec3 way = load / ray.load;
        ray.blown = in_plane(way, f.p_dx, f.p_dy);
        float leant = blown_way(ray.load, h);
        root = moved(straight, f.dx, f.dy, -leant * ray.blown);
        foot = position - h * coat.shells.form.x * n - leant * way;
    }
#endif
    f.hit = k_pattern == 3 ? cloud_hit(root, f.dx, f.dy, rest.w, ray, pixel.y) : shell_hit(root, f.dx, f.dy, h, map, ray, chance);
    int samples = coat.drawing.y;
    float count = samples > 1 ? f.hit.coverage * float(samples) + mix(0.5, chance, f.hit.thin)
                              : f.hit.coverage + mix(0.5, chance, f.hit.thin);
    int bits = sample_bits(min(floor(count) / float(samples), 1.0), samples, int(f.hit.strand.key.x >> 8u));
    if (bits == 0)
        discard;
    gl_SampleMask[0] = bits;
    return f;
}

#endif
