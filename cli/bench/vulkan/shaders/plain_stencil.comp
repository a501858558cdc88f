// The plainest pass over a field of cells: each cell and its six neighbours, weighted; the rim repeats. What a step costs is told
// as a multiple of this, since it is what a device does with its memory when nothing else is in the way.
#version 450
layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(std430, set = 0, binding = 0) readonly buffer From { vec4 from[]; };
layout(std430, set = 0, binding = 1) writeonly buffer To { vec4 to[]; };
layout(push_constant) uniform Push { ivec4 cells; };

vec4 at(ivec3 cell) {
    cell = clamp(cell, ivec3(0), cells.xyz - 1);
    return from[(cell.z * cells.y + cell.y) * cells.x + cell.x];
}

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(cell, cells.xyz)))
        return;
    vec4 around = vec4(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        ivec3 step = ivec3(0);
        step[axis] = 1;
        around += at(cell - step) + at(cell + step);
    }
    to[(cell.z * cells.y + cell.y) * cells.x + cell.x] = 0.4 * at(cell) + 0.1 * around;
}
