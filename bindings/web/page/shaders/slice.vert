#version 300 es
// A slice of the box across one axis.
#include "page.glsl"
#include "shaders/coupling/windrow_wind.glsl"
uniform vec2 across; // x the axis, y where along it, 0 to 1
out vec3 position, within;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    within = across.x < 0.5 ? vec3(across.y, corner) : across.x < 1.5 ? vec3(corner.x, across.y, corner.y) : vec3(corner, across.y);
    vec3 size = windrow_frame.window.cells * windrow_frame.window.cell_size;
    size.y = windrow_frame.window.height;
    position = windrow_frame.window.origin + within * size;
    gl_Position = to_clip * vec4(position, 1.0);
}
