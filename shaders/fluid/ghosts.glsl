// Cells inside bodies that a read from outside reaches: their value is a weighted sum of the air's around them, each mirrored about
// the body's own velocity across the closed face (SolidFlow::extend on the CPU). Before this text: given.glsl.

struct AirTerm {
    ivec3 cell;
    int axis; // across the closed face; 3: none
    float weight, closed, wall;
};

AirTerm air_term(int n) {
    const int at = solids.terms + WINDROW_TERM * n;
    const uint packed = uint(solid_words[at]);
    AirTerm term;
    term.cell = solid_cell(int(packed & ((1u << WINDROW_TERM_AXIS_SHIFT) - 1u)));
    term.axis = int(packed >> WINDROW_TERM_AXIS_SHIFT);
    term.weight = solid_float(at + 1);
    term.closed = solid_float(at + 2);
    term.wall = solid_float(at + 3);
    return term;
}

// Terms of a cell with this record; none for air and for cells deep inside, which are their own.
int term_count(int record) { return record < 0 ? 0 : solid_words[record + 8]; }
AirTerm term_of(ivec3 cell, int record, int n) {
    if (term_count(record) > 0)
        return air_term(solid_words[record + 7] + n);
    AirTerm own;
    own.cell = cell;
    own.axis = 3;
    own.weight = 1.0f;
    own.closed = own.wall = 0.0f;
    return own;
}

vec3 mirrored(vec3 value, AirTerm term, float wall) {
    if (term.axis < 3)
        value[term.axis] += 2.0f * term.closed * (wall - value[term.axis]);
    return value;
}

// The wall's velocity less the prescribed wind's.
float wall_of(AirTerm term, int record) {
    if (term.axis == 3)
        return 0.0f;
    const bool blows = is_on(WINDROW_GUSTS) && !record_is(record, WINDROW_SHELTERED);
    return term.wall - (blows ? wind_at(term.cell, elapsed(), true)[term.axis] : 0.0f);
}

int record_at(ivec3 cell) { return has_obstacles() ? solid_record(cell) : -1; }

// solved_part of a cell, inside of bodies too. One loop for both, since compilers copy what it calls into each place.
vec3 solved_cell(ivec3 cell, int record) {
    vec3 sum = vec3(0.0f);
    for (int n = 0; n < max(term_count(record), 1); ++n) {
        const AirTerm term = term_of(cell, record, n);
        sum += term.weight * mirrored(solved_part(term.cell, cell_index(term.cell)), term, wall_of(term, record));
    }
    return sum;
}
