// Divergence of cells at obstacles. Before this text: solids.glsl, Arrived as `arrived`.
#include "numerics/closed_face.glsl"

// `empty`: the divergence of the empty box, times h.
float closed_divergence(int record, ivec3 cell, float empty) {
    if (record_is(record, WINDROW_SHUT))
        return 0.0f;
    float sum = empty;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            const int n = record_face(record, axis, side);
            if (n < 0)
                continue;
            const SolidFace face = solid_face(n);
            const ivec3 low = solid_cell(face.cell[0]), high = solid_cell(face.cell[1]);
            const int end = 1 - side; // of this cell
            float both = arrived[cell_index(low)][axis] + arrived[cell_index(high)][axis], past = 0.0f;
            if (is_on(WINDROW_GUSTS)) {
                const float time = elapsed() + WINDROW_OF_PLAN.substep_duration;
                const vec2 wind = vec2(wind_at(low, time, true)[axis], wind_at(high, time, true)[axis]);
                both += wind[0] + wind[1];
                if (face_end_is_sheltered(face, end))
                    past = windrow_blown_past(face.closed, wind[0] + wind[1], wind[side], face_end_is_sheltered(face, side));
            }
            float flux = windrow_closed_flux(face.closed, both, is_on(WINDROW_BODIES_MOVE) ? face.wall : 0.0f) - past;
            if (k_own_rows && axis == 1)
                flux *= row_scale(cell.y);
            sum += end == 0 ? -flux : flux;
        }
    return sum - change_at(record);
}

// Of the pressure's history, for the first solve.
float guess_scale() { return is_on(WINDROW_STABLE_FLUIDS) ? 1.0f : is_fresh() ? 0.0f : past().scale; }
