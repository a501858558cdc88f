// Flutter: oscillation of a leaf about its stalk above a threshold wind speed.
//
//   angle = most sqrt(1 - (U0 / U)^2) sin(2 pi (f t + p))      beyond the speed U0 [m/s]; 0 below
//
// Torsional galloping starts at a threshold speed. Above it the motion depends weakly on the wind. The model is the amplitude of a
// supercritical Hopf bifurcation at a constant frequency. Each leaf has one of the four bands of spring.glsl and a random phase p.
// The CPU computes f t in double: a time in float would stutter after an hour.
// Based on: Tadrist and others 2015, J. Fluids Struct. 56, 1 (the limit); Tadrist and others 2018, J. R. Soc. Interface 15,
// 20180010 (how flutter and the buffeting of branches depend on the wind).
#ifndef WINDROW_FLUTTER_GLSL
#define WINDROW_FLUTTER_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "plant_hash.glsl"
#include "tree.glsl"
#include "turn_sine.glsl"

// A frame of a class of leaves. The same layout as windrow::FlutterBlock (coupling/motion_blocks.h). Usable in a std140 block.
struct WindrowFlutter {
    vec4 motion; // x [rad] most, y [m/s] U0, zw 0
    vec4 now;    // f t of each band, 0 to 1
    vec4 before; // a frame ago
};

// Amplitude over the most, in a wind of `speed` [m/s].
WINDROW_FN float windrow_flutter_growth(WindrowFlutter flutter, float speed) {
    if (!(speed > flutter.motion.y))
        return 0.0f;
    float part = flutter.motion.y / speed;
    return sqrt(1.0f - part * part);
}

WINDROW_FN float windrow_flutter_of_band(vec4 bands, uint band) {
    return band == 0u ? bands.x : band == 1u ? bands.y : band == 2u ? bands.z : bands.w;
}

// [rad] Turn of a leaf. `phases` is flutter.now or flutter.before, `hash` windrow_plant_hash of the leaf's key.
WINDROW_FN float windrow_flutter_angle(WindrowFlutter flutter, vec4 phases, uvec2 hash, float speed) {
    uint band = hash.y & 3u;
    float phase = windrow_flutter_of_band(phases, band) + windrow_fraction(hash.x);
    return flutter.motion.x * windrow_flutter_growth(flutter, speed) * windrow_turn_sine(phase);
}

// A vertex of a leaf at rest, turned about the leaf's axis by `angle` [rad]: before the leaf and its bearers bend it.
WINDROW_FN WindrowTreeVertex windrow_leaf_turned(WindrowPart leaf, float angle, WindrowTreeVertex vertex) {
    float turns = angle * 0.159154943f;
    float sine = windrow_turn_sine(turns), cosine = windrow_turn_cosine(turns);
    vec3 offset = vertex.position - leaf.root;
    vec3 along = dot(offset, leaf.axis) * leaf.axis, off = offset - along;
    vec3 beside = vertex.normal - dot(vertex.normal, leaf.axis) * leaf.axis;
    WindrowTreeVertex turned;
    turned.position = leaf.root + along + cosine * off + sine * cross(leaf.axis, off);
    turned.normal = vertex.normal + (cosine - 1.0f) * beside + sine * cross(leaf.axis, beside);
    return turned;
}

#endif
