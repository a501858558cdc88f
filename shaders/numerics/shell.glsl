// Shells: layers over a surface whose patterns make strands. Vertices of shell i of N, i = 0 at the skin, move along with the
// strands.
//
//   t = i / d                    place in the strand: d = N - 1 reaches the tip, d = N stops short of it as some sources do
//   h = t^a                      height; a spreads the layers
//   p + n L (map h + bias)       extrusion; `map` shortens strands where a texture says so
//   + D s h^c                    push by wind or motion, the translate form
//   + down droop f(p, h)         sag, the same for any N
// or, in place of push and sag, the strand as a stem rooted on the surface (stem.glsl): it keeps its length.
//
// Never into the surface: the inward part min(0, d.n) n of push and of sag is removed, of each for itself. What is left grows
// with h along n, so that no shell passes the next; were the sum cut, a push that lifts early and a sag that falls late would
// cross them. A stem bends by pi/2 at most and rises all the way. Both keep p' - p on the outer side of the plane through p
// across n. On skinned meshes p and n come after skinning: wind and gravity do not turn with the bones.
//
// Forms of the sources:
//   a thesis on shell fur (Unity, 2024)   a, c, s free, D the direction memory, d = N; or c = 1, d = N - 1, D turned round
//   a furry bunny (course project, 2024)  a = c = 1, D = -v, d = N
//   Curoe's shell-textured worlds (2024)  c free, one D for the whole plane
//   Bloodelic's stylised fur              a = 1, bias = 0.025 of L, droop with ln p, d = N
#ifndef WINDROW_SHELL_GLSL
#define WINDROW_SHELL_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "stem.glsl"

// A class of shells. The same layout as windrow::ShellBlock (coupling/shell.h), which says more of each field. Usable in std140.
struct WindrowShells {
    vec4 form; // x [m] strand length L; y exponent a; z bias over L; w divisor d
    vec4 push; // x strength s of the push; y exponent c; z [m] droop of the tip; w ln p
    vec4 sag;  // xyz unit vector down; w [rad] sag of the tip of a level strand of length L, in the stem form
    WindrowDrag drag;
};

// Height h of shell i.
WINDROW_FN float windrow_shell_height(WindrowShells shells, float i) {
    return windrow_mask_power(i / shells.form.w, shells.form.y);
}

// [m] How far out a shell of height h lies; `map` 0 to 1 is its length there.
WINDROW_FN float windrow_shell_distance(WindrowShells shells, float h, float map) {
    return shells.form.x * (map * h + shells.form.z);
}

// d without its part into the surface.
WINDROW_FN vec3 windrow_outward(vec3 d, vec3 n) { return d - min(0.0f, dot(d, n)) * n; }

// [m] Push of height h by `direction` [m at the tip, for s = 1].
WINDROW_FN vec3 windrow_shell_push(WindrowShells shells, float h, vec3 direction) {
    return direction * (shells.push.x * windrow_mask_power(h, shells.push.y));
}

// [m] Sag of height h.
WINDROW_FN vec3 windrow_shell_droop(WindrowShells shells, float h) {
    return vec3(shells.sag) * (shells.push.z * windrow_mask_droop(h, shells.push.w));
}

// [m] A vertex p with unit normal n on the skin, `out_by` [m] out, moved by a push and a droop [m], their inward parts removed.
WINDROW_FN vec3 windrow_shell_moved(vec3 p, vec3 n, float out_by, vec3 push, vec3 droop) {
    return p + out_by * n + (windrow_outward(push, n) + windrow_outward(droop, n));
}

// [m] The translate form.
WINDROW_FN vec3 windrow_shell_translated(WindrowShells shells, vec3 p, vec3 n, float h, float map, vec3 direction) {
    return windrow_shell_moved(p, n, windrow_shell_distance(shells, h, map), windrow_shell_push(shells, h, direction),
                               windrow_shell_droop(shells, h));
}

// Bend of a strand with `map` of the length over that of a whole one, by the same small load along it: wind and weight alike.
WINDROW_FN float windrow_shell_softness(float map) {
    float share = max(map, 1e-6f);
    return share * share * share;
}

// [rad] The bend of the tip of a strand with `map` of the length that the apparent wind u [m/s] holds, across n.
WINDROW_FN vec3 windrow_shell_load(WindrowShells shells, vec3 n, float map, vec3 u) {
    return windrow_drag_bend(shells.drag, n, u, 1.0f / windrow_shell_softness(map));
}

// [m] The stem form: `load` [rad] from windrow_shell_load or from a spring.
WINDROW_FN vec3 windrow_shell_bent(WindrowShells shells, vec3 p, vec3 n, float h, float map, vec3 load) {
    vec3 down = vec3(shells.sag);
    vec3 sag = (down - dot(down, n) * n) * (shells.sag.w * windrow_shell_softness(map));
    vec3 across = load - dot(load, n) * n; // a spring's rounding must not push inward
    WindrowStem stem = windrow_stem(n, shells.form.x * max(map, 1e-6f), across, sag, 0.0f, min(shells.drag.load.w, 1.57079633f));
    return p + (stem.reach * h + shells.form.x * shells.form.z) * n + windrow_stem_shift(stem, h);
}

#endif
