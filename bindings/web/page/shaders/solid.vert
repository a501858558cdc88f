#version 300 es
#include "page.glsl"
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 beside;
uniform mat4 model;
uniform mat4 camera; // to_clip, or to_shadow
out vec3 position, normal;
void main() {
    position = (model * vec4(at, 1.0)).xyz;
    normal = transpose(inverse(mat3(model))) * beside;
    gl_Position = camera * vec4(position, 1.0);
}
