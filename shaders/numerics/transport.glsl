// Departure point of a trajectory, and interpolation weights there.
//
// Displacements are kept apart from the cell's index, so that a flow gives the same bits wherever in the box it is. Interpolation
// is written as c + sum w (value - c): float weights do not sum to 1, and a uniform wind must stay uniform to the bit. The
// kernels of the CPU (fluid/cpu/kernels/advect.inl) do the same to many cells at once; tests hold the two together.
// Based on: Staniforth & Cote 1991, Monthly Weather Review 119.
#ifndef WINDROW_TRANSPORT_GLSL
#define WINDROW_TRANSPORT_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// A place on one axis: the whole cell below it and the distance from its centre, 0 to 1.
struct WindrowPlace {
    float base;
    float fraction;
};

// A cell's own index plus a displacement, both in cells, kept between `low` and `high` and wrapped where `period` is not 0. A
// displacement that is NaN becomes the low end: its address stays legal.
WINDROW_FN WindrowPlace windrow_place(float cell, float displacement, float low, float high, float period, float inverse_period) {
    float least = low - cell;
    float most = high - cell;
    float legal = displacement > least ? displacement : least;
    legal = legal < most ? legal : most;
    float whole = floor(legal);
    WindrowPlace place;
    place.fraction = legal - whole;
    place.base = cell + whole;
    place.base -= period * floor(place.base * inverse_period);
    return place;
}

// The cell of an axis that one beyond its ends repeats, continues or, at a wall, mirrors.
WINDROW_FN int windrow_cell_beyond(int cell, int count, bool periodic, bool open) {
    if (periodic)
        return (cell % count + count) % count;
    return clamp(open ? cell : cell < 0 ? -1 - cell : 2 * count - 1 - cell, 0, count - 1);
}

// Lagrange weights of the nodes -1, 1 and 2 at t in [0, 1]; node 0 takes what is left of 1.
WINDROW_FN vec3 windrow_cubic_weights(float t) {
    float a = t - 1.0f;
    float b = t - 2.0f;
    float c = t + 1.0f;
    return vec3(t * a * b * (-1.0f / 6.0f), c * t * b * -0.5f, c * t * a * (1.0f / 6.0f));
}

#endif
