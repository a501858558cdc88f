// The motion vector of a point: how far it has moved over the picture since the last frame, as a share of the picture's size, x
// right and y down. What a resolve over time and a blur of motion ask for.
//
//   motion = ((x, y) / w of now - (x, y) / w of before) / 2
//
// Both clip positions are of the same point of the same thing; a plant's was bent by the last frame's wind. Clip positions are
// linear over a triangle, their quotient is not: interpolate these, divide in the fragment.
#ifndef WINDROW_MOTION_VECTOR_GLSL
#define WINDROW_MOTION_VECTOR_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// `now` and `before` are x, y and w of clip positions. What was behind the eye a frame ago has no place to come from: 0.
WINDROW_FN vec2 windrow_motion_vector(vec3 now, vec3 before) {
    if (!(now.z > 0.0f) || !(before.z > 0.0f))
        return vec2(0.0f);
    return 0.5f * (vec2(now) / now.z - vec2(before) / before.z);
}

#endif
