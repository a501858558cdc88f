// A coat's vertices once a frame: bones, the body's pose, how far tips lag behind it, the comb, and the wind that strands feel
// there.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_SET 1
#define COAT_SKIN_WRITTEN
#include "shaders/coupling/windrow_plants.glsl"
#include "shaders/numerics/place_noise.glsl"
#include "coat.glsl"
#include "coat_places.glsl"

layout(local_size_x = 64) in;

// 1: nothing was before
layout(push_constant) uniform Now { int is_first; };

// By all four bones; weights add up to 1. A mesh without bones has weights of 0.
mat3x4 skinned(CoatVertex vertex, uint first) {
    vec4 x = vec4(1.0, 0.0, 0.0, 0.0), y = vec4(0.0, 1.0, 0.0, 0.0), z = vec4(0.0, 0.0, 1.0, 0.0);
    if (vertex.weights.x > 0.0) {
        mat4 sum = mat4(0.0);
        for (int n = 0; n < 4; ++n)
            if (vertex.weights[n] > 0.0)
                sum += vertex.weights[n] * bones[first + vertex.bones[n]];
        x = vec4(sum[0].x, sum[1].x, sum[2].x, sum[3].x);
        y = vec4(sum[0].y, sum[1].y, sum[2].y, sum[3].y);
        z = vec4(sum[0].z, sum[1].z, sum[2].z, sum[3].z);
    }
    return mat3x4(x, y, z); // rows of the affine map
}

WindrowPose pose_at(int stage, float share) {
    if (coat.counts.w == 0) {
        WindrowPose body = poses[0];
        body.rotation = windrow_rotation(body.rotation);
        return body;
    }
    return windrow_pose_between(poses[stage], poses[stage + 1], share);
}

vec3 turned(WindrowPose pose, vec3 v) {
    pose.place = vec4(0.0, 0.0, 0.0, 1.0);
    return windrow_posed(pose, v);
}

// The comb's direction at a place of the mesh, turned about the normal by chance.
vec3 combed(vec3 at, vec3 n) {
    vec3 along = windrow_across(coat.comb.xyz, n);
    float size = length(along);
    if (!(size > 1e-4) || !(coat.comb.w > 0.0))
        return vec3(0.0);
    along /= size;
    vec3 cell = at * coat.tousle.y;
    float chance = windrow_place_noise(cell.xy + 0.7 * cell.z) + windrow_place_noise(cell.yz + 0.3 * cell.x + 40.0) - 1.0;
    float turn = 2.0 * coat.tousle.x * chance;
    return (cos(turn) * along + sin(turn) * cross(n, along)) * (coat.comb.w * smoothstep(0.0, 0.3, size));
}

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= uint(coat.counts.x))
        return;
    CoatVertex vertex = vertices[n];
    mat3x4 rows = skinned(vertex, 0u);
    vec3 at = vec4(vertex.position.xyz, 1.0) * rows;
    vec3 normal = normalize(vec4(vertex.normal.xyz, 0.0) * rows);

    WindrowPose body = pose_at(0, 0.0);
    CoatSkin skin;
    float map = place_length(vertex.position.xyz, vec2(vertex.position.w, vertex.normal.w), 0.0);
    vec3 position = windrow_posed(body, at);
    vec3 up = turned(body, normal);
    skin.position = vec4(position, map);
    skin.normal = vec4(up, 0.0);
    skin.own = vec4(turned(body, vec4(combed(vertex.position.xyz, vertex.normal.xyz), 0.0) * rows), 0.0);
    skin.own.xyz = windrow_across(skin.own.xyz, up);

    skin.lag = skin.lag_more = vec4(0.0);
    if (coat.counts.w > 0) {
        int stages = coat.counts.w;
        vec3 tip = windrow_across(windrow_posed(pose_at(stages - 1, 1.0), at) - position, up);
        int stage = windrow_cascade_stage(0.5, stages);
        vec3 middle = windrow_across(windrow_posed(pose_at(stage, windrow_cascade_fraction(0.5, stages)), at) - position, up);
        skin.lag.xyz = 4.0 * middle - tip;
        skin.lag_more.xyz = 2.0 * tip - 4.0 * middle;
    }
    uint here = uint(coat.counts.y) + n, last = uint(coat.counts.z) + n;
    if (coat.ahead.z == 1) {
        WindrowPose soon = poses[coat.ahead.x];
        soon.rotation = windrow_rotation(soon.rotation);
        vec3 at_soon = vec4(vertex.position.xyz, 1.0) * skinned(vertex, uint(coat.ahead.y));
        skin.velocity = vec4((windrow_posed(soon, at_soon) - position) * coat.gone.w, 0.0);
    } else {
        skin.velocity = vec4(is_first == 1 ? vec3(0.0) : (position - skins[last].position.xyz) * coat.tousle.z, 0.0);
    }
    skin.load = vec4(0.0);
    if (coat.form.y != k_wind_at_pixel) {
        vec3 wind = coat.levels.z * windrow_wind_on(position + 0.5 * coat.shells.form.x * up, skin.velocity.xyz);
        // The translate form has the wind itself for its direction.
        skin.load.xyz =
            coat.form.x == 1 ? wind : windrow_shell_load(coat.shells, up, max(map, 0.05), wind) + feet_on(position, up);
    }
    skins[here] = skin;
    if (is_first == 1)
        skins[last] = skin;
}
