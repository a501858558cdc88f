// Streaks of pixels: xy half of each [px], z [m] distance along the line of sight. `depth_at` gives the nearest depth of a pixel.
#include "blur_passes.glsl"

layout(set = 1, binding = 0) uniform sampler2D motion_map;
layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 streak;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 from = frame.from_clip * vec4(ndc, depth_at(pixel), 1.0);
    vec2 motion = texelFetch(motion_map, pixel, 0).xy;
    // The inverse of a perspective gives the inverse of clip space's w, which is the distance.
    streak = vec4(windrow_blur_streak(motion, vec2(textureSize(motion_map, 0)), push.open, push.most), 1.0 / from.w, 0.0);
}
