// No blade is drawn as dots: one on edge, or far away, keeps a least width as the eye sees it.
#ifndef WINDROW_RENDER_BLADE_WIDTH_GLSL
#define WINDROW_RENDER_BLADE_WIDTH_GLSL

#include "shaders/numerics/blade.glsl"

// A vertex at `side` -1 to 1 of a strip whose half width is `half_width` [m] there; `least` [rad] is half of the width that is
// seen at least. The strip's middle line stays where it is.
WindrowVertex wide_enough(WindrowVertex vertex, float side, float half_width, vec3 eye, float least) {
    vec3 to_eye = eye - vertex.position;
    vec3 beside = cross(vertex.tangent, to_eye); // at right angles to the blade, as it is seen
    float across = length(beside);
    if (least > 0.0 && across > 1e-3 * length(to_eye)) {
        beside /= across;
        float seen = dot(cross(vertex.tangent, vertex.normal), beside); // share of the width that is seen, with its sense
        float lacking = least * length(to_eye) - half_width * abs(seen);
        vertex.position += side * (seen < 0.0 ? -1.0 : 1.0) * max(lacking, 0.0) * beside;
    }
    return vertex;
}

#endif
