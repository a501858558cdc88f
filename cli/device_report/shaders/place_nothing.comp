// A shader that does nothing: sample_wind.comp without the sample.
#version 460

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Places { vec4 places[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Winds { vec4 winds[]; };

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n < places.length())
        winds[n] = vec4(places[n].xyz, 0.0);
}
