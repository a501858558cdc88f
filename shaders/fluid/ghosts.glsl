// Cells inside bodies that a read from outside reaches: their value is a weighted sum of the air's around them, each slipping
// along the body's surface (SolidFlow::extend on the CPU). Before this text: prescribed.glsl.
#include "numerics/closed_face.glsl"
#include "numerics/slip.glsl"

AirTerm term_of(ivec3 cell, int record, int n) {
    if (term_count(record) > 0)
        return air_term(solid_words[record + 7] + n);
    AirTerm own;
    own.cell = cell;
    own.weight = 1.0f;
    own.normal = vec3(0.0f);
    own.wall = 0.0f;
    return own;
}

// The wall's velocity less the prescribed wind's.
float wall_of(AirTerm term, int record) {
    const bool blows = is_on(WINDROW_GUSTS) && !record_is(record, WINDROW_SHELTERED) && term.normal != vec3(0.0f);
    return term.wall - (blows ? dot(wind_at(term.cell, elapsed(), true), term.normal) : 0.0f);
}

int record_at(ivec3 cell) { return has_obstacles() ? solid_record(cell) : -1; }

// solved_part of a cell, inside of bodies too. One loop for both, since compilers copy what it calls into each place.
vec3 solved_cell(ivec3 cell, int record) {
    vec3 sum = vec3(0.0f);
    for (int n = 0; n < max(term_count(record), 1); ++n) {
        const AirTerm term = term_of(cell, record, n);
        sum += term.weight * windrow_slipped(solved_part(term.cell, cell_index(term.cell)), term.normal, wall_of(term, record));
    }
    return sum;
}
