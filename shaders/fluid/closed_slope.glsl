// Slopes of phi over closed faces. Before this text: solids.glsl, around.glsl.
#include "numerics/closed_face.glsl"

float slope_over(SolidFace face) {
    return windrow_closed_slope(face.closed, phi_at(cell_index(solid_cell(face.cell[0]))),
                                phi_at(cell_index(solid_cell(face.cell[1]))));
}

// What the closed faces of a cell take off its gradient; `above`: the differences over those at its high ends.
vec3 closed_slopes(int record, ivec3 cell, out vec3 above) {
    vec3 sum = vec3(0.0f);
    above = vec3(0.0f);
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            const int n = record_face(record, axis, end);
            if (n < 0)
                continue;
            const float slope = slope_over(solid_face(n));
            sum[axis] += 0.5f * slope;
            if (end == 1)
                above[axis] = slope;
        }
    if (k_own_rows)
        sum.y *= row_scale(cell.y);
    return sum;
}
