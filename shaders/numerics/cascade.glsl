// Value of a cascade of first-order stages at the height of a shell (coupling/cascade_step.h advances the stages).
//
//   stage 0 the body,  y_i' = lambda (y_(i-1) - y_i),  i = 1 .. n,  a shell at height h in [0, 1] reads y at i = h n
//
// The profile belongs to the stages, not to the shells: shells read it, linear between stages, so any number of shells shows the
// same motion at the same height, and the reading adds no overshoot. Rotations ride as quaternions whose length is left alone,
// and get the length 1 when read.
#ifndef WINDROW_CASCADE_GLSL
#define WINDROW_CASCADE_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// Of a stage or of the body. Usable in a std140 block.
struct WindrowPose {
    vec4 place;    // xyz [m] from the anchor, w scale
    vec4 rotation; // xyz, w: a quaternion; of length 1 once read
};

// Length 1; no rotation where nothing is left to turn.
WINDROW_FN vec4 windrow_rotation(vec4 quaternion) {
    float squared = dot(quaternion, quaternion);
    return squared > 1e-20f ? quaternion / sqrt(squared) : vec4(0.0f, 0.0f, 0.0f, 1.0f);
}

// The stage at or below a shell at `height` (0 root, 1 tip) among `stages`, 0 to stages - 1; the shell lies between it and the
// next.
WINDROW_FN int windrow_cascade_stage(float height, int stages) {
    return clamp(int(floor(height * float(stages))), 0, stages - 1);
}

// Share of the next stage, 0 to 1.
WINDROW_FN float windrow_cascade_fraction(float height, int stages) {
    return clamp(height * float(stages) - float(windrow_cascade_stage(height, stages)), 0.0f, 1.0f);
}

// The pose between two stages, its rotation of length 1.
WINDROW_FN WindrowPose windrow_pose_between(WindrowPose low, WindrowPose high, float share) {
    WindrowPose pose;
    pose.place = low.place + share * (high.place - low.place);
    pose.rotation = windrow_rotation(low.rotation + share * (high.rotation - low.rotation));
    return pose;
}

// A point of the body's own space in a pose whose rotation has length 1.
WINDROW_FN vec3 windrow_posed(WindrowPose pose, vec3 point) {
    vec3 axis = vec3(pose.rotation);
    vec3 scaled = pose.place.w * point;
    vec3 turned = 2.0f * cross(axis, scaled);
    return vec3(pose.place) + scaled + pose.rotation.w * turned + cross(axis, turned);
}

#endif
