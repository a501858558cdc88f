// Where a layer of a coat goes: a strand on the skin that the wind, its own weight and comb, and the body's motion bend.
//
//   B(h) = B_0 + lag(h) (1 - 2 |B_0| / pi),  B_0 = load g(h) + own m(h)    [rad] stem.glsl's bend, and more where it leaves room
//   s(h) = k (a + 2 b h) / reach,  lag(h) = s / sqrt(1 + (2 s / pi)^2)   slope of the way D = a h + b h^2 by which the body has
//                                                                        run ahead
//   k      1 / sqrt(1 + (most / 2)^2), `most` the larger of the slopes at root and tip: B stays smooth enough for the integral
//   c(h) = int_0^h (B sin|B| / |B| + n cos|B|) reach dh'              Gauss-Legendre, four points; its end is the strand's
//                                                                     tangent
//
// D is the difference between the body's pose and the pose that the cascade (cascade.glsl) has at height h, its part across n:
// strands keep their length, so that the part along n neither pulls them out nor presses them in. a and b put D through the
// cascade at h = 1/2 and 1. As |B| never passes pi/2, c.n rises with h: no layer enters the skin and none passes the next,
// however the body has moved. Without lag it is the plain stem, to the bit.
// The translate form adds the tangential D itself, as long as it may be.
//
// A foot whose sole is d from p leans a strand at p by w (1 - |d_t|^2 / R^2)^2 (1 - max(d.n, 0) / L) d_t / |d_t| [rad] away from
// it, d_t the part of p - foot across n: radial.glsl's weight, less the higher it is lifted off the skin, nothing from the other
// side of a body.
#ifndef WINDROW_COAT_LEAN_GLSL
#define WINDROW_COAT_LEAN_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "../../../shaders/numerics/radial.glsl"
#include "../../../shaders/numerics/shell.glsl"

struct WindrowCoatStrand {
    WindrowStem stem;
    vec3 lag; // a and b over the reach
    vec3 lag_more;
};

// [rad] What its weight bends a strand.
WINDROW_FN vec3 windrow_coat_sag(WindrowShells shells, vec3 n, float map) {
    vec3 down = vec3(shells.sag);
    return (down - dot(down, n) * n) * (shells.sag.w * windrow_shell_softness(map));
}

// `own` [rad] is the comb's bend beside the sag; `lag` and `lag_more` are a and b [m], across n.
WINDROW_FN WindrowCoatStrand windrow_coat_strand(WindrowShells shells, vec3 n, float map, vec3 load, vec3 own, vec3 lag,
                                                 vec3 lag_more) {
    vec3 sag = windrow_coat_sag(shells, n, map);
    vec3 across = load - dot(load, n) * n;
    WindrowCoatStrand strand;
    strand.stem = windrow_stem(n, shells.form.x, across, sag + own, 0.0f, min(shells.drag.load.w, 1.57079633f));
    vec3 root = lag / shells.form.x;
    vec3 tip = root + 2.0f * lag_more / shells.form.x;
    float kept = 1.0f / sqrt(1.0f + 0.25f * max(dot(root, root), dot(tip, tip)));
    strand.lag = kept * root;
    strand.lag_more = (0.5f * kept) * (tip - root);
    return strand;
}

// [rad] B at height h.
WINDROW_FN vec3 windrow_coat_bend(WindrowCoatStrand strand, float h) {
    vec3 slope = strand.lag + 2.0f * h * strand.lag_more;
    vec3 bend = windrow_stem_bend(strand.stem, h);
    float room = max(1.0f - 0.636619772f * sqrt(dot(bend, bend)), 0.0f);
    return bend + slope * (room / sqrt(1.0f + 0.405284735f * dot(slope, slope)));
}

// The strand's unit tangent at height h, less the axis.
WINDROW_FN vec3 windrow_coat_tangent(WindrowCoatStrand strand, float h) {
    vec3 bend = windrow_coat_bend(strand, h);
    float m = dot(bend, bend);
    return bend * windrow_sine_fraction(m) - strand.stem.axis * (m * windrow_cosine_fraction(m));
}

// [m] How far the point at height h has moved from where it is on a straight strand.
WINDROW_FN vec3 windrow_coat_shift(WindrowCoatStrand strand, float h) {
    vec3 outer = windrow_coat_tangent(strand, 0.0694318442f * h) + windrow_coat_tangent(strand, 0.9305681558f * h);
    vec3 inner = windrow_coat_tangent(strand, 0.3300094782f * h) + windrow_coat_tangent(strand, 0.6699905218f * h);
    return strand.stem.reach * h * (0.1739274226f * outer + 0.3260725774f * inner);
}

// Part of v across the unit vector n.
WINDROW_FN vec3 windrow_across(vec3 v, vec3 n) { return v - dot(v, n) * n; }

// [rad] `foot` xyz its sole [m], w its radius; `most` [rad]; `reach` [m] the strands' length.
WINDROW_FN vec3 windrow_foot_load(vec4 foot, float most, float reach, vec3 p, vec3 n) {
    vec3 away = p - vec3(foot);
    float lifted = -dot(away, n);
    if (lifted < -foot.w)
        return vec3(0.0f);
    vec3 aside = windrow_across(away, n);
    float square = dot(aside, aside);
    float touch = clamp(1.0f - lifted / reach, 0.0f, 1.0f);
    return aside * (most * touch * windrow_radial_weight(square, foot.w) / max(sqrt(square), 1e-9f));
}

#endif
