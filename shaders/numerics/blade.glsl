// A blade of grass: a bent strip of constant length.
//
// The middle line c(h) and its turn R(h): stem.glsl; the load: plant_drag.glsl.
//
//   facing f     the yaw of its hash; the strip's width lies along w = axis x f
//   load         windrow_drag_bend, or a spring that follows it; a fraction of it along the wind, the rest about the strip's own
//                wide axis
//   own bend     toward f: a base, a spread by chance, and more the steeper one looks down on it, so that grass seen from above
//                is no dots
//   twist        the face turns to the load by tau(h) = tau (2 h - h^2), tau = k |load| sin(2 angle from f to load), whatever
//                bends the blade: an even moment about its length, which is 0 face on and on edge
//   position     root + c(h) + side * half_width(h) * R(h) (w cos tau(h) - f sin tau(h))
//   normal       R(h) (f cos tau(h) + w sin tau(h)): exactly the cross product of the position's two derivatives on the middle line,
//                and everywhere while load and own bend share a plane and nothing twists
//
// half_width(h) = half_width * (1 - (1 - tip) h^taper). The translate form, u s h^c, shears the blade and stretches it: it is
// there to compare with.
#ifndef WINDROW_BLADE_GLSL
#define WINDROW_BLADE_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "plant_hash.glsl"
#include "stem.glsl"

// A class of blades. The same layout as windrow::BladeBlock (coupling/blade.h), which says more of each field. Usable in std140.
struct WindrowBlade {
    vec4 size; // x [m] length, y its spread; z [m] half of the width at the root, w the tip's width over the root's
    vec4 form; // x taper exponent; y share of the load along the wind; z spread of the stiffness; w curve of the own bend
    vec4 own;  // x [rad] own bend, y [rad] its spread, z [rad] most added when seen from above; w k of the twist
    WindrowDrag drag;
};

// One blade of the class.
struct WindrowBladePlant {
    vec3 facing; // unit vector, across the axis
    vec3 width;  // unit vector, across axis and facing
    float twist; // [rad] turn of the tip about the blade's length, from facing toward width
    WindrowStem stem;
};

struct WindrowVertex {
    vec3 position; // [m] from the root
    vec3 normal;   // unit vector, on the side that faces
    vec3 tangent;  // unit vector toward the tip
};

// The sine and cosine of a yaw: polynomials of half the angle, the same on every machine within 3e-7.
WINDROW_FN vec2 windrow_yaw_vector(float yaw) {
    float half_angle = 0.5f * (yaw - 3.14159265f);
    float m = half_angle * half_angle;
    float s = half_angle * windrow_sine_fraction(m);
    float c = 1.0f - m * windrow_cosine_fraction(m);
    return vec2(s * s - c * c, -2.0f * s * c); // cos(yaw), sin(yaw)
}

// Unit vector in which a blade faces, across its axis. An axis that is nearly level faces as it can.
WINDROW_FN vec3 windrow_blade_facing(vec3 axis, uvec2 hash) {
    vec2 level = windrow_yaw_vector(windrow_plant_yaw(hash));
    vec3 facing = vec3(level.x, 0.0f, level.y);
    facing = facing - dot(facing, axis) * axis;
    float square = dot(facing, facing);
    return square > 1e-6f ? facing / sqrt(square) : normalize(cross(axis, vec3(-level.y, 0.0f, level.x)));
}

// Length of a blade over its class's.
WINDROW_FN float windrow_blade_length_fraction(WindrowBlade blade, uvec2 hash) {
    return 1.0f + blade.size.y * (2.0f * windrow_fraction(hash.x * 2654435761u) - 1.0f);
}

// [rad] The bend that the apparent wind u [m/s] holds: what a spring follows, or the load itself where nothing swings. The Cauchy
// number grows with the cube of the blade's own length: a short blade stands where a long one lies.
WINDROW_FN vec3 windrow_blade_load(WindrowBlade blade, vec3 axis, uvec2 hash, vec3 u) {
    float share = windrow_blade_length_fraction(blade, hash);
    return windrow_drag_bend(blade.drag, axis, u, windrow_plant_factor(hash, blade.form.z) / (share * share * share));
}

