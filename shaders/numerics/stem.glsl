// The one bend of all plants: a stem that keeps its length, held at its root. Blades, the strands of shells, trunks, branches and
// leaves call it, each with its own stiffness.
//
//   B(h) = load g(h) + own m(h)                           bend at height h: direction of lean times angle, at right angles to the
//                                                         axis
//   t(h) = B sin|B| / |B| + axis cos|B|                   the tangent; |t| = 1
//   c(h) = L int_0^h t dh'                                the stem's middle line: Gauss-Legendre, four points
//   R(h)                                                  the turn in the plane of axis and B that takes the axis to t
//   x = c(h) + R(h) (X - X_axis)                          a point X of the straight stem at height h; beyond the tip the stem is
//                                                         straight
//
// g and m are the masks of plant_masks.glsl. The integral is taken of t - axis, so that no bend gives the rest shape to the bit.
// Its error leaves the arc length within 0.4 % at pi/2 by a storm or 2.5 rad by a spring, 0.1 % at 3 rad by itself
// (tests/plants/blade_test.cpp). sin|B| / |B| and (1 - cos|B|) / |B|^2 are polynomials in |B|^2, within 3e-7 up to 3 rad: no
// division by a bend of 0, and one result on every machine, while a GPU's own sine may err by 5e-4.
#ifndef WINDROW_STEM_GLSL
#define WINDROW_STEM_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "plant_drag.glsl"
#include "plant_masks.glsl"

struct WindrowStem {
    vec3 axis;       // unit vector along the straight stem, from its root
    float reach;     // [m] its length, above 0
    vec3 load;       // [rad] bend of the tip by wind, walkers, springs; across the axis
    float sharpness; // of the shape under load, windrow_sharpness
    vec3 own;        // [rad] bend of the tip at rest, across the axis
    float curve;     // where a stem bends by itself: 0 evenly, 1 at the tip
};

// sin|B| / |B| for m = |B|^2 up to 9.
WINDROW_FN float windrow_sine_fraction(float m) {
    return 1.0f - m * (0.166666642f + m * (-0.00833323691f + m * (1.98327383e-4f + m * (-2.7292117e-6f + m * 2.1644718e-8f))));
}

// (1 - cos|B|) / |B|^2 for m = |B|^2 up to 9.
WINDROW_FN float windrow_cosine_fraction(float m) {
    return 0.5f - m * (0.0416666642f + m * (-0.00138888194f + m * (2.4795414e-5f + m * (-2.73656838e-7f + m * 1.84216975e-9f))));
}

// A stem under a load that a spring or windrow_drag_bend gives. `own` [rad] fades as the load presses it flat: at pi/2 all plants
// lie along the wind. The load is shortened to `most` [rad], at most 2.5; `own` is at most 3.
WINDROW_FN WindrowStem windrow_stem(vec3 axis, float reach, vec3 load, vec3 own, float curve, float most) {
    float tip = sqrt(dot(load, load));
    float kept = min(tip, most);
    float share = 0.636619772f * kept;
    WindrowStem stem;
    stem.axis = axis;
    stem.reach = reach;
    stem.load = load * (kept / max(tip, 1e-12f));
    stem.sharpness = windrow_sharpness(share);
    stem.own = own * max(1.0f - share, 0.0f);
    stem.curve = curve;
    return stem;
}

// [rad] B at height h, 0 to 1.
WINDROW_FN vec3 windrow_stem_bend(WindrowStem stem, float h) {
    return stem.load * windrow_mask_drag(h, stem.sharpness) + stem.own * windrow_mask_own(h, stem.curve);
}

// The tangent at height h, less the axis.
WINDROW_FN vec3 windrow_stem_lean(WindrowStem stem, float h) {
    vec3 bend = windrow_stem_bend(stem, h);
    float m = dot(bend, bend);
    return bend * windrow_sine_fraction(m) - stem.axis * (m * windrow_cosine_fraction(m));
}

// [m] How far the middle line has moved at height h, 0 to 1.
WINDROW_FN vec3 windrow_stem_shift(WindrowStem stem, float h) {
    vec3 outer = windrow_stem_lean(stem, 0.0694318442f * h) + windrow_stem_lean(stem, 0.9305681558f * h);
    vec3 inner = windrow_stem_lean(stem, 0.3300094782f * h) + windrow_stem_lean(stem, 0.6699905218f * h);
    return stem.reach * h * (0.1739274226f * outer + 0.3260725774f * inner);
}

// R v for the bend B.
WINDROW_FN vec3 windrow_stem_turn(vec3 axis, vec3 bend, vec3 v) {
    float m = dot(bend, bend);
    float sine = windrow_sine_fraction(m);
    float cosine = windrow_cosine_fraction(m);
    float across = dot(bend, v);
    float along = dot(axis, v);
    return v + bend * (along * sine - across * cosine) - axis * (across * sine + along * m * cosine);
}

// Height of a point of the straight stem's mesh, from the stem's root [m]: 0 below the root, 1 beyond the tip.
WINDROW_FN float windrow_stem_height(WindrowStem stem, vec3 offset) {
    return clamp(dot(offset, stem.axis) / stem.reach, 0.0f, 1.0f);
}

// [m] Where a point that the stem holds at height h goes, both from the stem's root: points of one h move as one rigid body. A
// point of the stem's own mesh is held at its own height; what lies below the root stays.
WINDROW_FN vec3 windrow_stem_point(WindrowStem stem, float h, vec3 offset) {
    vec3 middle = stem.reach * h * stem.axis;
    return middle + windrow_stem_shift(stem, h) + windrow_stem_turn(stem.axis, windrow_stem_bend(stem, h), offset - middle);
}

// Where a direction there goes: a normal, a tangent.
WINDROW_FN vec3 windrow_stem_direction(WindrowStem stem, float h, vec3 direction) {
    return windrow_stem_turn(stem.axis, windrow_stem_bend(stem, h), direction);
}

#endif
