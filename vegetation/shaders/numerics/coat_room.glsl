// How far a strand may lean, and how long it may be, before it meets the skin of its own body.
//
//   d(x) = (x - p) . q            [m] height of x over a piece of skin at p whose unit normal is q
//   d(x_1) < m                    the strand at full lean, x_1, is nearer than m = k_margin h L to that piece, or behind it
//   t_i = (d(x_0) - m) / (d(x_0) - d(x_1))     fraction of the lean at which it is m away; x_0 is the strand that stands
//   s_i = d(r) / (d(r) - d(x) + m)             fraction of the length, where standing up is not enough; r is the root
//
// A piece counts where it faces the root, lies below x and is not far within: weights fall smoothly to 0 with each, so that t and s
// are continuous in the pose and in the wind. The least of all pieces and heights is taken, which no order of pieces changes. Lean
// and length change as a whole: strands keep their shape and layers their order. d along an arc that stands up is concave where the
// piece is level, so that t_i is on the safe side there; a second and a third look correct it elsewhere.
#ifndef WINDROW_COAT_ROOM_GLSL
#define WINDROW_COAT_ROOM_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "coat_lean.glsl"

// A piece of the posed skin.
struct WindrowSkinPiece {
    vec3 place;
    float radius; // [m]
    vec3 normal;  // unit, outward
};

// Smoothly from 1 at `near` to 0 at `far`.
WINDROW_FN float windrow_room_fade(float near, float far, float at) {
    float share = clamp((far - at) / (far - near), 0.0f, 1.0f);
    return share * share * (3.0f - 2.0f * share);
}

// 1 where the piece is one that a strand of length L from `root` enters at x, 0 where it is another.
WINDROW_FN float windrow_room_weight(WindrowSkinPiece piece, vec3 root, vec3 x, float reach) {
    vec3 off = x - piece.place;
    float height = dot(off, piece.normal);
    float aside = sqrt(max(dot(off, off) - height * height, 0.0f));
    float behind = -dot(root - piece.place, piece.normal);
    return windrow_room_fade(piece.radius, 1.5f * piece.radius, aside) * windrow_room_fade(0.05f * reach, 0.15f * reach, behind) *
           windrow_room_fade(0.5f * reach, 0.8f * reach, -height);
}

// Fraction of the lean that the piece leaves at x, of a strand that stands at `upright`; `margin` [m].
WINDROW_FN float windrow_room_lean(WindrowSkinPiece piece, vec3 root, vec3 upright, vec3 x, float margin, float reach) {
    float leant = dot(x - piece.place, piece.normal) - margin;
    if (leant >= 0.0f)
        return 1.0f;
    float stands = max(dot(upright - piece.place, piece.normal) - margin, 0.0f);
    return 1.0f - windrow_room_weight(piece, root, x, reach) * (leant / (leant - stands));
}

// Fraction of the length that the piece leaves at x.
WINDROW_FN float windrow_room_reach(WindrowSkinPiece piece, vec3 root, vec3 x, float margin, float reach) {
    float over = dot(x - piece.place, piece.normal) - margin;
    if (over >= 0.0f)
        return 1.0f;
    float rooted = max(dot(root - piece.place, piece.normal), 0.0f);
    return 1.0f - windrow_room_weight(piece, root, x, reach) * (over / (over - rooted));
}

// [rad] `own` of a strand with a fraction `lean` of all that bends it at rest: less the sag that it must not have.
WINDROW_FN vec3 windrow_coat_own_leaning(WindrowShells shells, vec3 n, float map, vec3 own, float lean) {
    return lean * own - (1.0f - lean) * windrow_coat_sag(shells, n, map);
}

// The strand with a fraction `lean` of all that bends it: wind, weight, comb and lag.
WINDROW_FN WindrowCoatStrand windrow_coat_strand_leaning(WindrowShells shells, vec3 n, float map, vec3 load, vec3 own, vec3 lag,
                                                         vec3 lag_more, float lean) {
    return windrow_coat_strand(shells, n, map, lean * load, windrow_coat_own_leaning(shells, n, map, own, lean), lean * lag,
                               lean * lag_more);
}

#endif
