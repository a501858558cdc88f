// Obstacles of a sub-step, as the host has rasterised them (fluid/solids/solids.h, fluid/vulkan/solid_tables.cpp).
//
// Cells at obstacles have a record. Records are in the order of the cells, and each row of x knows its first one, so that a row
// without obstacles costs two loads. A face between two cells is closed by a fraction. Before this text: WINDROW_SOLIDS, the
// binding of the tables.
#ifndef WINDROW_SOLIDS_GLSL
#define WINDROW_SOLIDS_GLSL

layout(std430, set = 0, binding = WINDROW_SOLIDS) readonly buffer Solids {
    WindrowSolids solids;
    int solid_words[];
};

float solid_float(int at) { return intBitsToFloat(solid_words[at]); }

// A cell as the host numbers it, and back.
int solid_number(ivec3 cell) { return linear_index(cell); }
ivec3 solid_cell(int number) {
    const int row = number / tick.cells.x;
    return ivec3(number - row * tick.cells.x, row % tick.cells.y, row / tick.cells.y);
}

// Where the record of a cell begins; -1: none.
int solid_record(ivec3 cell) {
    const int row = solids.rows + cell.z * tick.cells.y + cell.y;
    const int last = solid_words[row + 1];
    int first = solid_words[row], end = last;
    while (first < end) {
        const int middle = (first + end) / 2;
        if (solid_words[solids.columns + middle] < cell.x)
            first = middle + 1;
        else
            end = middle;
    }
    return first < last && solid_words[solids.columns + first] == cell.x ? solids.records + WINDROW_RECORD * first : -1;
}

int record_flags(int record) { return record < 0 ? 0 : solid_words[record]; }
bool record_is(int record, int flag) { return (record_flags(record) & flag) != 0; }
int record_body(int record) { return solid_words[record] >> WINDROW_BODY_SHIFT; }
// Of the face at the low (0) or high (1) end of an axis; -1: open.
int record_face(int record, int axis, int end) { return solid_words[record + 1 + 2 * axis + end]; }

// [m/s] What sealed air takes of its change of volume, of the divergence times h, in each cell.
float change_at(int record) { return record < 0 ? solids.other_change : solid_float(record + 10); }

struct SolidFace {
    int cell[2];    // low and high, numbers
    int surface[2]; // the same among the surface cells
    float closed;   // fraction
    float wall;     // [m/s] closed times the body's own velocity along the axis
    int axis;
    int flags; // WINDROW_LOW_...; the same shifted by one for the high cell
    int body;
    float facing[2]; // of `closed`, what is a wall across the axis in each cell
};

SolidFace solid_face(int n) {
    const int at = solids.faces + WINDROW_FACE * n;
    SolidFace face;
    face.cell[0] = solid_words[at];
    face.cell[1] = solid_words[at + 1];
    face.surface[0] = solid_words[at + 2];
    face.surface[1] = solid_words[at + 3];
    face.closed = solid_float(at + 4);
    face.wall = solid_float(at + 5);
    const int packed = solid_words[at + 6];
    face.axis = packed & 3;
    face.flags = packed;
    face.body = solid_words[at + 7];
    face.facing[0] = solid_float(at + 8);
    face.facing[1] = solid_float(at + 9);
    return face;
}

bool face_is_no_slip(SolidFace face) { return (face.flags & WINDROW_FACE_NO_SLIP) != 0; }
bool face_end_is_shut(SolidFace face, int end) { return (face.flags & (WINDROW_LOW_SHUT << end)) != 0; }
bool face_end_is_sheltered(SolidFace face, int end) { return (face.flags & (WINDROW_LOW_SHELTERED << end)) != 0; }

// Of the value of a cell inside that a read from outside reaches (ghosts.glsl).
struct AirTerm {
    ivec3 cell;
    float weight;
    vec3 normal; // across the surface; 0: none
    float wall;  // [m/s] the body's velocity along it
};

AirTerm air_term(int n) {
    const int at = solids.terms + WINDROW_TERM * n;
    AirTerm term;
    term.cell = solid_cell(solid_words[at]);
    term.weight = solid_float(at + 1);
    term.normal = vec3(solid_float(at + 2), solid_float(at + 3), solid_float(at + 4));
    term.wall = solid_float(at + 5);
    return term;
}

// Terms of a cell with this record; none for air and for cells deep inside, which are their own.
int term_count(int record) { return record < 0 ? 0 : solid_words[record + 8]; }

vec3 solid_vec3(int at) { return vec3(solid_float(at), solid_float(at + 1), solid_float(at + 2)); }

// [m/s] Of a body's own point at a place [m from the box's low corner].
vec3 body_velocity(int body, vec3 place) {
    const int at = solids.bodies + WINDROW_BODY * body;
    return solid_vec3(at) + cross(solid_vec3(at + 3), place - solid_vec3(at + 6));
}

// A byte of a cell: its blocked faces, what it is, and the reach of a read that may pass through a sub-grid body.
int solid_byte(int number) { return solid_words[solids.bytes + (number >> 2)] >> (8 * (number & 3)) & 255; }

#endif
