// A tree: trunk, branch and leaf, each a stem (stem.glsl) with its own stiffness, bent at rest and carried along by its bearer.
//
//   x = T(B(F(X)))               X a vertex of the tree at rest; F bends the leaf about its root, B the branch, T the trunk
//
// F takes each vertex of the leaf by its own height along it. B and T take the whole leaf by one height each, that of the root
// which they hold: it is carried as one rigid body, and only its own bend changes its form. A root lies on its bearer's axis, or
// beside it: it moves as the bearer's own mesh does there, and so stays attached.
// The wind is taken in the frame of rest, so that a part leans along the wind up to the angle by which its bearer has turned.
// What a vertex has not (no leaf, no branch) has stiffness 0 and costs a comparison.
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

// [rad] The bends of the parts: windrow_tree_loads, or springs that follow them. Of a part that is not there, anything.
struct WindrowTreeLoads {
    vec3 trunk;
    vec3 branch;
    vec3 leaf;
};

// [m] Where what bears `part` holds it: at its root. A vertex that no such part bears keeps the place `hold`.
WINDROW_FN vec3 windrow_part_hold(WindrowPart part, vec3 hold) { return part.stiffness > 0.0f ? part.root : hold; }

// Bends one part by `load` [rad], across its axis. `hold` [m] is the place at rest by which the part holds the vertex: the
// vertex's own if it is of the part itself, the root of what the part bears otherwise, the same for all vertices of that.
WINDROW_FN WindrowTreeVertex windrow_part_bent(WindrowPart part, vec3 load, float most, vec3 hold, WindrowTreeVertex vertex) {
    if (!(part.stiffness > 0.0f))
        return vertex;
    WindrowStem stem = windrow_stem(part.axis, part.reach, load, vec3(0.0f), 0.0f, most);
    float h = windrow_stem_height(stem, hold - part.root);
    WindrowTreeVertex bent;
    bent.position = part.root + windrow_stem_point(stem, h, vertex.position - part.root);
    bent.normal = windrow_stem_direction(stem, h, vertex.normal);
    return bent;
}

// [rad] The bend that the apparent wind u [m/s] holds.
WINDROW_FN vec3 windrow_part_load(WindrowDrag drag, WindrowPart part, vec3 u) {
    return part.stiffness > 0.0f ? windrow_drag_bend(drag, part.axis, u, part.stiffness) : vec3(0.0f);
}

// The bends that the apparent winds [m/s] hold, one a part.
WINDROW_FN WindrowTreeLoads windrow_tree_loads(WindrowTree tree, WindrowPart trunk, WindrowPart branch, WindrowPart leaf,
                                               vec3 on_trunk, vec3 on_branch, vec3 on_leaf) {
    WindrowTreeLoads loads;
    loads.trunk = windrow_part_load(tree.trunk, trunk, on_trunk);
    loads.branch = windrow_part_load(tree.branch, branch, on_branch);
    loads.leaf = windrow_part_load(tree.leaf, leaf, on_leaf);
    return loads;
}

// A vertex of the tree whose parts have these bends.
WINDROW_FN WindrowTreeVertex windrow_tree_bent(WindrowTree tree, WindrowPart trunk, WindrowPart branch, WindrowPart leaf,
                                               WindrowTreeLoads loads, WindrowTreeVertex vertex) {
    vec3 on_branch = windrow_part_hold(leaf, vertex.position);
    vec3 on_trunk = windrow_part_hold(branch, on_branch);
    WindrowTreeVertex v = windrow_part_bent(leaf, loads.leaf, tree.leaf.load.w, vertex.position, vertex);
    v = windrow_part_bent(branch, loads.branch, tree.branch.load.w, on_branch, v);
    return windrow_part_bent(trunk, loads.trunk, tree.trunk.load.w, on_trunk, v);
}

// The whole tree in one wind.
WINDROW_FN WindrowTreeVertex windrow_tree_vertex(WindrowTree tree, WindrowPart trunk, WindrowPart branch, WindrowPart leaf,
                                                 vec3 u, WindrowTreeVertex vertex) {
    return windrow_tree_bent(tree, trunk, branch, leaf, windrow_tree_loads(tree, trunk, branch, leaf, u, u, u), vertex);
}

#endif
