// The depth of what shell.frag shows, by the same steps: a pass of its own, before the colours.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "../render/frame.glsl"
#include "coat.glsl"
#include "coat_places.glsl"
#include "shell_strand.glsl"
#include "shell_fragment.glsl"

void main() { shell_fragment(); }
