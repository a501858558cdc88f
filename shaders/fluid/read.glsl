// Cells of a part of the box as the frame shows them, written where the host reads them, behind the report. Define
// WINDROW_READ_CELL, their type, and WINDROW_READ(u), which makes one of a vec4.
#define WINDROW_PUSH WindrowReadPush
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) readonly buffer Before { vec4 before[]; };
layout(std430, set = 0, binding = 4) writeonly buffer Slot {
    WindrowReport report;
    WINDROW_READ_CELL cells[];
};
#include "fluid/shown.glsl"

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (inside(cell, push.size))
        cells[(cell.z * push.size.y + cell.y) * push.size.x + cell.x] =
            WINDROW_READ(shown_cell(cell_index(push.low + cell), push.factor));
}
