#version 300 es
// Lines of the overlays, in the world.
#include "page.glsl"
layout(location = 0) in vec3 at;
layout(location = 1) in vec4 paint;
out vec4 tint;
void main() {
    tint = paint;
    gl_Position = to_clip * vec4(at, 1.0);
}
