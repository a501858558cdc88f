// How far a strand may lean, and how long it may be, before it meets the skin of its own body.
//
//   d(x) = (x - p) . q                     [m] height of x over a patch of skin at p whose unit normal is q
//   t = (d_0 + e) / (d_0 + e - d_1)        fraction of the lean that is kept where d_1 < 0: d_1 of the strand as it leans, d_0 of the
//                                          strand that stands, 0 or more, both less the margin; e = 0.02 L
//   s = (d_r + e) / (d_r + e - d_1)        fraction of the length, where standing up is not enough; d_r is the root's, without margin
//
// A patch counts where it faces the root, is below x and not far within: weights fall smoothly to 0 with each, and t = s = 1 at
// d_1 = 0, so that both are continuous in the pose and in the wind, steep as they may be: the pass relaxes them in time. e leaves x
// that deep at most where the root itself is on the patch. The least of all patches and heights is taken, which no order of patches
// changes. Lean and length change as a whole: strands keep their shape and layers their order. A second and a third look take what
// the first has left.
#ifndef WINDROW_COAT_ROOM_GLSL
#define WINDROW_COAT_ROOM_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "coat_lean.glsl"

// A patch of the posed skin.
struct WindrowSkinPatch {
    vec3 place;
    float radius; // [m]
    vec3 normal;  // unit, outward
};

// Smoothly from 1 at `inner` to 0 at `outer`.
WINDROW_FN float windrow_room_fade(float inner, float outer, float at) {
    float share = clamp((outer - at) / (outer - inner), 0.0f, 1.0f);
    return share * share * (3.0f - 2.0f * share);
}

// 1 where the patch is one that a strand of length L from `root` enters at x, 0 where it is another.
WINDROW_FN float windrow_room_weight(WindrowSkinPatch disc, vec3 root, vec3 x, float reach) {
    vec3 off = x - disc.place, from = root - disc.place;
    float height = dot(off, disc.normal);
    float aside = sqrt(max(dot(off, off) - height * height, 0.0f));
    return windrow_room_fade(disc.radius, 1.5f * disc.radius, aside) *
           windrow_room_fade(0.05f * reach, 0.15f * reach, -dot(from, disc.normal)) *
           windrow_room_fade(0.5f * reach, 0.8f * reach, -height) *
           windrow_room_fade(1.2f * reach, 1.4f * reach, sqrt(dot(from, from)));
}

// Fraction that the patch leaves of the way from `free`, where there is none of what is taken back, to x; `margin` [m] of both, L
// the strand's `reach` [m].
WINDROW_FN float windrow_room_kept(WindrowSkinPatch disc, vec3 root, vec3 free, vec3 x, float margin, float reach) {
    float over = dot(x - disc.place, disc.normal) - margin;
    if (over >= 0.0f)
        return 1.0f;
    float clear = max(dot(free - disc.place, disc.normal) - margin, 0.0f) + 0.02f * reach;
    return 1.0f + windrow_room_weight(disc, root, x, reach) * (over / (clear - over));
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
