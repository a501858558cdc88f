// A grid of floats over level ground: the heights of a terrain, the alpha of a mask. Values stand at the corners of its texels.
//
//   f(x, z)   bilinear between four corners; beyond the edge as on it       error O(d^2) where f is smooth, d the spacing
//   t(x, z)   two flat triangles a texel, which meet along the edge from its +x to its +z corner: what a renderer draws. Between
//             f and t lies at most a quarter of the texel's twist |f_ll - f_hl - f_lh + f_hh|, in its middle
//   s(x, z)   slopes (df/dx, df/dz): central differences at the corners, one-sided on the edge; bilinear between: no crease
//             at a texel's border, as the bilinear patch itself has           error O(d^2) inside
//   normal    (-s_x, 1, -s_z), normalised
//
// Places are [m] from the grid's first corner. Blends are a + t (b - a): equal ends give themselves, so level ground is level to
// the bit. A language that keeps the values elsewhere than in a sampler2D defines WINDROW_GRID, the type of the parameter that
// stands for them, and windrow_grid_value, before this text.
#ifndef WINDROW_HEIGHT_GRID_GLSL
#define WINDROW_HEIGHT_GRID_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#ifndef WINDROW_GRID
#define WINDROW_GRID sampler2D
// One value; the corner lies within the grid, which is `across` corners wide.
WINDROW_FN float windrow_grid_value(WINDROW_GRID grid, ivec2 corner, int across) { return texelFetch(grid, corner, 0).x; }
#endif

struct WindrowGrid {
    ivec2 corners; // along x and z, each 2 or more
    vec2 spacing;  // [m] above 0
};

// The corner below a place, and how far beyond it the place lies, in texels 0 to 1.
struct WindrowGridPlace {
    ivec2 low;
    vec2 between;
};

WINDROW_FN WindrowGridPlace windrow_grid_place(WindrowGrid size, vec2 p) {
    vec2 last = vec2(size.corners - 1);
    vec2 at = clamp(p / size.spacing, vec2(0.0f), last);
    vec2 below = min(floor(at), last - 1.0f);
    WindrowGridPlace place;
    place.low = clamp(ivec2(below), ivec2(0), size.corners - 2); // within the grid for a p that is no number, too
    place.between = at - below;
    return place;
}

WINDROW_FN float windrow_grid_blend(float a, float b, float t) { return a + t * (b - a); }

WINDROW_FN float windrow_grid_at(WINDROW_GRID grid, WindrowGrid size, vec2 p) {
    WindrowGridPlace place = windrow_grid_place(size, p);
    int across = size.corners.x;
    float near_side = windrow_grid_blend(windrow_grid_value(grid, place.low, across),
                                         windrow_grid_value(grid, place.low + ivec2(1, 0), across), place.between.x);
    float far_side = windrow_grid_blend(windrow_grid_value(grid, place.low + ivec2(0, 1), across),
                                        windrow_grid_value(grid, place.low + ivec2(1, 1), across), place.between.x);
    return windrow_grid_blend(near_side, far_side, place.between.y);
}

// On the triangles that are drawn.
WINDROW_FN float windrow_grid_drawn_at(WINDROW_GRID grid, WindrowGrid size, vec2 p) {
    WindrowGridPlace place = windrow_grid_place(size, p);
    int across = size.corners.x;
    float along_x = windrow_grid_value(grid, place.low + ivec2(1, 0), across);
    float along_z = windrow_grid_value(grid, place.low + ivec2(0, 1), across);
    vec2 t = place.between;
    bool low = t.x + t.y <= 1.0f;
    float corner = windrow_grid_value(grid, low ? place.low : place.low + 1, across);
    return low ? corner + t.x * (along_x - corner) + t.y * (along_z - corner)
               : corner + (1.0f - t.x) * (along_z - corner) + (1.0f - t.y) * (along_x - corner);
}

// Slopes at a corner.
WINDROW_FN vec2 windrow_grid_corner_slope(WINDROW_GRID grid, WindrowGrid size, ivec2 corner) {
    ivec2 low = max(corner - 1, ivec2(0));
    ivec2 high = min(corner + 1, size.corners - 1);
    int across = size.corners.x;
    float x =
        windrow_grid_value(grid, ivec2(high.x, corner.y), across) - windrow_grid_value(grid, ivec2(low.x, corner.y), across);
    float z =
        windrow_grid_value(grid, ivec2(corner.x, high.y), across) - windrow_grid_value(grid, ivec2(corner.x, low.y), across);
    return vec2(x, z) / (vec2(high - low) * size.spacing);
}

WINDROW_FN vec2 windrow_grid_slope(WINDROW_GRID grid, WindrowGrid size, vec2 p) {
    WindrowGridPlace place = windrow_grid_place(size, p);
    vec2 a = windrow_grid_corner_slope(grid, size, place.low);
    vec2 b = windrow_grid_corner_slope(grid, size, place.low + ivec2(1, 0));
    vec2 c = windrow_grid_corner_slope(grid, size, place.low + ivec2(0, 1));
    vec2 d = windrow_grid_corner_slope(grid, size, place.low + ivec2(1, 1));
    vec2 near_side = a + place.between.x * (b - a);
    vec2 far_side = c + place.between.x * (d - c);
    return near_side + place.between.y * (far_side - near_side);
}

WINDROW_FN vec3 windrow_grid_normal(WINDROW_GRID grid, WindrowGrid size, vec2 p) {
    vec2 slope = windrow_grid_slope(grid, size, p);
    return normalize(vec3(-slope.x, 1.0f, -slope.y));
}

#endif
