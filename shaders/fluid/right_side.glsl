// Right-hand side of the direct solve, as a cell's value: see modes_forward.comp. Before this text: Arrived as `arrived`, Expansion as
// `expansion`.
#define WINDROW_SOLIDS 7
#include "fluid/solids.glsl"
#include "fluid/closed_divergence.glsl"
layout(std430, set = 0, binding = 8) readonly buffer Around {
    WindrowAround around;
    float around_words[];
};

#define WINDROW_MOTORS 6
#include "fluid/free_air.glsl"
#define WINDROW_FIELD(at) arrived[at]
#include "fluid/divergence.glsl"

const int k_of_sources = 1; // push.part: 0 the projection of w, 1 the flow of the volume sources

float load(ivec3 cell) {
    const int record = has_obstacles() ? solid_record(cell) : -1;
    if (k_obstacles && push.solve > 0) { // the residual, on the surface
        const int surface = record < 0 ? -1 : solid_words[record + 9];
        return surface < 0 ? 0.0f : around_words[WINDROW_SURFACE_WORDS * surface];
    }
    if (push.part == k_of_sources) {
        float rhs = 0.0f;
        if (is_on(WINDROW_EXPANDS)) {
            rhs = -tick.cell_size * expansion[cell_index(cell)];
            if (k_own_rows)
                rhs -= all_beyond(cell);
            for (int axis = 0; axis < 3 && !k_own_rows; ++axis)
                rhs -= beyond(cell, axis, -1) + beyond(cell, axis, 1);
        }
        if (record_is(record, WINDROW_SHUT))
            rhs = 0.0f;
        return rhs;
    }
    float rhs = 0.5f * differences(cell);
    if (k_outer)
        rhs += outer_right_side(cell);
    if (has_obstacles() && record < 0)
        rhs -= change_at(record);
    if (record >= 0) {
        rhs = closed_divergence(record, cell, rhs);
        const float guess = guess_scale();
        for (int face = 0; face < 6 && guess > 0.0f; ++face) {
            const int n = solid_words[record + 1 + face];
            if (n >= 0)
                rhs += exchange(cell, face / 2, face % 2) * (face % 2 == 1 ? guess : -guess) * around_words[solids.history + n];
        }
    }
    return rhs;
}
