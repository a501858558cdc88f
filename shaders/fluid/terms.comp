// The pressure's history at closed faces, from the faces of the last placement of obstacles to those of this one.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"
#define WINDROW_SOLIDS 2
#include "fluid/solids.glsl"

layout(std430, set = 0, binding = 3) buffer Around {
    WindrowAround around;
    float around_words[];
};

void main() {
    for (int n = int(gl_LocalInvocationIndex); n < solids.face_count; n += int(gl_WorkGroupSize.x)) {
        const int before = solid_words[solids.before + n];
        around_words[solids.history + n] = before < 0 ? 0.0f : around_words[solids.history_before + before];
    }
}
