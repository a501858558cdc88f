// sample_wind.glsl in HLSL.
#define WINDROW_BINDING 2
#define WINDROW_EXACT
#include "coupling/windrow_wind.hlsl"

[[vk::binding(0, 0)]] StructuredBuffer<float4> places;
[[vk::binding(1, 0)]] RWStructuredBuffer<float4> winds; // now, before and felt of each place

[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {
    uint n = id.x, count, stride;
    places.GetDimensions(count, stride);
    if (n >= count)
        return;
    float3 p = places[n].xyz, u = windrow_velocity(p);
    winds[3 * n] = float4(u, 0.0f);
    winds[3 * n + 1] = float4(windrow_velocity_previous(p), 0.0f);
    winds[3 * n + 2] = float4(windrow_apparent(u, p, float3(0.0f, 0.0f, 0.0f)), 0.0f);
}
