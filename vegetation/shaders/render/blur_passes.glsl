// What the passes of the blur share: the formulas, and a push of numbers (render::MotionBlur).
#ifndef WINDROW_RENDER_BLUR_PASSES_GLSL
#define WINDROW_RENDER_BLUR_PASSES_GLSL

#include "frame.glsl"
#include "../numerics/motion_blur.glsl"

layout(push_constant) uniform BlurPush {
    ivec2 stride; // of a pixel drawn, in pixels read
    ivec2 count;  // pixels read for one drawn, around its middle
    float open;   // fraction of a frame for which the shutter is open
    float most;   // [px] a half streak, a tile's width
}
push;

#endif
