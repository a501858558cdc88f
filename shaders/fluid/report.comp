// The report, where no textures are written that would give it with them.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_PUSH WindrowReportPush
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Sums { vec2 sums[]; };
#define WINDROW_SOLIDS 4
#include "fluid/solids.glsl"
layout(constant_id = 3) const int k_group = 256; // invocations
#define WINDROW_AROUND 3
#define WINDROW_SLOT 5
#include "fluid/report.glsl"

void main() { write_report(push.sums, push.forces, push.forces_at); }
