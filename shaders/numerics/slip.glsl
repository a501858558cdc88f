// Slip along a body: a read beyond its surface finds the air's velocity u along the surface and the body's own U across it,
// u + ((U - u) . n) n, n the surface's normal. A wall of the box is the mirror of fluid/grid/box_rules.cpp.
// Based on: Foster & Fedkiw 2001, SIGGRAPH (slip at moving objects).
#ifndef WINDROW_SLIP_GLSL
#define WINDROW_SLIP_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// `normal` of the surface, 0: none; `across`: U . n.
WINDROW_FN vec3 windrow_slipped(vec3 u, vec3 normal, float across) { return u + (across - dot(u, normal)) * normal; }

#endif
