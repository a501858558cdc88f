// A reader of the wind's textures: the texels of a row of cells, of this frame and of the one before.
#version 460

layout(local_size_x = 8) in;
layout(std430, set = 0, binding = 0) writeonly buffer Texels { vec4 texels[]; };
layout(set = 0, binding = 1) uniform sampler3D now;
layout(set = 0, binding = 2) uniform sampler3D before;

void main() {
    ivec3 cell = ivec3(gl_GlobalInvocationID.x, 3, 3);
    texels[2 * cell.x] = texelFetch(now, cell, 0);
    texels[2 * cell.x + 1] = texelFetch(before, cell, 0);
}
