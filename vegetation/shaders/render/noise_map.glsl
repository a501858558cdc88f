// Maps that repeat, about a place that moves (render::NoiseMap): where they hold their noise, and which texels a pass fills.
#ifndef WINDROW_RENDER_NOISE_MAP_GLSL
#define WINDROW_RENDER_NOISE_MAP_GLSL

const float k_ground_texel = 0.25; // [m] of Terrain's map: half of the finest lumps
// [cells] Of the renderer's map of clouds, a quarter of the finest octave's cell: r five octaves, g four. The sheet drifts over it, 6
// m/s over texels of 11 m by default.
const float k_cloud_noise_texel = 1.0 / 64.0;

// Whether the map about `middle` holds a place, a texel to filter by included; `texel` as NoiseMapRecipe has it.
bool noise_map_holds(sampler2D map, float texel, vec2 place, vec2 middle) {
    vec2 away = abs(place - middle);
    return max(away.x, away.y) < (0.5 * float(textureSize(map, 0).x) - 2.0) * texel;
}

vec4 noise_map_at(sampler2D map, float texel, vec2 place) {
    return textureLod(map, place / (texel * float(textureSize(map, 0).x)), 0.0);
}

#ifdef NOISE_MAP_FILL
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Filled { ivec2 first_texel, texel_count; };

bool noise_map_is_wanted() { return all(lessThan(ivec2(gl_GlobalInvocationID.xy), texel_count)); }

// The middle of this invocation's texel.
vec2 noise_map_place(float texel) { return (vec2(first_texel + ivec2(gl_GlobalInvocationID.xy)) + 0.5) * texel; }

// Where it is in a map of this size, for texels below 0 too.
ivec2 noise_map_texel(ivec2 size) { return ((first_texel + ivec2(gl_GlobalInvocationID.xy)) % size + size) % size; }
#endif

#endif
