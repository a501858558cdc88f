#version 300 es
// A vertex of the skin on a layer, the outermost layer first (vegetation/shaders/fur/shell_vertex.glsl).
#include "coat.glsl"
uniform sampler2D strand_bend, strand_own;
uniform mat4 camera;
uniform bool depth_alone;
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 beside;
out vec3 position, normal, along, rest, rest_normal;
flat out float height;

void main() {
    ivec2 texel = ivec2(gl_VertexID % 64, gl_VertexID / 64);
    vec4 bend = texelFetch(strand_bend, texel, 0);
    height = depth_alone ? 0.4 : windrow_shell_height(shells, coat_place.w - 1.0 - float(gl_InstanceID));
    rest = at;
    rest_normal = beside;
    normal = coat_turned(beside);
    WindrowCoatStrand strand =
        windrow_coat_strand(shells, normal, bend.w, bend.xyz, texelFetch(strand_own, texel, 0).xyz, vec3(0.0), vec3(0.0));
    position = coat_place.xyz + coat_turned(at) + (strand.stem.reach * height + shells.form.x * shells.form.z) * normal +
               windrow_coat_shift(strand, height);
    along = normal + windrow_coat_tangent(strand, height);
    gl_Position = camera * vec4(position, 1.0);
}
