// Wind at points that the host asked for, written where it reads them, behind the report: as WindView::velocity, whose place
// among the cells, weight and ambient wind come with each point.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_PUSH WindrowPointsPush
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) readonly buffer Before { vec4 before[]; };
layout(std430, set = 0, binding = 4) readonly buffer Points { WindrowPoint points[]; };
layout(std430, set = 0, binding = 5) writeonly buffer Slot {
    WindrowReport report;
    vec4 winds[];
};
#include "fluid/shown.glsl"

vec3 cell(int x, int y, int z) { return shown_cell(cell_index(ivec3(x, y, z)), push.factor).xyz; }

vec3 line(WindrowPoint point, int y, int z) { return mix(cell(point.low.x, y, z), cell(point.high.x, y, z), point.between.x); }

vec3 plane(WindrowPoint point, int z) { return mix(line(point, point.low.y, z), line(point, point.high.y, z), point.between.y); }

void main() {
    const int n = int(gl_GlobalInvocationID.x);
    if (n >= push.points)
        return;
    const WindrowPoint point = points[n];
    vec3 wind = point.ambient;
    if (point.fraction > 0.0f) {
        const vec3 inside = mix(plane(point, point.low.z), plane(point, point.high.z), point.between.z);
        wind = point.fraction == 1.0f ? inside : mix(point.ambient, inside, point.fraction);
    }
    winds[n] = vec4(wind, 0.0f);
}
