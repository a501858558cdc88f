// Plants in the wind, for a vertex shader (or any stage): blades, shells, trees. On top of windrow_wind.glsl, with its bindings.
//
//     #define WINDROW_SET 2
//     #include "coupling/windrow_plants.glsl"
//     vec3 bend = windrow_blade_bend(grass, root, up, key, vec3(0.0));                      // [rad] for all its vertices
//     WindrowVertex v = windrow_blade(grass, root, up, key, bend, eye, h, side);            // [m] from the anchor
//     vec3 p = windrow_shell(fur, skin, normal, float(gl_InstanceIndex), 1.0, velocity);    // after skinning
//     WindrowTreeVertex t = windrow_tree(oak, base, trunk, branch, leaf, rest);
//     rest = windrow_leaf_turned(leaf, windrow_flutter_angle(flutter, flutter.now, hash, speed), rest);  // before, for a leaf
//
// `grass`, `fur` and `oak` are the blocks of windrow::Blades, Shells and Tree (coupling/), in a uniform or storage buffer of
// yours. Positions are [m] from the anchor of the frame's block, as windrow_wind.glsl has them; keys are not: a key is a plant's
// own place or number and never moves with the camera. The bend is where time comes in: give a spring's state in its place, or
// add a walker's push. For motion vectors call the twins named _previous with what moved itself (root, skin, velocity, eye) as it
// was a frame ago.
#ifndef WINDROW_PLANTS_GLSL
#define WINDROW_PLANTS_GLSL

#include "windrow_wind.glsl"

#include "../numerics/blade.glsl"
#include "../numerics/flutter.glsl"
#include "../numerics/shell.glsl"
#include "../numerics/strand.glsl"
#include "../numerics/swing.glsl"
#include "../numerics/tree.glsl"

// [m/s] What a thing at p feels that moves at `velocity` [m/s]: this frame, and the one before.
vec3 windrow_wind_on(vec3 p, vec3 velocity) { return windrow_apparent(windrow_velocity(p), p, velocity); }
vec3 windrow_wind_on_previous(vec3 p, vec3 velocity) {
    return windrow_apparent_previous(windrow_velocity_previous(p), p, velocity);
}

// A bend that a texture or a buffer holds as x and z.
vec3 windrow_level(vec2 bend) { return vec3(bend.x, 0.0, bend.y); }

// --- Blades ----------------------------------------------------------------------------------------------------------

// [m] Where a blade feels the wind: halfway up.
vec3 windrow_blade_middle(WindrowBlade blade, vec3 root, vec3 up, uvec2 key) {
    return root + 0.5 * windrow_blade_length(blade, windrow_plant_hash(key)) * up;
}

// [rad] The bend that the wind at a blade holds. `up` is the unit vector that it grows along, `velocity` [m/s] what its ground
// moves at.
vec3 windrow_blade_bend(WindrowBlade blade, vec3 root, vec3 up, uvec2 key, vec3 velocity) {
    vec3 u = windrow_wind_on(windrow_blade_middle(blade, root, up, key), velocity);
    return windrow_blade_load(blade, up, windrow_plant_hash(key), u);
}
vec3 windrow_blade_bend_previous(WindrowBlade blade, vec3 root, vec3 up, uvec2 key, vec3 velocity) {
    vec3 u = windrow_wind_on_previous(windrow_blade_middle(blade, root, up, key), velocity);
    return windrow_blade_load(blade, up, windrow_plant_hash(key), u);
}

// [rad] What the wind u [m/s] holds, x and z, without its detail; and what the detail adds `back` seconds before this frame's end.
vec2 windrow_swing_held(WindrowBlade blade, vec3 up, uvec2 hash, vec3 u) {
    vec3 felt = windrow_limited(u, windrow_frame.ambient.felt_strength, windrow_frame.ambient.felt_limit);
    return windrow_blade_load(blade, up, hash, felt).xz;
}
vec2 windrow_swing_ripple(WindrowBlade blade, vec3 middle, vec3 up, uvec2 hash, vec3 u, float back) {
    if (!(windrow_frame.ambient.detail_amount > 0.0))
        return vec2(0.0);
    vec3 drift = vec3(windrow_frame.ambient.mean.x, 0.0, windrow_frame.ambient.mean.z);
    vec3 felt = windrow_felt(0, windrow_frame.ambient, u, middle + back * drift);
    return windrow_blade_load(blade, up, hash, felt).xz - windrow_swing_held(blade, up, hash, u);
}

