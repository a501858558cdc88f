// Which strand a fragment of a layer meets: at its own place, or farther along its ray between this layer and the next inner one.
//
//   W(x, h)      the place in the world of root x at height h;  dW = T dx + A dh,  A = `along`
//   a ray d ds   leaves the layer by dh/ds = d.N / A.N, and by the layer's own curvature k: h(s) = h + s d.N / A.N + s^2 k
//                |d_t|^2 / (2 A.N)
//   dx           T dx = d ds - A dh, solved by what the pixel's neighbours have of x and W
//
// So a ray between two layers meets what a thousand layers there would show it: gaps at grazing view close, and the silhouette is
// no stack of sheets. A layer that is seen from within has its ray rising toward the next outer one. Where a ray leaves the layer
// again before it reaches the next one, it ends there: the next layer that it meets, on its far side, goes on with it.
// Based on: the cells' width as the step: Lengyel et al. 2001, Real-time fur over arbitrary surfaces, have fins for the same
// gaps; the walk between layers is ours, after relief mapping (Policarpo, Oliveira & Comba 2005).
#ifndef WINDROW_SHELLS_SHELL_STRAND_GLSL
#define WINDROW_SHELLS_SHELL_STRAND_GLSL

#include "shaders/numerics/strand.glsl"
#include "../numerics/strand_light.glsl"

// What a coat's fragments never do is not in their pipeline: ShellConstants of vegetation/fur/coat_device.cpp.
layout(constant_id = 0) const int k_pattern = 1; // 0 cells of uv, 1 the surface's, 2 noise pictures, 3 a cloud
layout(constant_id = 1) const int k_profile = 0;
layout(constant_id = 2) const int k_shape = 0;
layout(constant_id = 3) const bool k_bow = true;
layout(constant_id = 4) const bool k_tufts = true;
layout(constant_id = 5) const bool k_jitter = true;
layout(constant_id = 6) const bool k_march = true;

WindrowStrandField coat_field() {
    WindrowStrandField field = coat.field;
    field.points.w = float(k_profile);
    field.reach.w = float(k_shape);
    field.bow.x = k_bow ? field.bow.x : 0.0;
    field.bow.z = k_tufts ? field.bow.z : 0.0;
    field.points.x = k_jitter ? field.points.x : 0.0;
    field.points.y = k_jitter ? field.points.y : 0.0;
    return field;
}

// Where on the skin.
struct ShellRoot {
    vec3 x; // [m] in the mesh's space
    vec3 n; // unit
    vec2 uv;
};
struct ShellHit {
    WindrowStrandHit strand;
    ShellRoot root;
    float height;   // of the layers, 0 to 1
    float map;      // share of the strands' length there
    float coverage; // of a pixel
    float on_way;   // [m] from the layer's own point
    float thin;     // 1: strands are thinner than a pixel
};

// Two pictures in place of the strands' own chance: open above what both leave.
WindrowStrandHit noise_strand(ShellRoot root, float own) {
    vec2 at = root.uv * coat.extent.w;
    float a = picture_at(k_noise_picture, at, 0.0, true).x;
    float b = coat.pictures[k_noise_picture + 1].w > 0 ? picture_at(k_noise_picture + 1, at, 0.0, true).x : 1.0;
    WindrowStrandHit hit = windrow_strand_none();
    hit.reach = windrow_noise_pair(a, b, coat.influence.x, coat.influence.y);
    hit.inside = hit.reach - own;
    return hit;
}

// The field at a root, where strands have `map` of their length.
WindrowStrandHit strand_at(ShellRoot root, float h, float map) {
    float own = h / max(map, 1e-4);
    if (k_pattern == 2)
        return noise_strand(root, own);
    if (k_pattern == 1)
        return windrow_strand_surface(coat_field(), root.x - vec3(coat.drift.x, 0.0, coat.drift.y), root.n, own);
    return windrow_strand_uv(coat_field(), root.uv - coat.drift.xy * coat.extent.xz, own);
}

// Cells across which a pixel reaches, the shorter way: at grazing view it covers many the other way, but there strands stand up
// before it.
float cells_across(ShellRoot dx, ShellRoot dy) {
    vec3 x = k_pattern == 1 ? dx.x : vec3(dx.uv, 0.0), y = k_pattern == 1 ? dy.x : vec3(dy.uv, 0.0);
    float longer = sqrt(max(dot(x, x), dot(y, y)));
    return coat.field.cells.x * max(length(cross(x, y)) / max(longer, 1e-20), 0.125 * longer);
}

