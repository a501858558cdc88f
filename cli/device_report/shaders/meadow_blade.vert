// A blade of grass out of the numbers of the blade and the vertex: no vertex buffer.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 look; // x height along the blade, 0 to 1; y bend [rad]; z random

const int k_segments = 3;               // two vertices each, and one at the tip
const float k_near = 1.6, k_far = 75.0; // [m] from the eye to the first blade of a fan and the last
const float k_half_angle = 0.78;        // [rad] half of the fan
const float k_thinnest = 0.0008;        // [rad] half of a blade's width as the eye sees it

float random_of(uint seed) { return windrow_fraction(windrow_plant_hash(uvec2(seed, 17u)).x); }

void main() {
    uint blade = uint(gl_InstanceIndex);
    float along = random_of(4u * blade), across = random_of(4u * blade + 1u);
    vec3 root;
    if (scene.walker.w > 0.0) {
        root = scene.walker.w * vec3(2.0 * along - 1.0, 0.0, 2.0 * across - 1.0);
    } else { // denser near the eye, as the inverse of distance to the power 3/2
        float reach = mix(sqrt(k_near), sqrt(k_far), (float(blade) + along) / scene.eye.w);
        float angle = k_half_angle * (2.0 * across - 1.0);
        root = vec3(scene.eye.x + reach * reach * sin(angle), 0.0, scene.eye.z - reach * reach * cos(angle));
    }
    WindrowBlade grass = scene.grass;
    grass.size.z = max(grass.size.z, k_thinnest * distance(root, scene.eye.xyz));
    uvec2 key = uvec2(blade, 3u);
    const vec3 up = vec3(0.0, 1.0, 0.0);
    vec3 bend = windrow_blade_bend(grass, root, up, key, vec3(0.0));
    float h = float(gl_VertexIndex / 2) / float(k_segments);
    float side = gl_VertexIndex == 2 * k_segments ? 0.0 : (gl_VertexIndex & 1) == 0 ? -1.0 : 1.0;
    WindrowVertex vertex = windrow_blade(grass, root, up, key, bend, scene.eye.xyz, h, side);
    position = vertex.position;
    normal = normalize(vertex.normal + 0.35 * side * cross(vertex.normal, vertex.tangent)); // as if the blade were rounded
    look = vec3(h, length(bend), random_of(4u * blade + 2u));
    gl_Position = scene.view_projection * vec4(position, 1.0);
}
