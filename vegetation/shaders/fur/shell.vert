// A vertex of the skin on one layer of the coat: gl_InstanceIndex counts layers.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_SET 1
#include "shaders/coupling/windrow_plants.glsl"
#include "../render/frame.glsl"
#include "coat.glsl"
#include "shell_vertex.glsl"

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec4 rest; // xyz the root's place in the mesh's space; w height, -1 to 1
layout(location = 3) out vec3 rest_normal;
layout(location = 4) out vec2 uv;
layout(location = 5) out vec3 along;
layout(location = 6) out vec3 clip_now;
layout(location = 7) out vec3 clip_before;
layout(location = 8) flat out vec2 neighbours; // heights of the next inner and outer layer

vec3 wind_of(CoatSkin skin, float height) {
    if (coat.form.y != k_wind_at_shell)
        return skin.load.xyz;
    vec3 n = height < 0.0 ? -skin.normal.xyz : skin.normal.xyz;
    vec3 at = skin.position.xyz + coat.shells.form.x * abs(height) * n;
    vec3 wind = coat.levels.z * windrow_wind_on(at, skin.velocity.xyz);
    return coat.form.x == 1 ? wind
                            : (1.0 - skin.own.w) * (windrow_shell_load(coat.shells, n, max(skin.position.w, 0.05), wind) +
                                                    feet_on(skin.position.xyz, n));
}
vec3 wind_of_previous(CoatSkin skin, float height) {
    if (coat.form.y != k_wind_at_shell)
        return skin.load.xyz;
    vec3 n = height < 0.0 ? -skin.normal.xyz : skin.normal.xyz;
    vec3 at = skin.position.xyz + coat.shells.form.x * abs(height) * n;
    vec3 wind = coat.levels.z * windrow_wind_on_previous(at, skin.velocity.xyz);
    return coat.form.x == 1 ? wind
                            : (1.0 - skin.own.w) * (windrow_shell_load(coat.shells, n, max(skin.position.w, 0.05), wind) +
                                                    feet_on_before(skin.position.xyz, n));
}

void main() {
    // Outer ones first, but for the skin before all: it alone hides the whole far side.
    int layer = coat.layers.y == 0 || gl_InstanceIndex == 0 && coat.layers.z == 0 ? gl_InstanceIndex
                : coat.layers.z == 1                                              ? coat.layers.x - 1 - gl_InstanceIndex
                                                                                  : coat.layers.x - gl_InstanceIndex;
    float height = layer_height(layer, coat.levels.x);
    CoatVertex vertex = vertices[gl_VertexIndex];
    CoatSkin skin = skins[coat.counts.y + gl_VertexIndex];
    CoatSkin skin_before = skins[coat.counts.z + gl_VertexIndex];
    ShellPlace now = shell_place(skin, height, wind_of(skin, height));
    ShellPlace before = shell_place(skin_before, height, wind_of_previous(skin_before, height));

    position = now.position;
    normal = now.normal;
    along = now.along;
    rest = vec4(vertex.position.xyz, height);
    rest_normal = vertex.normal.xyz;
    uv = vec2(vertex.position.w, vertex.normal.w);
    int inward = coat.layers.z == 1 && height < 0.0 ? 1 : -1;
    neighbours =
        vec2(abs(layer_height(max(layer + inward, 0), coat.levels.x)), abs(layer_height(max(layer - inward, 0), coat.levels.x)));
    gl_Position = frame.view_projection * vec4(position, 1.0);
    clip_now = gl_Position.xyw;
    clip_before = (frame.view_projection_before * vec4(before.position - coat.gone.xyz, 1.0)).xyw;
}
