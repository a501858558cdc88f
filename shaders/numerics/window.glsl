// Position of a world point in the box, and weight of the box's wind there.
//
// `local` is the position in cells from the box's low corner: (world - origin) / cell size; cell (i, j, k) has its centre
// at (i, j, k) + 1/2. Boundary kinds are numbers: 0 open, 1 closed by a wall, 2 periodic.
#ifndef WINDROW_WINDOW_GLSL
#define WINDROW_WINDOW_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// Share of the box's wind on one axis: 1 inside, falling to 0 over one cell beyond an open boundary; 1 beyond a wall.
WINDROW_FN float windrow_axis_fraction(float local, float cells, float low_kind, float high_kind) {
    float low = low_kind == 0.0f ? clamp(1.0f + local, 0.0f, 1.0f) : 1.0f;
    float high = high_kind == 0.0f ? clamp(1.0f + cells - local, 0.0f, 1.0f) : 1.0f;
    return low * high;
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

// Both shares of an axis; `reach` 0: no blend zone along it.
WINDROW_FN float windrow_axis_share(float local, float cells, float low_kind, float high_kind, float from_point, float reach,
                                    float width) {
    float blend = reach > 0.0f ? windrow_blend_fraction(from_point, reach, width) : 1.0f;
    return blend * windrow_axis_fraction(local, cells, low_kind, high_kind);
}

// Texel of an axis for one that may be -1 or `cells`: wrapped on a periodic axis, else the outermost.
WINDROW_FN int windrow_axis_texel(int texel, int cells, float low_kind) {
    if (low_kind == 2.0f)
        return texel < 0 ? cells - 1 : (texel < cells ? texel : 0);
    return clamp(texel, 0, cells - 1);
}

#endif
