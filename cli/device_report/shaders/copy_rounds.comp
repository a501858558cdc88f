// A copy over and over: each invocation copies `rounds` elements of a ring of `count`, a power of two; none where count is 0.
#version 460
layout(local_size_x_id = 0) in;
layout(std430, set = 0, binding = 0) readonly buffer From { vec4 from[]; };
layout(std430, set = 0, binding = 1) writeonly buffer To { vec4 to[]; };
layout(push_constant) uniform Push { uint count, rounds; };

void main() {
    if (count == 0u)
        return;
    uint threads = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint round = 0u; round < rounds; ++round) {
        uint n = (gl_GlobalInvocationID.x + round * threads) & (count - 1u);
        to[n] = from[n];
    }
}