// Share of a layer that strands fill at h: what is seen of those thinner than a pixel. Over the three lengths of Simpson's rule.
float mean_fraction(float h, float map) {
    WindrowStrandField field = coat_field();
    float own = h / max(map, 1e-4);
    float sum = 0.0;
    for (int n = 0; n < 3; ++n) {
        float reach = mix(field.reach.x, field.reach.y, 0.5 * float(n));
        float share = 0.0;
        if (own <= reach && field.points.w > 1.5) {
            float open = clamp(1.0 - windrow_strand_cut(field, own, reach) / 0.55, 0.0, 1.0);
            share = open * open;
        } else if (own <= reach) {
            float radius = max(windrow_strand_radius(field, own, reach), 0.0);
            float area = field.reach.w < 0.5 ? 3.14159265 * radius * radius : 3.2 * radius * field.cut.w;
            share = 1.0 - exp(-area); // they stand by chance and cover one another
        }
        sum += n == 1 ? 4.0 * share : share;
    }
    return sum / 6.0;
}

// The ray from a layer's point through the coat.
struct ShellRay {
    vec3 sight;   // unit, from the eye
    float fall;   // [1/m] by which its height changes
    float bend;   // [1/m^2] more of it with the square of the way, by curvature
    float reach;  // [m] to the next layer
    float target; // height there
    vec2 step;    // [pixels] what 1 m along the ray goes over the layer
    vec2 lean;    // [pixels] what strands lean from height 0 to 1
    vec2 blown;   // [pixels a metre] along the wind of a fragment, WindAt::pixel
    float load;   // [rad] its bend
};

// [m] How far such a strand has moved at h.
float blown_way(float load, float h) {
    return coat.shells.form.x * windrow_strand_lean(vec2(load, 0.0), h, min(coat.shells.drag.load.w, 1.57079633)).x;
}

// The root `pixels` of the picture's aside.
ShellRoot moved(ShellRoot root, ShellRoot dx, ShellRoot dy, vec2 pixels) {
    ShellRoot at;
    at.x = root.x + pixels.x * dx.x + pixels.y * dy.x;
    at.n = normalize(root.n + pixels.x * dx.n + pixels.y * dy.n);
    at.uv = root.uv + pixels.x * dx.uv + pixels.y * dy.uv;
    return at;
}

// a, b with v = a dx + b dy in the plane of both, by least squares.
vec2 in_plane(vec3 v, vec3 dx, vec3 dy) {
    float xx = dot(dx, dx), xy = dot(dx, dy), yy = dot(dy, dy);
    float area = xx * yy - xy * xy;
    vec2 side = vec2(dot(v, dx), dot(v, dy));
    return vec2(yy * side.x - xy * side.y, xx * side.y - xy * side.x) / max(area, 1e-9 * xx * yy + 1e-30);
}

// `p_dx`, `n_dx` ... are what the pixel's neighbours have of the position and the normal.
ShellRay shell_ray(vec3 sight, vec3 n, vec3 along, float h, float below, float above, vec3 p_dx, vec3 p_dy, vec3 n_dx,
                   vec3 n_dy) {
    ShellRay ray;
    ray.sight = sight;
    float rise = max(dot(along, n), 1e-6);
    float cosine = dot(sight, n);
    vec3 aside = windrow_across(sight, n);
    ray.step = in_plane(aside, p_dx, p_dy);
    ray.lean = in_plane(windrow_across(along, n), p_dx, p_dy);
    ray.blown = vec2(0.0);
    ray.load = 0.0;
    ray.fall = cosine / rise;
    ray.bend = 0.5 * dot(ray.step.x * n_dx + ray.step.y * n_dy, aside) / rise;
    ray.target = ray.fall < 0.0 ? below : above;
    float gap = h - ray.target; // above 0 where the ray falls
    float square = ray.fall * ray.fall - 4.0 * ray.bend * gap;
    float steep = abs(ray.fall) + sqrt(max(square, 0.0));
    ray.reach = square > 0.0 || ray.bend * gap <= 0.0 ? 2.0 * abs(gap) / max(steep, 1e-6) : abs(ray.fall / ray.bend);
    ray.reach = min(ray.reach, 4.0 * rise); // a plane that is seen on edge has no end
    return ray;
}

float height_on(ShellRay ray, float h, float s) { return h + s * (ray.fall + s * ray.bend); }

ShellRoot root_on(ShellRay ray, ShellRoot root, ShellRoot dx, ShellRoot dy, float h, float s) {
    float here = height_on(ray, h, s);
    vec2 pixels = s * ray.step - (here - h) * ray.lean;
    if (ray.load > 0.0)
        pixels -= (blown_way(ray.load, clamp(here, 0.0, 1.0)) - blown_way(ray.load, h)) * ray.blown;
    return moved(root, dx, dy, pixels);
}

