// Slip along a body, and what sticks to it: a read beyond its surface finds the air's velocity u along the surface and the body's own U across it,
// u + ((U - u) . n) n, n the surface's normal. A wall of the box is the mirror of fluid/grid/box_rules.cpp.
// Based on: Foster & Fedkiw 2001, SIGGRAPH (slip at moving objects).
#ifndef WINDROW_SLIP_GLSL
#define WINDROW_SLIP_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// `normal` of the surface, 0: none; `across`: U . n.
WINDROW_FN vec3 windrow_slipped(vec3 u, vec3 normal, float across) { return u + (across - dot(u, normal)) * normal; }

// What a reader finds near or below a surface that is `keep` times as far from it as the air u is: 1 where the air slips. Of air that
// sticks, with the body's own velocity there, a linear shear goes on through the surface.
WINDROW_FN vec3 windrow_beside_surface(vec3 u, vec3 normal, float across, vec3 own, float keep) {
    return own + keep * (windrow_slipped(u, normal, across) - own);
}

#endif
