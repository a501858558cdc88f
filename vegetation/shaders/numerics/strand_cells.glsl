// Where strands stand: one jittered point a cell of a lattice in the plane. Tufts: one a cell of a lattice in space.
//
//   plane    p(c) = c + 1/2 - (s (c.y mod 2), 0) + j/2 (a + b, a - b)     a, b from -1/2 to 1/2: the point stays in a diamond
//   wriggle  a = (1 - w) a_0 + w/2 sin 2 pi (b_0 + phase), b likewise      points that wander, never out of their diamond
//   nearest  n = argmin |q - p|                                            3 x 3 cells
//   edge     e = min over m of (|q - m|^2 - |q - n|^2) / (2 |m - n|)       0 or more: the distance to the nearest bisector
//
// Why a diamond: from any q the own cell's point is then never farther than the nearest that a cell two away can hold (both are
// at sqrt(5/4) where they meet), so that 3 x 3 cells give the nearest point exactly, also with rows shifted by half a cell; in a
// square of the same width one needs 4 x 4. The edge's bisector can belong to a point farther off: never among 1e5 places at rest
// (vegetation/tests/fur/strand_cells_test.cpp).
//
// Values in cells. A cell's key is a bijection of the cell: no other cell of the plane has it.
// Based on: Worley 1996, A cellular texture basis function; Quilez 2012, Voronoi edges (the bisector distance).
#ifndef WINDROW_STRAND_CELLS_GLSL
#define WINDROW_STRAND_CELLS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "space_hash.glsl"
#include "../../../shaders/numerics/turn_sine.glsl"

struct WindrowStrandLattice {
    float jitter;  // j, 0 the grid to 1
    float wriggle; // w, 0 at rest to 1
    float phase;   // [turns]
    float shift;   // s, 0 to 1/2
    uint seed;
};

struct WindrowStrandCell {
    vec2 offset; // from the nearest point to the place
    vec2 facet;  // unit vector from it to the nearest edge
    float edge;  // distance to that edge
    uvec2 key;
};

WINDROW_FN uvec2 windrow_strand_key(uint seed, ivec2 cell) {
    return windrow_plant_hash(uvec2(cell) + uvec2(seed * 0x9e3779b9u, seed * 0x85ebca6bu));
}

// Two more chances of a key, 0 to 1, beside windrow_fraction of its words, which place the point.
WINDROW_FN float windrow_strand_chance(uvec2 key) { return windrow_fraction((key.x << 11u) ^ (key.y * 2654435761u)); }
WINDROW_FN float windrow_strand_other_chance(uvec2 key) { return windrow_fraction((key.y << 13u) ^ (key.x * 2246822519u)); }

// The cell that holds q in the row `rows` above q's own.
WINDROW_FN ivec2 windrow_strand_home(WindrowStrandLattice lattice, vec2 q, int rows) {
    int row = int(floor(q.y)) + rows;
    return ivec2(int(floor(q.x + lattice.shift * float(row & 1))), row);
}

WINDROW_FN vec2 windrow_strand_centre(WindrowStrandLattice lattice, ivec2 cell) {
    return vec2(float(cell.x) + 0.5f - lattice.shift * float(cell.y & 1), float(cell.y) + 0.5f);
}

// From the cell's centre to its point.
WINDROW_FN vec2 windrow_strand_jitter(WindrowStrandLattice lattice, uvec2 key) {
    float a = windrow_fraction(key.x) - 0.5f;
    float b = windrow_fraction(key.y) - 0.5f;
    if (lattice.wriggle > 0.0f) {
        float wave = 0.5f * windrow_turn_sine(b + lattice.phase);
        b = mix(b, 0.5f * windrow_turn_sine(a + lattice.phase), lattice.wriggle);
        a = mix(a, wave, lattice.wriggle);
    }
    return 0.5f * lattice.jitter * vec2(a + b, a - b);
}

// The nearest point of all; its edge only if `edges`, else 0.
WINDROW_FN WindrowStrandCell windrow_strand_nearest(WindrowStrandLattice lattice, vec2 q, bool edges) {
    WindrowStrandCell found;
    found.offset = vec2(0.0f);
    found.facet = vec2(0.0f);
    found.edge = 0.0f;
    found.key = uvec2(0u);
    if (lattice.jitter <= 0.0f && lattice.shift <= 0.0f) {
        ivec2 cell = windrow_strand_home(lattice, q, 0);
        found.key = windrow_strand_key(lattice.seed, cell);
        found.offset = q - windrow_strand_centre(lattice, cell);
        vec2 far = abs(found.offset);
        found.edge = max(0.5f - max(far.x, far.y), 0.0f);
        found.facet =
            far.x > far.y ? vec2(found.offset.x < 0.0f ? -1.0f : 1.0f, 0.0f) : vec2(0.0f, found.offset.y < 0.0f ? -1.0f : 1.0f);
        return found;
    }
    vec2 offsets[9];
    float least = 1e9f;
    int nearest = 0;
    for (int n = 0; n < 9; ++n) {
        ivec2 cell = windrow_strand_home(lattice, q, n / 3 - 1) + ivec2(n % 3 - 1, 0);
        uvec2 key = windrow_strand_key(lattice.seed, cell);
        vec2 offset = q - windrow_strand_centre(lattice, cell) - windrow_strand_jitter(lattice, key);
        offsets[n] = offset;
        float square = dot(offset, offset);
        if (square < least) {
            least = square;
            nearest = n;
            found.offset = offset;
            found.key = key;
        }
    }
    if (!edges)
        return found;
    found.edge = 1e9f;
    for (int n = 0; n < 9; ++n) {
        vec2 between = found.offset - offsets[n]; // from the nearest point to this one
        float apart = dot(between, between);
        if (n == nearest || !(apart > 1e-12f))
            continue;
        float per = 1.0f / sqrt(apart);
        // The bisector's distance, without a difference of large squares: (m - n) . ((m + n) / 2 - q) / |m - n|.
        float edge = -0.5f * per * dot(between, found.offset + offsets[n]);
        if (edge < found.edge) {
            found.edge = edge;
            found.facet = between * per;
        }
    }
    found.edge = max(found.edge, 0.0f);
    return found;
}

struct WindrowTuft {
    vec3 offset; // from the nearest middle to the place
    uvec2 key;
};

// The nearest of the scattered middles in space. With 0.2 of a cell of jitter an axis the own cell's is within 1.22, and none
// three cells wide away is nearer than 1.3.
WINDROW_FN WindrowTuft windrow_space_tuft(uint seed, vec3 q) {
    ivec3 home = ivec3(floor(q));
    WindrowTuft found;
    found.offset = vec3(0.0f);
    found.key = uvec2(0u);
    float least = 1.5f;
    for (int n = 0; n < 27; ++n) {
        ivec3 cell = home + ivec3(n % 3, (n / 3) % 3, n / 9) - 1;
        vec3 away = q - (vec3(cell) + 0.5f);
        if (dot(away, away) > 2.46f) // (1.22 + 0.35)^2
            continue;
        uvec2 key = windrow_space_hash(seed, cell);
        vec3 chance = vec3(windrow_fraction(key.x), windrow_fraction(key.y), windrow_strand_chance(key));
        vec3 offset = away - 0.4f * (chance - 0.5f);
        float square = dot(offset, offset);
        if (square < least) {
            least = square;
            found.offset = offset;
            found.key = key;
        }
    }
    return found;
}

#endif
