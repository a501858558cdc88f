// Leaning strands on planes with few vertices: the fragment reads its strand at the strand's root, not at its own place.
//
//   root = uv - lean(uv) m(h)         the strand that is seen at uv on the shell of height h
//   root' = uv - lean(root) m(h)      once more, with the lean at the root: the error falls by |grad lean| each time
//
// `lean` is the tip's displacement in uv, from the wind that the fragment samples; m any mask. What the lean does to a strand is
// then wind times mask at its own place, however coarse the mesh. A foot leans strands away from it, evenly in all directions.
// Based on: the idea of distorting the uv by height in Curoe's shell-textured worlds (not built there).
#ifndef WINDROW_STRAND_GLSL
#define WINDROW_STRAND_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "radial.glsl"
#include "stem.glsl"

// Root of the strand at uv, for the lean at uv or, better, at a first root.
WINDROW_FN vec2 windrow_strand_root(vec2 uv, vec2 lean, float mask) { return uv - lean * mask; }

// How far a strand of length 1 has moved at height h, 0 to 1, in the plane: a stem that the wind bends by `load` [rad]. h = 1 is
// the tip's lean. Multiply by the strand's length in uv; the mask of windrow_strand_root is then 1.
WINDROW_FN vec2 windrow_strand_lean(vec2 load, float h, float most) {
    WindrowStem stem = windrow_stem(vec3(0.0f, 1.0f, 0.0f), 1.0f, vec3(load.x, 0.0f, load.y), vec3(0.0f), 0.0f, most);
    vec3 shift = windrow_stem_shift(stem, h);
    return vec2(shift.x, shift.z);
}

// [rad] Load by a foot or a hand at `offset` [m] from it, in the plane: outward, `most` at its middle, falling as (1 - r^2/R^2)^2
// to 0 at the radius R [m] and beyond. Exactly at the middle it has no direction: 0.
WINDROW_FN vec2 windrow_radial_load(vec2 offset, float radius, float most) {
    float square = dot(offset, offset);
    return offset * (most * windrow_radial_weight(square, radius) / max(sqrt(square), 1e-12f));
}

#endif
