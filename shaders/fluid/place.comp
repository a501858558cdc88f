// Values for cells that the box exposes as it moves by `shift`, or for all cells where that is the whole box.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 7
#define WINDROW_PUSH WindrowPlacePush
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Given { vec4 given[]; };
layout(std430, set = 0, binding = 3) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 4) writeonly buffer History { vec4 history[]; };
layout(std430, set = 0, binding = 5) writeonly buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 6) writeonly buffer Before { vec4 before[]; };

#include "fluid/exposed.glsl"

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (!inside(cell, tick.cells) || !is_exposed(cell, push.shift))
        return;
    const int at = cell_index(cell);
    vec4 value = vec4(0.0f);
    if (push.value == WINDROW_PLACE_AMBIENT)
        value.xyz = around_at(cell, 0.0f, wind_at(cell, elapsed(), is_on(WINDROW_GUSTS)));
    else if (push.value == WINDROW_PLACE_ZERO)
        value.xyz = around_at(cell, 0.0f, vec3(0.0f));
    else if (push.value == WINDROW_PLACE_GIVEN)
        value = given[linear_index(cell)];
    else if (push.value == WINDROW_PLACE_NOW)
        value = velocity[now(at)];
    place(at, push.fields, value);
}
