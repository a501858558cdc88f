// How a tree thins out with distance: leaf by leaf, those that stay growing wider.
//
//   keep(d) = clamp((d_near / d)^p, least, 1)              share of the leaves at full size; p takes it from 1 at d_near to
//                                                          `least` at d_far
//   shown(r) = clamp((keep (1 + b) - r) / (b keep), 0, 1)  a leaf's size by its rank r, 0 to 1: the last ones shrink before
//                                                          they go
//   A = integral over r of shown^2,  wide = A^(-q)         of all sizes, in closed form. q = 1/2 keeps the leaves' area; less,
//                                                          since in a crown of several layers most of it is hidden: the outline
//                                                          needs one
//   stem = clamp(radius / (d min_angle) - 1, 0, 1) clamp((1 - d / d_far) / 0.3, 0, 1)
//                                                          a branch shrinks to its middle line while its radius is two to one
//                                                          least angles, and before d_far, where leaves hide it
//   morph = smoothstep(0.6 d_coarse, d_coarse, d)          of the trunk's fine rings into the coarse ones, which then take over
//
// Every one is continuous in d: nothing pops. Distances [m] are of a tree of size 1: divide by a tree's size.
#ifndef WINDROW_TREE_LEVELS_GLSL
#define WINDROW_TREE_LEVELS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// Usable in std140.
struct WindrowTreeLevels {
    vec4 leaves; // x [m] d_near, y p, z least, w b
    vec4 stems;  // x [rad] least angle of a branch's radius; y [m] d_far; z q; w [m] d_coarse
};

WINDROW_FN float windrow_tree_keep(WindrowTreeLevels levels, float distance) {
    float near = levels.leaves.x;
    return distance <= near ? 1.0f : max(pow(near / distance, levels.leaves.y), levels.leaves.z);
}

// Share of the leaves, the first by rank, that have any size.
WINDROW_FN float windrow_tree_drawn(WindrowTreeLevels levels, float keep) { return min(keep * (1.0f + levels.leaves.w), 1.0f); }

// Factor on a leaf's length and width.
WINDROW_FN float windrow_leaf_scale(WindrowTreeLevels levels, float keep, float rank) {
    float band = levels.leaves.w * keep;
    float shown = clamp((keep + band - rank) / band, 0.0f, 1.0f);
    float cut = max(keep + band - 1.0f, 0.0f) / band; // size of the last leaf
    float area = keep + band * (1.0f - cut * cut * cut) / 3.0f;
    return shown * pow(area, -levels.stems.z);
}

// Factor on a branch's thickness; the trunk, told by a radius below 0, stays.
WINDROW_FN float windrow_stem_scale(WindrowTreeLevels levels, float distance, float radius) {
    if (radius < 0.0f)
        return 1.0f;
    float thick = clamp(radius / (max(distance, 1e-3f) * levels.stems.x) - 1.0f, 0.0f, 1.0f);
    return thick * clamp((1.0f - distance / levels.stems.y) / 0.3f, 0.0f, 1.0f);
}

// Share of the way from the fine trunk to the coarse one.
WINDROW_FN float windrow_trunk_morph(WindrowTreeLevels levels, float distance) {
    float t = clamp((distance / levels.stems.w - 0.6f) / 0.4f, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

#endif
