// The longest streak of some pixels around the place of the one drawn: of a tile's row, of a tile, of a tile and its neighbours.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "blur_passes.glsl"

layout(set = 1, binding = 0) uniform sampler2D streak_map;
layout(location = 0) in vec2 ndc;
layout(location = 0) out vec2 longest;

void main() {
    ivec2 last = textureSize(streak_map, 0) - 1;
    ivec2 first = ivec2(gl_FragCoord.xy) * push.stride - (push.count - push.stride) / 2;
    longest = vec2(0.0);
    for (int y = 0; y < push.count.y; ++y)
        for (int x = 0; x < push.count.x; ++x) {
            vec2 streak = texelFetch(streak_map, clamp(first + ivec2(x, y), ivec2(0), last), 0).xy;
            longest = dot(streak, streak) > dot(longest, longest) ? streak : longest;
        }
}
