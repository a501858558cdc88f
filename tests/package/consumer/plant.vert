// A host's own vertex stage for blades of grass, with installed includes alone.
#version 450
#extension GL_GOOGLE_include_directive : require
#define WINDROW_SET 0
#include "coupling/windrow_plants.glsl"

layout(push_constant) uniform Draw {
    mat4 view_projection;
    vec4 root;
    WindrowBlade blade;
};

void main() {
    const uvec2 key = uvec2(gl_InstanceIndex, 0);
    const vec3 bend = windrow_blade_bend(blade, root.xyz, vec3(0.0, 1.0, 0.0), key, vec3(0.0));
    gl_Position = view_projection * vec4(root.xyz + bend, 1.0);
}
