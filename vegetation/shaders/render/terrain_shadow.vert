// The terrain as the sun sees it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "terrain_corner.glsl"

void main() {
    ivec2 at = terrain_corner();
    gl_Position = frame.shadow[cascade] * vec4(terrain_point(at), 1.0);
}
