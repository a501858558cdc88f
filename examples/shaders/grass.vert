// A blade of grass that leans with the wind at its root: no vertex buffer, all of it from the numbers of the blade and the
// vertex.
//
// The blade is an arc of a circle that begins upright and turns by `bend` to its tip: its length stays, whatever blows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "coupling/windrow_wind.glsl"
#include "scene.glsl"

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 look; // x height along the blade, 0 to 1; y bend [rad]; z random

const int k_segments = 3;        // two vertices each, and one at the tip
const float k_near = 1.6;        // [m] from the eye to the first blade
const float k_far = 75.0;        // [m] to the last
const float k_half_angle = 0.72; // [rad] half the fan of directions that the eye sees
const float k_stiff_speed = 2.4; // [m/s] wind in which drag and stiffness are equal
const float k_max_bend = 2.1;    // [rad] as the wind grows without end: the tip points down a little

void main() {
    // Where it grows, around an eye that stands still: denser near it, as the inverse of distance to the power 3/2.
    uint blade = uint(gl_InstanceIndex);
    float share = (float(blade) + random_of(4u * blade)) / scene.eye.w;
    float reach = mix(sqrt(k_near), sqrt(k_far), share);
    float distance = reach * reach;
    float angle = k_half_angle * (2.0 * random_of(4u * blade + 1u) - 1.0);
    vec3 root = vec3(scene.eye.x + distance * sin(angle), 0.0, scene.eye.z - distance * cos(angle));
    float kind = random_of(4u * blade + 2u);
    float turned = 6.2831853 * random_of(4u * blade + 3u);
    float length_of = mix(0.38, 0.78, kind);
    float width = max(0.014, 0.0028 * distance); // two pixels at least

    // The wind, at half its height: at the very ground the log profile lets nothing blow. The detail ruffles single blades.
    vec3 at = root + vec3(0.0, 0.5 * length_of, 0.0);
    vec3 wind = windrow_apparent(windrow_velocity(at), at, vec3(0.0));

    // Drag grows with the square of the speed. It adds to the way in which this blade leans by itself.
    vec2 pull = wind.xz * length(wind.xz) / (k_stiff_speed * k_stiff_speed) + 0.22 * vec2(cos(3.0 * turned), sin(3.0 * turned));
    float strength = length(pull) * mix(1.25, 0.8, kind);
    float bend = k_max_bend * strength / (1.0 + strength);
    vec2 toward = pull / max(length(pull), 1e-6);

    float s = float(gl_VertexIndex / 2) / float(k_segments);
    float side = gl_VertexIndex == 2 * k_segments ? 0.0 : (gl_VertexIndex & 1) == 0 ? -1.0 : 1.0;
    float arc = max(bend, 1e-3);
    vec2 along = length_of * vec2(1.0 - cos(arc * s), sin(arc * s)) / arc; // outward and up
    vec3 tangent = vec3(toward.x * sin(arc * s), cos(arc * s), toward.y * sin(arc * s));
    vec3 flat_way = vec3(cos(turned), 0.0, sin(turned)), beside = vec3(cos(angle), 0.0, sin(angle));
    flat_way += (dot(flat_way, beside) < 0.0 ? -0.8 : 0.8) * beside; // half turned to the eye: an edge is thinner than a pixel
    vec3 across = normalize(flat_way - dot(flat_way, tangent) * tangent + vec3(0.0, 1e-4, 0.0));

    position = root + vec3(toward.x * along.x, along.y, toward.y * along.x) + (0.5 * width * (1.0 - s * s) * side) * across;
    normal = normalize(cross(across, tangent) + 0.35 * side * across); // as if the blade were rounded
    look = vec3(s, bend, random_of(blade ^ 0x9e3779b9u));
    gl_Position = scene.view_projection * vec4(position, 1.0);
}
