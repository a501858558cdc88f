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
#define WINDROW_READING 5
layout(std430, set = 0, binding = 6) writeonly buffer Slot {
    WindrowReport report;
    vec4 winds[];
};
#include "fluid/shown.glsl"
#include "fluid/reading.glsl"
#include "numerics/wall_law.glsl"

vec4 cell(int x, int y, int z) {
    const SampledCell sampled = sampled_cell(ivec3(x, y, z), push.factor, push.shift);
    return vec4(sampled.velocity, sampled.height);
}

vec4 line(WindrowPoint point, int y, int z) { return mix(cell(point.low.x, y, z), cell(point.high.x, y, z), point.between.x); }

vec4 plane(WindrowPoint point, int z) { return mix(line(point, point.low.y, z), line(point, point.high.y, z), point.between.y); }

// By the law of the wall, as WindView reads it.
vec3 lowered(vec4 air, float over_floor) {
    const float height = windrow_wall_height(air.w, over_floor, push.wall_lowest, push.wall_fall);
    return windrow_wall_share(height, push.wall_per_length, push.wall_per_log) * air.xyz;
}

void main() {
    const int n = int(gl_GlobalInvocationID.x);
    if (n >= push.points)
        return;
    const WindrowPoint point = points[n];
    vec3 wind = point.ambient;
    if (point.fraction > 0.0f) {
        const vec4 air = mix(plane(point, point.low.z), plane(point, point.high.z), point.between.z);
        const vec3 inside = push.wall_per_log > 0.0f ? lowered(air, point.over_floor) : air.xyz;
        wind = point.fraction == 1.0f ? inside : mix(point.ambient, inside, point.fraction);
    }
    winds[n] = vec4(wind, 0.0f);
}
