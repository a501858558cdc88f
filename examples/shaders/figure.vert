// The walker and the fan, out of capsules: a ball at each end of a tapering tube, one an instance.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 paint;

const int k_rows = 8, k_columns = 12; // 6 k_rows k_columns vertices
const int k_blades_of_fan = 5, k_ring = 24;

struct Capsule {
    vec3 from, to;
    vec2 radius; // [m] at both ends
    vec3 paint;
};

// Parts 0 to 6: he walks two steps in 1.5 m, arms against legs.
Capsule walker_part(int part) {
    vec3 ahead = vec3(cos(scene.walker.w), 0.0, sin(scene.walker.w)), left = vec3(ahead.z, 0.0, -ahead.x),
         up = vec3(0.0, 1.0, 0.0);
    vec3 feet = scene.walker.xyz, hip = feet + 0.9 * up, shoulder = feet + 1.42 * up + 0.05 * ahead;
    float stride = sin(6.2831853 * dot(feet, ahead) / 1.5);
    if (part == 0)
        return Capsule(feet + 1.66 * up + 0.07 * ahead, feet + 1.72 * up + 0.07 * ahead, vec2(0.105), vec3(0.55, 0.33, 0.22));
    if (part == 1)
        return Capsule(hip, shoulder - 0.05 * up, vec2(0.15, 0.20), vec3(0.62, 0.07, 0.04));
    if (part == 2)
        return Capsule(feet + 1.76 * up + 0.05 * ahead, feet + 1.80 * up + 0.04 * ahead, vec2(0.115, 0.09),
                       vec3(0.75, 0.66, 0.40));
    float at = (part & 1) == 0 ? 1.0 : -1.0;
    float swing = 0.6 * at * stride;
    if (part < 5)
        return Capsule(hip + 0.09 * at * left, hip + 0.09 * at * left - 0.86 * (cos(swing) * up - sin(swing) * ahead),
                       vec2(0.10, 0.06), vec3(0.05, 0.07, 0.14));
    return Capsule(shoulder + 0.22 * at * left, shoulder + 0.26 * at * left - 0.6 * (cos(swing) * up + sin(swing) * ahead),
                   vec2(0.075, 0.05), vec3(0.62, 0.07, 0.04));
}

// Part 0: the post; then the blades; then the ring.
Capsule fan_part(int part) {
    vec3 hub = scene.fan.xyz, axis = scene.fan_axis.xyz;
    vec3 level = normalize(cross(axis, vec3(0.0, 1.0, 0.0))), upward = cross(level, axis);
    float radius = scene.fan_axis.w;
    if (part == 0)
        return Capsule(vec3(hub.x, 0.0, hub.z) - 0.12 * axis, hub - 0.12 * axis, vec2(0.07, 0.05), vec3(0.30, 0.31, 0.33));
    if (part <= k_blades_of_fan) {
        float turn = scene.fan.w + 6.2831853 * float(part) / float(k_blades_of_fan);
        return Capsule(hub, hub + 0.9 * radius * (cos(turn) * level + sin(turn) * upward), vec2(0.05, 0.10),
                       vec3(0.70, 0.42, 0.05));
    }
    float one = 6.2831853 * float(part) / float(k_ring), other = 6.2831853 * float(part + 1) / float(k_ring);
    return Capsule(hub + radius * (cos(one) * level + sin(one) * upward),
                   hub + radius * (cos(other) * level + sin(other) * upward), vec2(0.05), vec3(0.62, 0.64, 0.66));
}

void main() {
    Capsule made = gl_InstanceIndex < 7 ? walker_part(gl_InstanceIndex) : fan_part(gl_InstanceIndex - 7);
    // Two triangles a face of a grid of rows and columns.
    int face = gl_VertexIndex / 6, corner = gl_VertexIndex % 6;
    int row = face / k_columns + ((corner == 1 || corner == 2 || corner == 4) ? 1 : 0);
    int column = face % k_columns + ((corner == 2 || corner == 4 || corner == 5) ? 1 : 0);
    // The lower half of the rows lies on the ball at one end, the upper half on the other.
    bool upper = 2 * row > k_rows;
    float latitude = 3.1415927 * (float(upper ? row - 1 : row) / float(k_rows - 1) - 0.5);
    float longitude = 6.2831853 * float(column) / float(k_columns);
    vec3 axis = normalize(made.to - made.from);
    vec3 one = normalize(abs(axis.y) < 0.9 ? cross(axis, vec3(0.0, 1.0, 0.0)) : cross(axis, vec3(1.0, 0.0, 0.0)));
    normal = cos(latitude) * (cos(longitude) * one + sin(longitude) * cross(axis, one)) + sin(latitude) * axis;
    position = (upper ? made.to : made.from) + (upper ? made.radius.y : made.radius.x) * normal;
    paint = made.paint;
    gl_Position = scene.view_projection * vec4(position, 1.0);
}
