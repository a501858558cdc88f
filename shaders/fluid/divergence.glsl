// Sum of central differences over two cells of WINDROW_FIELD(at), a cell's value: 2 h times the divergence.
#include "fluid/stencil.glsl"

float differences(ivec3 cell) {
    vec3 d;
    for (int axis = 0; axis < 3; ++axis) {
        float below, above;
        const int low = cell_index(neighbour(cell, axis, -1, tick.velocity_low, tick.velocity_high, below));
        const int high = cell_index(neighbour(cell, axis, 1, tick.velocity_low, tick.velocity_high, above));
        d[axis] = above * WINDROW_FIELD(high)[axis] - below * WINDROW_FIELD(low)[axis];
    }
    if (k_own_rows)
        d.y *= row_scale(cell.y);
    return d.x + (d.y + d.z);
}
