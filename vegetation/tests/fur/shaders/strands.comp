// The strands' texts on the device: what answer_of in strand_device_test.cpp computes on the CPU.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "vegetation/shaders/numerics/cloud_shells.glsl"
#include "vegetation/shaders/numerics/strand_light.glsl"

struct Case {
    vec4 place; // xy uv; z h; w of 0 to 1
    vec4 x;     // xyz [m] in the rest space
    vec4 n;     // xyz unit
    vec4 light; // xyz unit
    ivec4 cell;
    uvec4 which; // x the field
};
struct Answer {
    uvec4 keys;   // of a cell of the plane, of one in space
    uvec4 chosen; // keys of the strands at uv and on the surface
    vec4 chances;
    vec4 uv, uv_root, uv_outward;
    vec4 surface, surface_root, surface_outward;
    vec4 slope, light, gloss, normal, cloud;
};

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Cases { Case cases[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };
layout(std140, set = 0, binding = 2) uniform Fields {
    WindrowStrandField fields[8];
    WindrowCloudShells cloud;
};

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= cases.length())
        return;
    Case c = cases[index];
    WindrowStrandField field = fields[c.which.x];
    float h = c.place.z;
    vec3 n = c.n.xyz;
    Answer a;
    uvec2 key = windrow_strand_key(c.which.y, c.cell.xy);
    a.keys = uvec4(key, windrow_space_hash(c.which.y, c.cell.xyz));
    a.chances = vec4(windrow_strand_chance(key), windrow_strand_other_chance(key), windrow_strand_tone(key, 0.3),
                     windrow_turn_sine(c.x.x));
    WindrowStrandHit hit = windrow_strand_uv(field, c.place.xy, h);
    a.uv = vec4(hit.inside, hit.reach, hit.radius, hit.shaft);
    a.uv_root = vec4(hit.root, 0.0);
    a.uv_outward = vec4(hit.outward, 0.0);
    WindrowStrandHit on = windrow_strand_surface(field, c.x.xyz, n, h);
    a.surface = vec4(on.inside, on.reach, on.radius, windrow_strand_top(field));
    a.surface_root = vec4(on.root, 0.0);
    a.surface_outward = vec4(on.outward, 0.0);
    a.chosen = uvec4(hit.key, on.key);
    a.slope = windrow_simplex_slope(c.which.y, c.x.xyz);
    vec3 half_way = windrow_half_way(c.light.xyz, n, n);
    float cosine = dot(n, c.light.xyz);
    a.light = vec4(windrow_strand_occlusion(h, 0.7, 0.1), windrow_wrapped(cosine, c.place.w), windrow_cel(c.place.w, 4.0, 0.3),
                   windrow_noise_pair(h, c.place.w, 0.3, 0.8));
    a.gloss =
        vec4(windrow_plain_gloss(n, half_way, 24.0), windrow_hair_sheen(n, half_way, 40.0), windrow_tips_through(h, cosine), 0.0);
    vec3 g = windrow_strand_gradient(c.light.xyz, c.x.xyz, n, 0.0);
    a.normal =
        vec4(windrow_strand_sloped(g, n, windrow_strand_slope(field, 0.7 * h, 0.8) / 3.0), windrow_strand_patch(3u, c.x.xyz));
    float heap = windrow_cloud_heap(cloud, c.x.xz);
    a.cloud =
        vec4(heap, windrow_cloud_top(heap), windrow_cloud_rim(cloud, c.x.xz), windrow_cloud_inside(cloud, c.x.xz, 0.4 * h, heap));
    answers[index] = a;
}
