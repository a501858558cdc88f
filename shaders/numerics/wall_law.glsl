// The wind between a rough surface and the centres of the cells over it: the law of the wall, as a factor on what cells show.
//
//   s(d) = log(1 + d / z0) / log(1 + D / z0)      0 at the surface and below, 1 from the reach D on
//
// A cell at the height d shows u / s(d): the wind that the law has at D. Of a log profile that is the same in all cells, so that any
// interpolation of it is exact; a reader multiplies by s at its own height. Heights come with the cells, as their fourth component.
// They are heights where one roughness length z0 holds everywhere. With lengths by place they are d zm / z0, zm the longest of all.
// Based on: Prandtl 1925 and von Karman 1930 (the logarithmic law), shifted by z0 so that it begins at the ground.
#ifndef WINDROW_WALL_LAW_GLSL
#define WINDROW_WALL_LAW_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// s. `per_length`: 1 / z0; `per_log`: 1 / log(1 + D / z0), 0 where no law acts.
WINDROW_FN float windrow_wall_share(float height, float per_length, float per_log) {
    float share = min(log(1.0f + max(height, 0.0f) * per_length) * per_log, 1.0f);
    return per_log > 0.0f ? share : 1.0f;
}

// Height of a place from that between the centres around it: below the lowest centres, at `lowest` over the floor, nothing is
// interpolated. `over_floor`: of the place; `fall`: 1, or 0 where lengths differ by place and only the floor itself is where it is.
WINDROW_FN float windrow_wall_height(float between, float over_floor, float lowest, float fall) {
    float below = max(lowest - over_floor, 0.0f);
    return fall > 0.0f ? between - below : between * (1.0f - below / lowest);
}

#endif
