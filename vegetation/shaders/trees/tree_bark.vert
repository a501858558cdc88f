// Trunk, limbs and branches in the wind.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "../render/frame.glsl"
#include "tree_parts.glsl"

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec4 wood; // x around, 0 to 1 and back; y [m] along; z [m] radius of the stem; w the tree's chance
layout(location = 3) out vec4 open;
layout(location = 4) out vec3 clip_now;
layout(location = 5) out vec3 clip_before;

void main() {
    TreePlace place = places[gl_InstanceIndex];
    TreeVertex vertex = vertices[gl_VertexIndex];
    float scale = tree_scale(place, vertex, frame.eye.xyz);
    float scale_before = tree_scale(place, vertex, frame.eye_before.xyz);
    WindrowTreeVertex now = tree_point(place, vertex, tree_rest(place, vertex, frame.eye.xyz, scale, 1.0), scale);
    WindrowTreeVertex before =
        tree_point_before(place, vertex, tree_rest(place, vertex, frame.eye_before.xyz, scale_before, 1.0), scale_before);
    position = place.base.xyz + now.position;
    normal = now.normal;
    wood = vec4(vertex.normal.w, vertex.centre.w * place.base.w, length(vertex.position.xyz - vertex.centre.xyz) * place.base.w,
                place.turn.z);
    open = vec4(tree_turned(place, vertex.open.xyz), vertex.open.w);
    gl_Position = frame.view_projection * vec4(position, 1.0);
    clip_now = gl_Position.xyw;
    clip_before = (frame.view_projection_before * vec4(place.base.xyz + before.position, 1.0)).xyw;
}
