// Shift of a field with the box: cell x takes the value of x + shift. New cells, or all cells, get the ambient wind or 0.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 4
#define WINDROW_PUSH WindrowPlacePush
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer From { vec4 from[]; };
layout(std430, set = 0, binding = 3) writeonly buffer To { vec4 to[]; };

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (!inside(cell, tick.cells))
        return;
    const ivec3 source = cell + push.shift;
    vec4 value = vec4(0.0f);
    if (all(greaterThanEqual(source, ivec3(0))) && inside(source, tick.cells))
        value = from[cell_index(source)];
    else if (push.exposed_hold_ambient != 0)
        value.xyz = wind_at(cell, 0.0f, is_on(WINDROW_GUSTS));
    to[cell_index(cell)] = value;
}