// A blade with inertia, one call a frame and blade: a compute pass keeps its state in a buffer of yours, as it is or packed to 20
// bytes (windrow_swing_packed). Its bend is then windrow_level(swing.bend); a frame ago it was the bend of the state before. `hash`
// is windrow_plant_hash of the key; `step` comes from windrow::swing_step, or from
// windrow::swing_steps at the index windrow_spring_band(windrow_blade_quickness(blade, hash)). `goes_on`: the state is of the frame before; else the blade begins at
// rest. It grows along `up`, nearly upright.
WindrowSwing windrow_blade_swing(WindrowSwingStep step, WindrowBlade blade, vec3 root, vec3 up, uvec2 hash, vec3 velocity,
                                 bool goes_on, WindrowSwing swing) {
    vec3 middle = root + 0.5 * windrow_blade_length(blade, hash) * up;
    vec3 now = windrow_velocity(middle) - velocity;
    if (!goes_on)
        return windrow_swing_begin(windrow_swing_held(blade, up, hash, now));
    vec3 before = windrow_velocity_previous(middle) - velocity;
    vec2 last = windrow_swing_held(blade, up, hash, before);
    for (float part = 1.0; part <= step.parts.x; part += 1.0) {
        vec2 held = windrow_swing_held(blade, up, hash, now + (1.0 - part / step.parts.x) * (before - now));
        float back = step.parts.x - part + 0.5; // parts from the frame's end to the middle of this one
        vec2 ripple =
            windrow_swing_ripple(blade, middle, up, hash, now + back / step.parts.x * (before - now), back * step.parts.y);
        swing = windrow_swing_part(step, swing, last, held, ripple);
        last = held;
    }
    return swing;
}

// A vertex at height h, 0 to 1, and side -1 to 1; its position [m] from the anchor. `eye` [m] from the anchor too.
WindrowVertex windrow_blade(WindrowBlade blade, vec3 root, vec3 up, uvec2 key, vec3 bend, vec3 eye, float h, float side) {
    vec3 sight = root - eye;
    vec3 view = sight / max(length(sight), 1e-6);
    WindrowVertex vertex =
        windrow_blade_vertex(blade, windrow_blade_plant(blade, up, windrow_plant_hash(key), bend, view), h, side);
    vertex.position += root;
    return vertex;
}

// --- Shells ----------------------------------------------------------------------------------------------------------

// [m] A vertex of the skin, after skinning, on shell i; `map` 0 to 1 is the strands' length there, `velocity` [m/s] the skin's
// own.
vec3 windrow_shell(WindrowShells shells, vec3 p, vec3 n, float i, float map, vec3 velocity) {
    vec3 load = windrow_shell_load(shells, n, map, windrow_wind_on(p, velocity));
    return windrow_shell_bent(shells, p, n, windrow_shell_height(shells, i), map, load);
}
vec3 windrow_shell_previous(WindrowShells shells, vec3 p, vec3 n, float i, float map, vec3 velocity) {
    vec3 load = windrow_shell_load(shells, n, map, windrow_wind_on_previous(p, velocity));
    return windrow_shell_bent(shells, p, n, windrow_shell_height(shells, i), map, load);
}

// --- Trees -----------------------------------------------------------------------------------------------------------

// [m/s] What a part feels halfway along it; nothing is sampled for a part that is not there.
vec3 windrow_wind_on_part(vec3 base, WindrowPart part) {
    return part.stiffness > 0.0 ? windrow_wind_on(base + part.root + 0.5 * part.reach * part.axis, vec3(0.0)) : vec3(0.0);
}
vec3 windrow_wind_on_part_previous(vec3 base, WindrowPart part) {
    return part.stiffness > 0.0 ? windrow_wind_on_previous(base + part.root + 0.5 * part.reach * part.axis, vec3(0.0))
                                : vec3(0.0);
}

// A vertex at rest, relative to the trunk's base [m from the anchor], in the wind that each of its parts feels. The result is
// relative to the base too. For trees that swing call windrow_tree_bent with the states of springs.
WindrowTreeVertex windrow_tree(WindrowTree tree, vec3 base, WindrowPart trunk, WindrowPart branch, WindrowPart leaf,
                               WindrowTreeVertex rest) {
    WindrowTreeLoads loads = windrow_tree_loads(tree, trunk, branch, leaf, windrow_wind_on_part(base, trunk),
                                                windrow_wind_on_part(base, branch), windrow_wind_on_part(base, leaf));
    return windrow_tree_bent(tree, trunk, branch, leaf, loads, rest);
}
WindrowTreeVertex windrow_tree_previous(WindrowTree tree, vec3 base, WindrowPart trunk, WindrowPart branch, WindrowPart leaf,
                                        WindrowTreeVertex rest) {
    WindrowTreeLoads loads =
        windrow_tree_loads(tree, trunk, branch, leaf, windrow_wind_on_part_previous(base, trunk),
                           windrow_wind_on_part_previous(base, branch), windrow_wind_on_part_previous(base, leaf));
    return windrow_tree_bent(tree, trunk, branch, leaf, loads, rest);
}

#endif
