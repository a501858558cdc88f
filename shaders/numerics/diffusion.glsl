// Choice of the diffusion method of a sub-step, by the ratio r = viscosity dt / h^2 (fluid/cpu/diffusion.cpp).
#ifndef WINDROW_DIFFUSION_GLSL
#define WINDROW_DIFFUSION_GLSL

// Below it none: its time is added to a later sub-step, since floats would round it away.
const float windrow_least_diffusion = 1e-4f;
// Up to it one explicit pass, above it the implicit solve: at 1/6 the shortest wave's factor would be -1.
const float windrow_most_explicit_diffusion = 1.0f / 12.0f;

#endif