// A cloud in place of strands: what the ray meets between this layer and the next, `h` -1 to 1. A soft one covers as many samples
// as its thickness here hides; `turn`, the pixel's own in each layer, chooses them.
ShellHit cloud_hit(ShellRoot root, ShellRoot dx, ShellRoot dy, float h, ShellRay ray, uint turn) {
    ShellHit hit;
    hit.strand = windrow_strand_none();
    hit.map = 1.0;
    hit.thin = 0.0;
    float scale = coat.levels.y;
    vec2 middle = coat.low.xz + 0.5 / max(coat.extent.xz, vec2(1e-9));
    float pixel = coat.cloud.form.y * scale * sqrt(max(dot(dx.x, dx.x), dot(dy.x, dy.x)));
    int steps = coat.drawing.x;
    bool soft = coat.cloud.kind.z > 0.0;
    float depth = 0.0, stretch = ray.reach / float(steps + 1);
    bool met = false;
    for (int n = 0; n <= steps; ++n) {
        float s = stretch * float(n);
        float here = height_on(ray, abs(h), s);
        ShellRoot at = root_on(ray, root, dx, dy, abs(h), s);
        vec2 place = at.x.xz - middle;
        float signed_h = h < 0.0 ? -here : here;
        float inside = windrow_cloud_inside(coat.cloud, place, signed_h, windrow_cloud_heap(coat.cloud, place));
        if (!met) {
            hit.root = at;
            hit.height = signed_h;
            hit.on_way = s;
        }
        if (soft) {
            met = met || inside > 0.0;
            depth += windrow_cloud_thickness(coat.cloud.kind.z, inside, stretch / max(coat.shells.form.x, 1e-6));
            continue;
        }
        hit.coverage = n == 0 ? clamp(0.5 + inside / max(2.0 * pixel, 1e-4), 0.0, 1.0) : (inside > 0.0 ? 1.0 : 0.0);
        if (hit.coverage >= 0.5)
            break;
    }
    if (soft) {
        hit.coverage = 1.0 - exp(-depth);
        hit.thin = 1.0;
        hit.strand.key.x = turn;
    }
    return hit;
}

// The strand that the fragment shows; coverage 0: none. `chance` 0 to 1 is the pixel's own.
ShellHit shell_hit(ShellRoot root, ShellRoot dx, ShellRoot dy, float h, float map, ShellRay ray, float chance) {
    ShellHit hit;
    hit.root = root;
    hit.height = h;
    hit.map = map;
    hit.on_way = 0.0;
    float pixel = max(cells_across(dx, dy), 1e-4);
    float far = smoothstep(0.6, 1.4, pixel); // strands thinner than a pixel: their mean
    hit.thin = far;
    hit.coverage = 0.0;
    hit.strand = windrow_strand_none();
    bool grows = map >= coat.tousle.w && map > 0.0;
    if (far < 1.0 && grows && h <= map) {
        hit.strand = strand_at(root, h, map);
        hit.coverage = clamp(0.5 + hit.strand.inside / pixel, 0.0, 1.0);
    }
    ShellRoot end = root_on(ray, root, dx, dy, h, ray.reach);
    vec3 way = k_pattern == 1 ? end.x - root.x : vec3(end.uv - root.uv, 0.0);
    float crossed = coat.field.cells.x * length(way);
    if (far > 0.0 && grows) {
        float middle = 0.5 * (h + ray.target);
        float open = coat.drawing.x > 0 ? 1.0 + 2.0 * crossed : 1.0;
        float mean = 1.0 - pow(1.0 - min(mean_fraction(coat.drawing.x > 0 ? middle : h, map), 0.999), open);
        hit.coverage = mix(hit.coverage, mean, far);
    }
    if (hit.coverage >= 0.5 || far >= 1.0 || !k_march)
        return hit;

    int steps = clamp(int(2.0 * crossed + chance), 0, coat.drawing.x); // a ray that crosses less than half a cell: now and then
    for (int n = 0; n < steps; ++n) {
        float s = ray.reach * (float(n) + 0.5 + 0.5 * chance) / (float(steps) + 0.5);
        float here = height_on(ray, h, s);
        if (here < 0.0 || here > 1.0)
            break;
        ShellRoot at = root_on(ray, root, dx, dy, h, s);
        if (here > map)
            continue;
        WindrowStrandHit strand = strand_at(at, here, map);
        if (strand.inside > 0.0) {
            hit.strand = strand;
            hit.root = at;
            hit.height = here;
            hit.coverage = max(1.0 - far, hit.coverage);
            hit.on_way = s;
            break;
        }
    }
    return hit;
}

#endif
