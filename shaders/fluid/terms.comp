// The pressure's history at closed faces and on bodies, from the last placement of obstacles to this one.
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
    const int first = int(gl_GlobalInvocationID.x), all = int(gl_WorkGroupSize.x * gl_NumWorkGroups.x);
    for (int n = first; n < solids.face_count; n += all) {
        const int before = solid_words[solids.before + n];
        around_words[solids.history + n] = before < 0 ? 0.0f : around_words[solids.history_before + before];
    }
    for (int n = first; n < WINDROW_LOAD * solids.body_count; n += all) {
        const int before = solid_words[solids.bodies_before + n / WINDROW_LOAD];
        around_words[solids.loads + n] =
            before < 0 ? 0.0f : around_words[solids.loads_before + WINDROW_LOAD * before + n % WINDROW_LOAD];
    }
}
