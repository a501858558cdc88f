// Trees as the sun sees them. A card is smaller by what its leaves leave open, and casts a whole shadow.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "../render/frame.glsl"
#include "tree_parts.glsl"

layout(push_constant) uniform Which { int cascade; };

const float k_fill = 0.8; // root of the share of a card that is leaf

void main() {
    TreePlace place = places[gl_InstanceIndex];
    TreeVertex vertex = vertices[gl_VertexIndex];
    float scale = tree_scale(place, vertex, frame.eye.xyz);
    WindrowTreeVertex now = tree_point(place, vertex, tree_rest(place, vertex, frame.eye.xyz, scale, k_fill), scale);
    gl_Position = frame.shadow[cascade] * vec4(place.base.xyz + now.position, 1.0);
}
