// Turbulent stress over rough ground, one column an invocation: fluid/solids/surface_layer.h has the method and the tables. The fourth
// component of `diffused` keeps what the system's second half needs.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 7
#define WINDROW_MAY_PLAN
#include "fluid/pass.glsl"
#include "fluid/planning.glsl"
#include "numerics/lee.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) readonly buffer Force { vec4 force[]; };
layout(std430, set = 0, binding = 4) readonly buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 5) readonly buffer Layer { float layer[]; }; // faces, then two tables of the ambient wind
layout(std430, set = 0, binding = 6) buffer Diffused { vec4 diffused[]; };
#define WINDROW_SOLIDS 8
#include "fluid/prescribed.glsl"

// One row of a column: u, the part of it that is solved for, and the ambient wind A; of horizontal components.
struct Row {
    vec2 u, v, wind;
    float vertical; // of what is solved for
    float lee;
};

Row row_at(ivec3 cell) {
    Row row;
    const vec3 wind = wind_at(cell, elapsed(), is_on(WINDROW_GUSTS));
    row.wind = wind.xz;
    row.vertical = row.lee = 0.0f;
    if (cell.y < 0 || cell.y >= tick.cells.y) { // beyond the box the air is ambient
        row.u = row.wind;
        row.v = is_on(WINDROW_GUSTS) ? vec2(0.0f) : row.wind;
        return row;
    }
    const int at = cell_index(cell);
    vec3 u = velocity[now(at)].xyz;
    if (is_on(WINDROW_STABLE_FLUIDS) && is_on(WINDROW_PUSHES))
        u += WINDROW_OF_PLAN.substep_duration * force[at].xyz;
    vec3 v = u; // as solved_part
    if (is_on(WINDROW_DIFFUSES)) {
        v = diffused[at].xyz;
    } else {
        if (is_on(WINDROW_HAS_SOURCE_FLOW))
            v -= source_flow[at].xyz;
        if (is_on(WINDROW_GUSTS) && !is_sheltered(cell))
            v -= wind;
    }
    row.u = u.xz;
    row.v = v.xz;
    row.vertical = v.y;
    row.lee = velocity[now(at)].w;
    return row;
}

struct Face {
    bool inner; // between cells, not over a surface
    float bond;
    vec2 known;
};

Face face_between(Row low, Row high, float passes, float wind_mixing, float wind_drag) {
    const float below = passes > 0.0f ? 1.0f : 0.0f, factor = WINDROW_OF_PLAN.substep_duration / tick.cell_size;
    const vec2 u = high.u - below * low.u, v = high.v - below * low.v, wind = high.wind - below * low.wind;
    const float mixed = passes > 0.0f && has_lee() ? passes * windrow_lee_mixing(low.lee, high.lee) : abs(passes);
    const float k = factor * mixed * length(u);
    const float of_wind = passes > 0.0f ? wind_mixing : passes < 0.0f ? wind_drag : 0.0f;
    const float k_wind = factor * of_wind * length(wind), most = max(k, k_wind - 0.5f);
    const float rest = (is_on(WINDROW_GUSTS) ? k : 0.0f) - k_wind;
    return Face(passes > 0.0f, k + most, rest * wind - most * v);
}

void main() {
    const int nx = tick.cells.x, ny = tick.cells.y, column = int(gl_GlobalInvocationID.x);
    if (column >= nx * tick.cells.z)
        return;
    find_plan(false);
    ivec3 cell = ivec3(column % nx, 0, column / nx);
    const int faces = cell.z * (ny + 1) * nx + cell.x, mixing = tick.cells.z * (ny + 1) * nx, drag = mixing + ny + 1;
    Row here = row_at(cell);
    Row next = row_at(ivec3(cell.x, -1, cell.z));
    vec2 swept = next.v;
    float passes = layer[faces];
    Face low = face_between(next, here, passes, is_on(WINDROW_PROFILE) ? layer[mixing] : passes, layer[drag]);
    float ratio = 0.0f;
    for (int j = 0; j < ny; ++j) {
        cell.y = j;
        const int at = cell_index(cell);
        next = row_at(ivec3(cell.x, j + 1, cell.z));
        passes = layer[faces + (j + 1) * nx];
        const Face high = face_between(here, next, passes, is_on(WINDROW_PROFILE) ? layer[mixing + j + 1] : passes,
                                       j + 1 < ny ? layer[drag + j + 1] : 0.0f);
        const float to_low = low.inner ? low.bond : 0.0f, to_high = high.inner ? high.bond : 0.0f;
        const vec2 known = (high.inner ? high.known : vec2(0.0f)) - low.known;
        const float thick = row_volume(j);
        const float pivot = 1.0f / (thick + low.bond + to_high - to_low * ratio);
        ratio = to_high * pivot;
        swept = (thick * here.v + known + to_low * swept) * pivot;
        diffused[at] = vec4(swept.x, here.vertical, swept.y, ratio);
        here = next;
        low = high;
    }
    vec2 above = here.v;
    for (int j = ny - 1; j >= 0; --j) {
        cell.y = j;
        const int at = cell_index(cell);
        const vec4 kept = diffused[at];
        above = kept.xz + kept.w * above;
        diffused[at] = vec4(above.x, kept.y, above.y, 0.0f);
    }
}
