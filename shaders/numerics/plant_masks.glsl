// Masks by height: fraction of a bend or a push at the place h of a strand, 0 at its root, 1 at its tip. Blades, shells and trees
// use the same masks; each is exactly 0 at h = 0 and exactly 1 at h = 1.
//
//   power      h^c                                        a push that grows toward the tip; c = 1 even, above 1 bends the tip
//   own bend   h (1 + c (h - 1))                          a strand's own bend: c = 0 an arc, c = 1 all of it at the tip
//   drag       g = 1 - ((1 - h) / (1 + b h))^3            the angle of a stalk under drag, over the angle of its tip
//   droop      f = (p^h - 1) / (p - 1), limit h           the sag of a strand; p > 1 sags late, p < 1 early
//
// drag: the tip bears neither a moment nor a shear force, so g' = g'' = 0 there. b = 0 is the cantilever under even load, exact
// for small bends. Under strong wind the angle nears its end as h^-3 from the root (angle f from the flow: f'' = Ca int f^2), as
// g does.
//
// droop: f = expm1(h ln p) / expm1(ln p), with ln p from the host and expm1 by a text of its own: languages lack it or give too
// few digits. The plain form errs by 5.7e-3 at p = 1.00001 and divides by 0 at p = 1.
// Based on: push and droop as the shell literature has them (p^t form: Bloodelic's fur); drag: Luhar & Nepf 2011, Flow-induced
// reconfiguration of buoyant and flexible aquatic vegetation, eq. 4, whose solution g follows.
#ifndef WINDROW_PLANT_MASKS_GLSL
#define WINDROW_PLANT_MASKS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// h^c; `exponent` above 0.
WINDROW_FN float windrow_mask_power(float h, float exponent) { return h <= 0.0f ? 0.0f : pow(h, exponent); }

// `curve` 0 to 1.
WINDROW_FN float windrow_mask_own(float h, float curve) { return h * (1.0f + curve * (h - 1.0f)); }

// `sharpness` b, 0 or more.
WINDROW_FN float windrow_mask_drag(float h, float sharpness) {
    float rest = (1.0f - h) / (1.0f + sharpness * h);
    return 1.0f - rest * rest * rest;
}

// exp(x) - 1 with a relative error of a few 1e-7, near 0 too: x = k ln 2 + r, 2^k expm1(r) + 2^k - 1. x is held within +-80.
WINDROW_FN float windrow_expm1(float x) {
    x = clamp(x, -80.0f, 80.0f);
    float k = floor(1.44269504f * x + 0.5f);
    float r = (x - 0.693359375f * k) + 2.12194440e-4f * k; // ln 2 in two parts, the first with few digits: the product is exact
    float tail = 1.0f + r * (1.0f / 4.0f) * (1.0f + r * (1.0f / 5.0f) * (1.0f + r * (1.0f / 6.0f) * (1.0f + r * (1.0f / 7.0f))));
    float small = r + r * r * (0.5f + r * (1.0f / 6.0f) * tail);
    float power = uintBitsToFloat(uint(int(k) + 127) << 23u);
    return power * small + (power - 1.0f);
}

// `log_p` = ln p, taken by the host in double; 0 gives h.
WINDROW_FN float windrow_mask_droop(float h, float log_p) {
    if (h >= 1.0f)
        return 1.0f;
    if (abs(log_p) < 1e-20f)
        return h;
    return windrow_expm1(h * log_p) / windrow_expm1(log_p);
}

#endif