// Share of the most view bend: 0 seen level or from below, 1 seen from straight above. `view` is the unit vector from the eye.
WINDROW_FN float windrow_view_fraction(vec3 view, vec3 axis) { return clamp(-dot(view, axis), 0.0f, 1.0f); }

// Frequency of a blade over its class's, as of a beam of one thickness: with the root of the stiffness, over the length squared.
WINDROW_FN float windrow_blade_quickness(WindrowBlade blade, uvec2 hash) {
    float share = windrow_blade_length_fraction(blade, hash);
    return sqrt(windrow_plant_factor(hash, blade.form.z)) / (share * share);
}

// [m] Length of a blade of the class.
WINDROW_FN float windrow_blade_length(WindrowBlade blade, uvec2 hash) {
    return blade.size.x * windrow_blade_length_fraction(blade, hash);
}

// One blade: `load` [rad] from windrow_blade_load or from a spring, `view` the unit vector from the eye.
WINDROW_FN WindrowBladePlant windrow_blade_plant(WindrowBlade blade, vec3 axis, uvec2 hash, vec3 load, vec3 view) {
    float chance = windrow_plant_chance(hash);
    WindrowBladePlant plant;
    plant.facing = windrow_blade_facing(axis, hash);
    plant.width = cross(axis, plant.facing);
    float own = clamp(blade.own.x + blade.own.y * chance + blade.own.z * windrow_view_fraction(view, axis), -3.0f, 3.0f);
    float faced = dot(load, plant.facing), edged = dot(load, plant.width);
    float tip = max(sqrt(faced * faced + edged * edged), 1e-6f);
    float turned = 2.0f * (faced / tip) * (edged / tip) * min(tip, blade.drag.load.w); // the bend that the stem keeps
    plant.twist = clamp(blade.own.w * turned, -3.0f, 3.0f);
    vec3 about_own_axis = faced * plant.facing;
    vec3 bend = about_own_axis + blade.form.y * (load - about_own_axis);
    plant.stem = windrow_stem(axis, windrow_blade_length(blade, hash), bend, own * plant.facing, blade.form.w, blade.drag.load.w);
    return plant;
}

// [m] Half of the width at height h.
WINDROW_FN float windrow_blade_half_width(WindrowBlade blade, float h) {
    return blade.size.z * (1.0f - (1.0f - blade.size.w) * windrow_mask_power(h, blade.form.x));
}

// h 0 at the root, 1 at the tip; `across` [m] from the middle line.
WINDROW_FN WindrowVertex windrow_blade_point(WindrowBladePlant plant, float h, float across) {
    WindrowStem stem = plant.stem;
    vec3 bend = windrow_stem_bend(stem, h);
    float twist = plant.twist * (h * (2.0f - h));
    float sine = twist * windrow_sine_fraction(twist * twist);
    float cosine = 1.0f - twist * twist * windrow_cosine_fraction(twist * twist);
    vec3 width = cosine * plant.width - sine * plant.facing;
    WindrowVertex vertex;
    vertex.position =
        stem.reach * h * stem.axis + windrow_stem_shift(stem, h) + across * windrow_stem_turn(stem.axis, bend, width);
    vertex.normal = windrow_stem_turn(stem.axis, bend, cosine * plant.facing + sine * plant.width);
    vertex.tangent = windrow_stem_turn(stem.axis, bend, stem.axis);
    return vertex;
}

// The same with `side` -1 to 1 across.
WINDROW_FN WindrowVertex windrow_blade_vertex(WindrowBlade blade, WindrowBladePlant plant, float h, float side) {
    return windrow_blade_point(plant, h, side * windrow_blade_half_width(blade, h));
}

// [m] The translate form of the sources: linear in the wind u [m/s], by `seconds` metres a metre a second at the tip.
WINDROW_FN vec3 windrow_translated(vec3 u, float h, float seconds, float exponent) {
    return u * (seconds * windrow_mask_power(h, exponent));
}

#endif
