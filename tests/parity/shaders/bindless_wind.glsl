// A host that holds several winds in arrays: textures and gust tiles by index, blocks in one storage buffer. It declares all
// bindings itself.
#ifdef NONUNIFORM
#extension GL_EXT_nonuniform_qualifier : require
#define COUNT
#define AT(n) nonuniformEXT(n)
#define OF(volumes, fetch) fetch(volumes[nonuniformEXT(textures.y)])
#else // llvmpipe indexes textures by constants alone
#define COUNT 2
#define AT(n) n
#define OF(volumes, fetch) (textures.y == 0 ? fetch(volumes[0]) : fetch(volumes[1]))
#endif

layout(set = 0, binding = 2) uniform sampler3D now[COUNT];
layout(set = 0, binding = 3) uniform sampler3D before[COUNT];
layout(std430, set = 0, binding = 4) readonly buffer Tile {
    vec4 texels[];
    // clang-format off
} tiles[COUNT];
// clang-format on

// x 0 this frame, 1 the one before; y number of the wind.
#define WINDROW_TEXTURES uvec2
#define EXACT(volume) texelFetch(volume, texel, 0)
#define FILTERED(volume) textureLod(volume, place, 0.0)
vec4 windrow_texel(uvec2 textures, ivec3 texel) { return textures.x == 0 ? OF(now, EXACT) : OF(before, EXACT); }
vec4 windrow_texture(uvec2 textures, vec3 place) { return textures.x == 0 ? OF(now, FILTERED) : OF(before, FILTERED); }
#define WINDROW_TILE uint
vec3 windrow_tile_texel(uint wind, ivec3 texel) { return tiles[AT(wind)].texels[(texel.z * 16 + texel.y) * 128 + texel.x].xyz; }

#include "coupling/windrow_sampling.glsl"

struct Wind {
    WindrowFrame frame;
    vec4 rows[WINDROW_ROW_BLOCKS];
};
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Places { vec4 places[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Winds { vec4 winds[]; };
layout(std430, set = 0, binding = 5) readonly buffer Frames { Wind frames[]; };
float windrow_row_height(uvec2 textures, int row) { return frames[textures.y].rows[row >> 2][row & 3]; }

// Now and before.
void sample_wind(uint wind, vec3 p, uint to) {
    winds[to] = vec4(windrow_velocity_at(uvec2(0, wind), wind, frames[wind].frame, p), 0.0);
    winds[to + 1] = vec4(windrow_velocity_previous_at(uvec2(1, wind), wind, frames[wind].frame, p), 0.0);
}

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= places.length())
        return;
#ifdef NONUNIFORM
    sample_wind(uint(places[n].w), places[n].xyz, 2 * n);
#else
    for (uint wind = 0; wind < COUNT; ++wind)
        sample_wind(wind, places[n].xyz, 2 * COUNT * n + 2 * wind);
#endif
}
