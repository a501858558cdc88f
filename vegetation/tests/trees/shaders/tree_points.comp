// All vertices of one tree as the stand's own shaders place them: this frame, its normal, the frame before.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "vegetation/shaders/render/frame.glsl"
#include "vegetation/shaders/trees/tree_parts.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 3, binding = 0) writeonly buffer Points { vec4 points[]; };
layout(push_constant) uniform Which {
    uint tree;
    uint first;
    uint count;
};

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= count)
        return;
    TreePlace place = places[tree];
    TreeVertex vertex = vertices[first + n];
    float scale = tree_scale(place, vertex, frame.eye.xyz);
    float scale_before = tree_scale(place, vertex, frame.eye_before.xyz);
    WindrowTreeVertex now = tree_point(place, vertex, tree_rest(place, vertex, frame.eye.xyz, scale, 1.0), scale);
    WindrowTreeVertex before =
        tree_point_before(place, vertex, tree_rest(place, vertex, frame.eye_before.xyz, scale_before, 1.0), scale_before);
    points[3u * n] = vec4(now.position, scale);
    points[3u * n + 1u] = vec4(now.normal, 0.0);
    points[3u * n + 2u] = vec4(before.position, scale_before);
}
