// The same bytes in and out as bend_plants.comp's pass over blades, and nothing else: what moving them costs.
#version 460

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer From { vec4 from[]; };
layout(std430, set = 0, binding = 1) writeonly buffer To { vec4 to[]; };

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (2 * n + 1 >= from.length())
        return;
    to[2 * n] = from[2 * n];
    to[2 * n + 1] = from[2 * n + 1];
}
