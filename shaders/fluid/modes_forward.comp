// First stage of a direct solve: the right-hand side, made here, to modes of x and z.
//
//   projection        rhs = (differences of w) / 2        (phi / h, so that no h appears; w is without the sources' flow)
//   volume sources    rhs = -h S, less phi beyond open boundaries
//   obstacles         the divergence with closed faces, plus what they hold of the last step's phi; in corrections the residual
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 9
#include "fluid/pass.glsl"
#include "fluid/hat.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) readonly buffer Arrived { vec4 arrived[]; };
layout(std430, set = 0, binding = 4) readonly buffer Expansion { float expansion[]; };
layout(std430, set = 0, binding = 5) writeonly buffer Hat { float hat[]; };

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

void store(ivec3 mode, float value) { hat[hat_index(mode)] = value; }

#include "fluid/modes.glsl"
