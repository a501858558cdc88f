// Position of a world point in the box, and weight of the box's wind there.
//
// `local` is the position in cells from the box's low corner: (world - origin) / cell size; cell (i, j, k) has its centre
// at (i, j, k) + 1/2. Boundary kinds are numbers: 0 open, 1 closed by a wall, 2 periodic.
#ifndef WINDROW_WINDOW_GLSL
#define WINDROW_WINDOW_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// Share of the box's wind on one axis, by the distances from the two places where it has faded, in widths that it fades over: the
// nearer one counts. Linear with the smoothness 0, without a kink with 1.
WINDROW_FN float windrow_edge_share(float low, float high, float smoothness) {
    float t = clamp(min(low, high), 0.0f, 1.0f);
    return t + smoothness * (t * t * (3.0f - 2.0f * t) - t);
}

// Share of the box's wind near the rim of an axis along which the box follows a point: 1 up to `width` before `reach`, falling
// smoothly to 0 there. `from_point` is the distance from the point itself, not from the box, which jumps by cells: so a jump of
// the box moves nothing.
WINDROW_FN float windrow_blend_fraction(float from_point, float reach, float width) {
    float t = clamp((reach - abs(from_point)) / width, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// Position on one axis to sample at, in cells: wrapped on a periodic axis, else kept between the outermost centres.
WINDROW_FN float windrow_axis_sample(float local, float cells, float low_kind) {
    if (low_kind == 2.0f)
        return local - cells * floor(local / cells);
    return clamp(local, 0.5f, cells - 0.5f);
}

// Texel of an axis for one that may be -1 or `cells`: wrapped on a periodic axis, else the outermost.
WINDROW_FN int windrow_axis_texel(int texel, int cells, float low_kind) {
    if (low_kind == 2.0f)
        return texel < 0 ? cells - 1 : (texel < cells ? texel : 0);
    return clamp(texel, 0, cells - 1);
}

#endif
