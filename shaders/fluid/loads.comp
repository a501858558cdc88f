// Forces on obstacles: the impulse of the pressure on each, as SolidFlow::find_pushes and BodyLoads of the CPU. A work group takes
// one body after another.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_PUSH WindrowLoadsPush
#include "fluid/pass.glsl"
#define WINDROW_SOLIDS 2
#include "fluid/solids.glsl"

layout(std430, set = 0, binding = 3) readonly buffer Potential { float potential[]; };
layout(std430, set = 0, binding = 4) readonly buffer Correction { float correction[]; };
layout(std430, set = 0, binding = 5) readonly buffer Direction { float direction[]; };
#define WINDROW_AROUND 6
#define WINDROW_AROUND_ACCESS
#include "fluid/around.glsl"

layout(constant_id = 3) const int k_group = 64; // invocations
shared vec4 linear[k_group], angular[k_group];  // impulse and potential; moment and closed faces

// From the body's nearest image.
void add_impulse(vec3 arm, int axis, float held, inout vec4 force, inout vec4 moment) {
    const float h = tick.cell_size;
    const vec3 size = h * tick.period.xyz;
    arm -= size * round(arm / mix(size, vec3(1.0f), equal(size, vec3(0.0f))));
    vec3 along = vec3(0.0f);
    along[axis] = h * h * h * held;
    force.xyz += along;
    moment.xyz += cross(arm, along);
}

void add_push(int n, vec3 position, inout vec4 force, inout vec4 moment) {
    const SolidFace face = solid_face(n);
    const ivec3 low = solid_cell(face.cell[0]);
    const float area = face.axis == 1 ? 1.0f : row_volume(low.y); // over that of a cube's face
    float held = 0.0f;
    for (int end = 0; end < 2; ++end)
        if (!face_end_is_shut(face, end)) {
            const float here = area * face.closed * phi_at(cell_index(solid_cell(face.cell[end])));
            held += end == 0 ? here : -here;
            force.w += here;
            moment.w += area * face.closed;
        }
    add_impulse(face_middle(low, face.axis) - position, face.axis, held, force, moment);
}

// Less what the pressure gives to a cell inside, which is open in part.
void take_open(int at, vec3 position, inout vec4 force, inout vec4 moment) {
    const float slope = phi_at(cell_index(solid_cell(solid_words[at + 1]))) - phi_at(cell_index(solid_cell(solid_words[at])));
    add_impulse(centre_of(solid_cell(solid_words[at + 2])) - position, solid_words[at + 3], -solid_float(at + 4) * slope, force,
                moment);
}

void main() {
    const int local = int(gl_LocalInvocationIndex);
    for (int body = int(gl_WorkGroupID.x); body < solids.body_count; body += int(gl_NumWorkGroups.x)) {
        const vec3 position = solid_vec3(solids.bodies + WINDROW_BODY * body + 6);
        const int first = solid_words[solids.body_faces + body], end = solid_words[solids.body_faces + body + 1];
        vec4 force = vec4(0.0f), moment = vec4(0.0f);
        for (int n = first + local; n < end; n += k_group)
            add_push(solid_words[solids.body_list + n], position, force, moment);
        const int first_open = solid_words[solids.body_open + body], end_open = solid_words[solids.body_open + body + 1];
        for (int n = first_open + local; n < end_open; n += k_group)
            take_open(solids.open_list + WINDROW_OPEN_SIDE * n, position, force, moment);
        linear[local] = force;
        angular[local] = moment;
        barrier();
        for (int half_size = k_group / 2; half_size > 0; half_size /= 2) {
            if (local < half_size) {
                linear[local] += linear[local + half_size];
                angular[local] += angular[local + half_size];
            }
            barrier();
        }
        if (local < WINDROW_PUSHED) {
            const float wetted = angular[0].w;
            const float pushed = local < 3       ? linear[0][local]
                                 : local < 6     ? angular[0][local - 3]
                                 : local == 7    ? wetted
                                 : wetted > 0.0f ? linear[0].w * tick.cell_size / wetted
                                                 : 0.0f;
            const int history = solids.loads + WINDROW_LOAD * body + local, sources = history + WINDROW_PUSHED,
                      sum = sources + WINDROW_PUSHED, blast = sum + WINDROW_PUSHED;
            if (push.of_sources != 0) {
                around_words[blast] = push.of_sources == WINDROW_FIRST_SOURCES ? pushed : pushed - around_words[sources];
                around_words[sources] = pushed;
            } else {
                WindrowPast p;
                p.scale = p.kept = p.weight = 0.0f;
                if (!is_on(WINDROW_STABLE_FLUIDS))
                    p = past();
                const float before = p.scale > 0.0f ? around_words[history] : 0.0f;
                if (push.substep <= 0) { // a rehearsal counts for the history alone
                    around_words[sum] = 0.0f;
                    if (!is_on(WINDROW_RENEWS_SOURCE_FLOW))
                        around_words[blast] = 0.0f;
                }
                if (local == 7)
                    around_words[sum] = wetted;
                else
                    around_words[sum] += pushed + p.scale * before;
                around_words[history] = p.weight * pushed + p.kept * before;
            }
        }
        barrier();
    }
}
