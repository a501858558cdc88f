// y = a x + b: one number of each kind that a pass is given, each at work.
#version 450

layout(local_size_x_id = 0) in;
layout(constant_id = 1) const float k_offset = 0.0;
layout(push_constant) uniform Push {
    uint count;
    float factor;
    // clang-format off
} push;
// clang-format on
layout(set = 0, binding = 0) readonly buffer From { float from[]; };
layout(set = 0, binding = 1) writeonly buffer To { float to[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < push.count)
        to[i] = push.factor * from[i] + k_offset;
}
