#version 300 es
// A vertex of a blade. Light is found here: a blade is a few pixels wide.
#include "plants.glsl"
#include "vegetation/shaders/render/blade_width.glsl"

uniform sampler2D shown;
uniform int level_drawn, few_rows;
layout(location = 0) in vec2 tile; // of 16 x 16 cells, one for 256 blades
out vec3 light;

void main() {
    int n = cells.x, k = level_drawn, within = gl_InstanceID & 255;
    ivec2 slot = 16 * ivec2(tile) + ivec2(within & 15, within >> 4);
    vec4 state = texelFetch(shown, ivec2(slot.x, k * n + slot.y), 0);
    float size = fract(state.w);
    if (size < 0.02) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        light = vec3(0.0);
        return;
    }
    ivec2 cell = cell_in(n, base[k].xy, slot);
    vec2 place = place_of(k, cell);
    vec3 root = vec3(place.x, ground_height(place) - 0.01, place.y), up = vec3(0.0, 1.0, 0.0);
    uvec2 hash = windrow_plant_hash(windrow_grass_key(cell, seed_of(k), 0u));
    hash.x = (uint(state.w) << 24u) | (hash.x & 0xffffffu);

    WindrowBlade blade = blade_class;
    blade.size.x *= size;
    blade.size.z *= level[k].w * min(3.0 * size, 1.0);
    vec3 sight = root - eye.xyz;
    float distance = length(sight);
    WindrowBladePlant plant = windrow_blade_plant(blade, up, hash, windrow_level(state.xy), sight / max(distance, 1e-6));
    vec2 row = windrow_grass_row(gl_VertexID, cells.y == 7 && k == 0 ? WINDROW_GRASS_NEAR : WINDROW_GRASS_FAR, 3, 0.0);
    if (few_rows == 1) // two pairs and the tip
        row = gl_VertexID == 4 ? vec2(1.0, 0.0) : vec2(gl_VertexID < 2 ? 0.0 : 0.55, (gl_VertexID & 1) == 0 ? -1.0 : 1.0);
    float half_width = windrow_blade_half_width(blade, row.x);
    float h = row.x;
    if (look.head.w < 1.0 && h > look.head.w) { // an ear
        float u = (h - look.head.w) / (1.0 - look.head.w);
        half_width = max(half_width, look.shape.x * 2.0 * sqrt(max(u * (1.0 - u), 0.0)));
    }
    WindrowVertex vertex = windrow_blade_point(plant, h, row.y * half_width);
    vertex.position += root;
    vertex = wide_enough(vertex, row.y, half_width, eye.xyz, middle.z * (1.0 - h * 0.85));
    gl_Position = to_clip * vec4(vertex.position, 1.0);

    vec3 to_eye = normalize(eye.xyz - vertex.position);
    float own = windrow_fraction(hash.y * 2654435761u), colours = floor(state.z);
    float clump = floor(colours / 256.0) / 255.0, dry = (colours - 256.0 * floor(colours / 256.0)) / 255.0;
    // Afar one looks across the tips alone.
    float tall = mix(h * clamp(size * 1.1, 0.3, 1.0), k_seen_height, clamp((distance - 5.0) / 22.0, 0.0, 0.9));
    vec3 leaf = grass_albedo(look, tall, clump, own, dry);
    if (h > look.head.w)
        leaf = look.head.rgb;
    vec3 normal = vertex.normal;
    normal *= dot(normal, to_eye) < 0.0 ? -1.0 : 1.0;
    // Neighbours fill a blade's light in; more of it afar, where a pixel holds many.
    vec3 canopy = grass_canopy_normal(look, up, state.xy);
    normal = normalize(mix(normal, canopy, clamp(look.shape.w + distance / 40.0, 0.0, 0.85)));
    float sun = fract(state.z) / 0.996 * grass_self_shade(look, tall);
    float open = grass_open(look, tall);
    vec3 radiance = grass_radiance(look, leaf, grass_through(look, leaf, tall), normal, sky.sun.xyz, to_eye, sunlight.rgb * sun,
                                   skylight.rgb * open, groundlight.rgb * open, h * 0.8);
    light = toned(fogged(radiance, vertex.position));
}
