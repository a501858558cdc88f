// The pressure in sealed air is relative to none: takes the mean of phi off in each of its parts, one after another. One work group.
// As SolidFlow::level of the CPU.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_PUSH WindrowLoadsPush
#include "fluid/pass.glsl"
#define WINDROW_SOLIDS 2
#include "fluid/solids.glsl"

layout(std430, set = 0, binding = 3) buffer Potential { float potential[]; };
layout(std430, set = 0, binding = 4) readonly buffer Correction { float correction[]; };
layout(std430, set = 0, binding = 5) readonly buffer Direction { float direction[]; };
#define WINDROW_AROUND 6
#define WINDROW_AROUND_ACCESS readonly
#include "fluid/around.glsl"

#include "fluid/total.glsl"

void main() {
    const int local = int(gl_LocalInvocationIndex);
    int first = 0;
    for (int part = 0; part < solids.part_count; ++part) {
        const int end = solid_words[solids.parts + 2 * part];
        vec2 sum = vec2(0.0f);
        for (int n = first + local; n < end; n += k_group) {
            const ivec3 cell = solid_cell(solid_words[solids.part_cells + n]);
            sum += row_volume(cell.y) * vec2(phi_at(cell_index(cell)), 1.0f);
        }
        sum = total(sum);
        for (int n = first + local; n < end; n += k_group)
            potential[cell_index(solid_cell(solid_words[solids.part_cells + n]))] -= sum.x / sum.y;
        first = end;
    }
}
