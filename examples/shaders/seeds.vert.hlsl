// HLSL: seeds that the wind carries off a meadow, a point each, with the motion vector of each. The same include as GLSL has, from
// the same text: shaders/coupling/windrow_wind.hlsl.
//
//     dxc -spirv -T vs_6_0 -E main -I shaders examples/shaders/seeds.vert.hlsl -Fo seeds.spv
#define WINDROW_SET 0
#include "coupling/windrow_wind.hlsl"

struct Scene {
    float4x4 view_projection;          // from the anchor
    float4x4 view_projection_previous; // of the frame before
    float4 clock;                      // x [s] time, y [s] this frame's duration
};
[[vk::push_constant]] ConstantBuffer<Scene> scene;

struct Seed {
    float4 position : SV_Position;
    float4 before : POSITION1; // the same a frame ago, in its clip space: their difference is the motion vector
    float speed : TEXCOORD0;   // [m/s] for the colour
};

float random_of(uint number) {
    number = (number ^ 61u) ^ (number >> 16);
    number *= 9u;
    number = (number ^ (number >> 4)) * 0x27d4eb2du;
    return float(number ^ (number >> 15)) / 4294967296.0f;
}

Seed main(uint seed : SV_VertexID) {
    // Each seed leaves its plant anew every few seconds, and drifts with the wind that it meets there.
    float life = 4.0f, age = life * frac(scene.clock.x / life + random_of(3u * seed));
    float3 plant = float3(20.0f * random_of(3u * seed + 1u) - 10.0f, 0.6f, 20.0f * random_of(3u * seed + 2u) - 10.0f);
    float3 now = plant + age * windrow_velocity(plant), before = plant + (age - scene.clock.y) * windrow_velocity_previous(plant);

    Seed made;
    made.position = mul(scene.view_projection, float4(now, 1.0f));
    made.before = mul(scene.view_projection_previous, float4(before, 1.0f));
    made.speed = length(windrow_apparent(windrow_velocity(now), now, float3(0.0f, 0.0f, 0.0f)));
    return made;
}
