// One-sided reads beside closed faces: a trajectory and an interpolation that pass none.
//
//   trajectory   straight; from a closed face on along the face
//   read         own + sum w (value - own), w the Lagrange weights of the 8 or 64 nodes around a point
//   value        what is stored, in a node that a path from the point's own cell reaches: one that never turns back along an axis
//                and passes open faces only. Else the mean over the axes of the values one node nearer to the point, whose
//                velocity across a closed face is mirrored about the wall's: 2 U - u
//
// So a plate without thickness separates the air on its two sides. Values are at cell centres. Order of the plain read where all
// nodes are reached. The sum is about the own node's value: a uniform wind stays uniform to the bit.
//
// What keeps the cells defines what is declared below: in GLSL behind this text, in C++ before it, with WINDROW_AIR.
// Based on: Guendelman, Selle, Losasso & Fedkiw 2005, ACM Transactions on Graphics 24 (one-sided interpolation at thin shells).
#ifndef WINDROW_ONE_SIDED_GLSL
#define WINDROW_ONE_SIDED_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif
#include "ambient.glsl"
#include "transport.glsl"

#ifndef WINDROW_AIR
#define WINDROW_AIR bool // which air it is: that of a closed room
#define WINDROW_FIELD WindrowSidedField
#define WINDROW_FIELD_FN // of functions of a field
#define WINDROW_VALUE vec3
#define WINDROW_MARK inout bool
struct WindrowSidedField {
    WINDROW_AIR air;
    int first; // where it begins
};
vec3 windrow_lowest(WINDROW_AIR air); // legal places [cells]
vec3 windrow_highest(WINDROW_AIR air);
int windrow_cell_within(WINDROW_AIR air, int cell, int axis);    // the cell of the box that one beyond it stands for
bool windrow_blocked(WINDROW_AIR air, ivec3 low_cell, int axis); // whether a face is closed; x below 0: none of the box
float windrow_wall_across(WINDROW_FIELD field, ivec3 low_cell, ivec3 cell, int axis); // U there, as the field has it
bool windrow_is_velocity(WINDROW_FIELD field);                                        // or a scalar
bool windrow_is_clamped(
    WINDROW_FIELD field); // whether a read stays among the eight values around its point, which cubic weights leave
WINDROW_VALUE windrow_stored(WINDROW_FIELD field, ivec3 cell);
#endif

// A point of a trajectory: the cell that holds it, and its distance from the first cell's centre, in cells.
struct WindrowWaypoint {
    ivec3 cell;
    vec3 place;
};

// The nodes of a read at a point.
struct WindrowNodes {
    ivec3 base;      // the cell of node 1 on each axis; nodes 0 to 3 follow each other
    ivec3 own;       // the node of the point's own cell, 1 or 2
    int first;       // 0 cubic, 1 linear
    int count;       // 4 or 2
    bool of_32;      // of the 64 nodes those alone that a linear read has along two axes (Interpolation::cubic_32)
    vec3 weights[4]; // by node, of each axis
    vec3 between;    // the weights of node 2 in a linear read
};

const int windrow_most_crossings = 512;

// The low cell of the face at a cell's low (-1) or high (1) side; x is -1 where no such face is in the box.
WINDROW_FN ivec3 windrow_low_cell(WINDROW_AIR air, ivec3 cell, int axis, int side) {
    int next = windrow_cell_within(air, cell[axis] + side, axis);
    for (int a = 0; a < 3; ++a)
        cell[a] = windrow_cell_within(air, cell[a], a);
    int apart = next - cell[axis];
    if (apart == 0)
        return ivec3(-1);
    bool across = apart != 1 && apart != -1; // a periodic boundary
    if (across ? apart > 0 : apart < 0)
        cell[axis] = next;
    return cell;
}

WINDROW_FN vec3 windrow_legal(WINDROW_AIR air, ivec3 from, vec3 displacement) {
    vec3 way = min(max(displacement, windrow_lowest(air) - vec3(from)), windrow_highest(air) - vec3(from));
    for (int axis = 0; axis < 3; ++axis)
        if (windrow_not_finite(way[axis]))
            way[axis] = 0.0f;
    return way;
}

// Where a displacement from a cell's centre ends. `stopped` is set where a closed face was met.
WINDROW_FN WindrowWaypoint windrow_slide(WINDROW_AIR air, ivec3 from, vec3 displacement, WINDROW_MARK stopped) {
    vec3 left = windrow_legal(air, from, displacement);
    WindrowWaypoint at;
    at.cell = from;
    at.place = vec3(0.0f);
    for (int crossed = 0; crossed < windrow_most_crossings; ++crossed) {
        int axis = -1;
        float way = 1.0f;
        for (int a = 0; a < 3; ++a) {
            if (left[a] == 0.0f)
                continue;
            float face = float(at.cell[a] - from[a]) + (left[a] > 0.0f ? 0.5f : -0.5f);
            float part = (face - at.place[a]) / left[a];
            if (part < way) {
                way = part;
                axis = a;
            }
        }
        way = max(way, 0.0f);
        at.place += way * left;
        if (axis < 0)
            break;
        left *= 1.0f - way;
        if (left[axis] == 0.0f)
            continue;
        int side = left[axis] > 0.0f ? 1 : -1;
        if (windrow_blocked(air, windrow_low_cell(air, at.cell, axis, side), axis)) {
            stopped = true;
            left[axis] = 0.0f;
        } else {
            at.cell[axis] += side;
        }
    }
    return at;
}

