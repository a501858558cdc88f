// The formulas of plants in motion, each once for 16 random numbers.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "numerics/cascade.glsl"
#include "numerics/direction_memory.glsl"
#include "numerics/spring.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Inputs { mat4 inputs[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Outputs { mat4 outputs[]; };
layout(push_constant) uniform Push { WindrowSpringStep spring; };

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= inputs.length())
        return;
    mat4 i = inputs[n];
    vec2 place = i[0].xy, velocity = i[0].zw, before = i[1].xy, now = i[1].zw;
    outputs[n][0] = vec4(place + windrow_spring_place(spring, place, velocity, before, now),
                         velocity + windrow_spring_velocity(spring, place, velocity, before, now));
    outputs[n][1] = vec4(windrow_direction_memory(0.5 * i[2].xyz, normalize(i[3].xyz), 10.0, abs(i[2].w)), 0.0);
    WindrowPose low = WindrowPose(i[0], i[1]), high = WindrowPose(i[2], i[3]);
    float height = abs(i[3].w);
    WindrowPose pose = windrow_pose_between(low, high, windrow_cascade_fraction(height, 7));
    outputs[n][2] = vec4(windrow_posed(pose, i[1].xyz), float(windrow_cascade_stage(height, 7)));
    outputs[n][3] = pose.rotation;
}
