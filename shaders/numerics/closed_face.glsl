// A face between two cells whose area is closed by a fraction c, with the body's own velocity U across it. What it changes of the
// empty box's flux and slope:
//
//   flux    (1 - c) (u_low + u_high) / 2 + c U  =  (u_low + u_high) / 2 - windrow_closed_flux
//   slope   (1 - c) (phi_high - phi_low)        =  (phi_high - phi_low) - windrow_closed_slope
//
// Values are at cell centres. Exact for a body along the faces.
// Based on: Batty, Bertails & Bridson 2007, ACM Transactions on Graphics 26; Ng, Min & Gibou 2009, Journal of Computational Physics
// 228 (fractions of faces).
#ifndef WINDROW_CLOSED_FACE_GLSL
#define WINDROW_CLOSED_FACE_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// `both`: sum of the velocities at both ends; `wall`: c U.
WINDROW_FN float windrow_closed_flux(float closed, float both, float wall) { return 0.5f * closed * both - wall; }

WINDROW_FN float windrow_closed_slope(float closed, float low, float high) { return closed * (high - low); }

// What such a flux counts of the prescribed wind although the cell at one end is sheltered from it: there the velocity is the whole,
// and the wind is part of the velocity beyond the face. `both`: sum of the wind at both ends.
WINDROW_FN float windrow_blown_past(float closed, float both, float beyond, bool beyond_is_sheltered) {
    return 0.5f * (closed * both + (beyond_is_sheltered ? 0.0f : (1.0f - closed) * beyond));
}

// Diffusion: what an explicit pass changes in the cell `here`, over viscosity dt / h^2. Nothing comes from the cell `next` through what
// is closed; the wall, half a cell away, holds what sticks to it, and of other air the part across it. `facing`: closed in this
// direction; `wall`: its velocity, less what is prescribed here.
WINDROW_FN vec3 windrow_wall_flux(float facing, float closed, bool sticks, int axis, vec3 here, vec3 next, vec3 wall) {
    vec3 stuck = 2.0f * (wall - here);
    vec3 flux = vec3(0.0f);
    if (sticks)
        flux = stuck;
    else
        flux[axis] = stuck[axis];
    return facing * flux - closed * (next - here);
}

// The same of an implicit pass, in each cell by itself: (here + way wall) / (1 + way), with way = 2 facing viscosity dt / h^2.
WINDROW_FN vec3 windrow_wall_dragged(float way, bool sticks, int axis, vec3 here, vec3 wall) {
    float part = way / (1.0f + way);
    vec3 change = part * (wall - here);
    if (sticks)
        return here + change;
    vec3 dragged = here;
    dragged[axis] += change[axis];
    return dragged;
}

#endif