// The same through closed faces.
WINDROW_FN WindrowWaypoint windrow_straight(WINDROW_AIR air, ivec3 from, vec3 displacement) {
    WindrowWaypoint at;
    at.place = windrow_legal(air, from, displacement);
    at.cell = from + ivec3(floor(at.place + 0.5f));
    return at;
}

WINDROW_FN WindrowNodes windrow_nodes(ivec3 from, WindrowWaypoint at, bool cubic, bool of_32) {
    vec3 whole = floor(at.place);
    vec3 t = at.place - whole;
    WindrowNodes nodes;
    nodes.base = from + ivec3(whole);
    nodes.own = clamp(at.cell - nodes.base, ivec3(0), ivec3(1)) + 1;
    nodes.first = cubic ? 0 : 1;
    nodes.count = cubic ? 4 : 2;
    nodes.of_32 = of_32;
    nodes.between = t;
    nodes.weights[0] = vec3(0.0f);
    nodes.weights[2] = t;
    nodes.weights[3] = vec3(0.0f);
    for (int axis = 0; axis < 3 && cubic; ++axis) {
        vec3 weights = windrow_cubic_weights(t[axis]);
        nodes.weights[0][axis] = weights.x;
        nodes.weights[2][axis] = weights.y;
        nodes.weights[3][axis] = weights.z;
    }
    nodes.weights[1] = 1.0f - (nodes.weights[0] + nodes.weights[2] + nodes.weights[3]);
    return nodes;
}

WINDROW_FN float windrow_linear_weight(float between, int node) {
    return node == 1 ? 1.0f - between : node == 2 ? between : 0.0f;
}

WINDROW_FN float windrow_weight(WindrowNodes nodes, int x, int y, int z) {
    if (!nodes.of_32)
        return nodes.weights[z].z * nodes.weights[y].y * nodes.weights[x].x;
    float lx = windrow_linear_weight(nodes.between.x, x), ly = windrow_linear_weight(nodes.between.y, y),
          lz = windrow_linear_weight(nodes.between.z, z);
    return nodes.weights[x].x * ly * lz + lx * ((nodes.weights[y].y - ly) * lz + ly * (nodes.weights[z].z - lz));
}

// Nodes 0 to 3 in an order in which the own one, 1 or 2, comes first: 1, 2, 0, 3, or mirrored.
WINDROW_FN int windrow_outward(int own, int n) {
    int node = n < 2 ? n + 1 : 3 * n - 6;
    return own == 1 ? node : 3 - node;
}

// `all`: every node counts as reached. `mixed` is set where one was not.
WINDROW_FIELD_FN WINDROW_VALUE windrow_one_sided(WINDROW_FIELD field, WindrowNodes nodes, bool all, WINDROW_MARK mixed) {
    WINDROW_VALUE values[64];
    uvec2 reached = uvec2(0u); // a bit a node: for an array of bools Mesa's compiler for AMD takes 24 GB and more than a minute
    for (int k = 0; k < nodes.count; ++k)
        for (int j = 0; j < nodes.count; ++j)
            for (int i = 0; i < nodes.count; ++i) {
                ivec3 node =
                    ivec3(windrow_outward(nodes.own.x, i), windrow_outward(nodes.own.y, j), windrow_outward(nodes.own.z, k));
                ivec3 cell = nodes.base + node - 1;
                bool here = all || node == nodes.own;
                WINDROW_VALUE sum = WINDROW_VALUE(0.0f);
                float count = 0.0f;
                for (int axis = 0; axis < 3 && !here; ++axis) {
                    if (node[axis] == nodes.own[axis])
                        continue;
                    int back = node[axis] > nodes.own[axis] ? -1 : 1;
                    ivec3 before = node;
                    before[axis] += back;
                    int source = (before.z * 4 + before.y) * 4 + before.x;
                    ivec3 low = windrow_low_cell(field.air, cell, axis, back);
                    bool had = (reached[source >> 5] >> (source & 31) & 1u) != 0u;
                    bool blocked = windrow_blocked(field.air, low, axis);
                    here = had && !blocked;
                    sum += values[source];
                    if (had && blocked && windrow_is_velocity(field))
                        sum[axis] += 2.0f * (windrow_wall_across(field, low, cell, axis) - values[source][axis]);
                    count += 1.0f;
                }
                int n = (node.z * 4 + node.y) * 4 + node.x;
                if (here) {
                    reached[n >> 5] |= 1u << (n & 31);
                    values[n] = windrow_stored(field, cell);
                } else {
                    mixed = true;
                    values[n] = sum / count;
                }
            }
    WINDROW_VALUE own = values[(nodes.own.z * 4 + nodes.own.y) * 4 + nodes.own.x];
    WINDROW_VALUE sum = WINDROW_VALUE(0.0f), least = own, most = own;
    int end = nodes.first + nodes.count;
    for (int z = nodes.first; z < end; ++z)
        for (int y = nodes.first; y < end; ++y)
            for (int x = nodes.first; x < end; ++x)
                sum += windrow_weight(nodes, x, y, z) * (values[(z * 4 + y) * 4 + x] - own);
    if (!windrow_is_clamped(field))
        return own + sum;
    for (int corner = 0; corner < 8; ++corner) {
        WINDROW_VALUE value = values[((1 + (corner >> 2)) * 4 + 1 + (corner >> 1 & 1)) * 4 + 1 + (corner & 1)];
        least = min(least, value);
        most = max(most, value);
    }
    return clamp(own + sum, least, most);
}

#endif
