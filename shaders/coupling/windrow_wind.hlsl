// The wind in an HLSL shader: windrow_wind.glsl's functions from the same text, shader model 6 or glslang's HLSL. For any stage.
//
//     #define WINDROW_SET 2                          // yours; default 0
//     #include "coupling/windrow_wind.hlsl"
//     float3 u = windrow_velocity(p);                // [m/s] at p [m] from the anchor
//     float3 before = windrow_velocity_previous(p);  // a frame ago, for motion vectors
//     float3 felt = windrow_apparent(u, p, v);       // relative to an object that moves at v [m/s]
//
// Under Vulkan the bindings are those of windrow_wind.glsl with one texture, from WINDROW_BINDING (0 unless defined) of WINDROW_SET:
// a texture and its sampler share a binding of the type COMBINED_IMAGE_SAMPLER, so SetWrites of fluid/vulkan/textures.h serves both.
// Under Direct3D the registers are b, t, t + 1, t + 2, s of WINDROW_SPACE (space0 unless defined), each number as defined here:
//   b WINDROW_B   windrow::FrameBlock (fluid/textures.h), copied as it is
//   t WINDROW_T   texture of this frame, of the one before, gust tile as StructuredBuffer<float4>: WINDROW_T, _T1 and _T2
//   s WINDROW_S   sampler, as windrow_sampling.glsl says
// WINDROW_EXACT is as there. Names of GLSL's types are macros within this text and undefined behind it.
#ifndef WINDROW_WIND_HLSL
#define WINDROW_WIND_HLSL

#ifndef WINDROW_SET
#define WINDROW_SET 0
#endif
#ifndef WINDROW_BINDING
#define WINDROW_BINDING 0
#endif
#ifndef WINDROW_SPACE
#define WINDROW_SPACE space0
#endif
#ifndef WINDROW_B
#define WINDROW_B b0
#endif
#ifndef WINDROW_T
#define WINDROW_T t0
#define WINDROW_T1 t1
#define WINDROW_T2 t2
#endif
#ifndef WINDROW_S
#define WINDROW_S s0
#endif

#define vec3 float3
#define vec4 float4
#define ivec3 int3
#define floatBitsToUint asuint

[[vk::binding(WINDROW_BINDING + 1, WINDROW_SET)]] Texture3D<float4> windrow_vectors : register(WINDROW_T, WINDROW_SPACE);
[[vk::binding(WINDROW_BINDING + 1, WINDROW_SET)]] SamplerState windrow_sampler : register(WINDROW_S, WINDROW_SPACE);
[[vk::binding(WINDROW_BINDING + 2, WINDROW_SET)]] Texture3D<float4> windrow_vectors_before : register(WINDROW_T1, WINDROW_SPACE);
[[vk::binding(WINDROW_BINDING + 3, WINDROW_SET)]] StructuredBuffer<float4> windrow_tile_texels : register(WINDROW_T2, WINDROW_SPACE);

// 0 this frame, 1 the one before; constant where it is called.
#define WINDROW_TEXTURES int
float4 windrow_texel(int frame, int3 texel) {
    if (frame == 0)
        return windrow_vectors.Load(int4(texel, 0));
    return windrow_vectors_before.Load(int4(texel, 0));
}
float4 windrow_texture(int frame, float3 place) {
    if (frame == 0)
        return windrow_vectors.SampleLevel(windrow_sampler, place, 0.0f);
    return windrow_vectors_before.SampleLevel(windrow_sampler, place, 0.0f);
}
#define WINDROW_TILE int
float3 windrow_tile_texel(int tile, int3 texel) { return windrow_tile_texels[(texel.z * 16 + texel.y) * 128 + texel.x].xyz; }

#include "windrow_sampling.glsl"

[[vk::binding(WINDROW_BINDING, WINDROW_SET)]] cbuffer WindrowBlock : register(WINDROW_B, WINDROW_SPACE) {
    WindrowFrame windrow_frame;
    float4 windrow_rows[WINDROW_ROW_BLOCKS];
};
float windrow_row_height(int frame, int row) { return windrow_rows[row >> 2][row & 3]; }

float3 windrow_velocity(float3 p) { return windrow_velocity_at(0, 0, windrow_frame, p); }
float3 windrow_velocity_previous(float3 p) { return windrow_velocity_previous_at(1, 0, windrow_frame, p); }
float3 windrow_apparent(float3 u, float3 p, float3 velocity) {
    return windrow_felt(0, windrow_frame.ambient, u - velocity, p);
}
float3 windrow_apparent_previous(float3 u, float3 p, float3 velocity) {
    return windrow_felt(0, windrow_frame.previous_ambient, u - velocity, p);
}

#undef vec3
#undef vec4
#undef ivec3
#undef floatBitsToUint

#endif
