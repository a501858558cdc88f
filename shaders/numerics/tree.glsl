// A tree: leaf on branch on trunk, each a stem (stem.glsl) with its own stiffness, bent at rest and carried along by what bears it.
//
//   x = T(B(F(X)))               X a vertex of the tree at rest; F bends the leaf about its root, B the branch, T the trunk
//
// A leaf's root lies on the branch's straight axis, a branch's on the trunk's: they stay attached. The wind is taken in the frame of
// rest, so that a part leans along the wind up to the angle by which its bearer has turned. What a part has not (no leaf, no branch)
// has stiffness 0 and costs a comparison.
#ifndef WINDROW_TREE_GLSL
#define WINDROW_TREE_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "stem.glsl"

// A class of trees. The same layout as windrow::TreeBlock (coupling/tree.h). Usable in std140.
struct WindrowTree {
    WindrowDrag trunk;
    WindrowDrag branch;
    WindrowDrag leaf;
};

// A part that a vertex belongs to: from the mesh, the same for all vertices of the part.
struct WindrowPart {
    vec3 root;       // [m] from the trunk's base
    vec3 axis;       // unit vector
    float reach;     // [m] its length, above 0
    float stiffness; // over its class; 0: there is no such part
};

// A vertex and its normal as they go from part to part.
struct WindrowTreeVertex {
    vec3 position; // [m] from the trunk's base
    vec3 normal;
};

// Bends one part by `load` [rad], across its axis.
WINDROW_FN WindrowTreeVertex windrow_part_bent(WindrowPart part, vec3 load, float most, WindrowTreeVertex vertex) {
    if (!(part.stiffness > 0.0f))
        return vertex;
    WindrowStem stem = windrow_stem(part.axis, part.reach, load, vec3(0.0f), 0.0f, most);
    vec3 offset = vertex.position - part.root;
    WindrowTreeVertex bent;
    bent.position = part.root + windrow_stem_point(stem, offset);
    bent.normal = windrow_stem_direction(stem, offset, vertex.normal);
    return bent;
}

// [rad] The bend that the apparent wind u [m/s] holds.
WINDROW_FN vec3 windrow_part_load(WindrowDrag drag, WindrowPart part, vec3 u) {
    return part.stiffness > 0.0f ? windrow_drag_bend(drag, part.axis, u, part.stiffness) : vec3(0.0f);
}

// Bends one part in the apparent wind u [m/s].
WINDROW_FN WindrowTreeVertex windrow_part_in_wind(WindrowDrag drag, WindrowPart part, vec3 u, WindrowTreeVertex vertex) {
    return windrow_part_bent(part, windrow_part_load(drag, part, u), drag.load.w, vertex);
}

// The whole tree in one wind.
WINDROW_FN WindrowTreeVertex windrow_tree_vertex(WindrowTree tree, WindrowPart trunk, WindrowPart branch, WindrowPart leaf, vec3 u,
                                                 WindrowTreeVertex vertex) {
    WindrowTreeVertex v = windrow_part_in_wind(tree.leaf, leaf, u, vertex);
    v = windrow_part_in_wind(tree.branch, branch, u, v);
    return windrow_part_in_wind(tree.trunk, trunk, u, v);
}

#endif
