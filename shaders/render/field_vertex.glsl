// The vertices of a field's blade. Sets as field_blades.glsl has them.
#ifndef WINDROW_RENDER_FIELD_VERTEX_GLSL
#define WINDROW_RENDER_FIELD_VERTEX_GLSL

#include "frame.glsl"
#define GRASS_SET 3
#include "../grass/grass_blade.glsl"
#include "blade_width.glsl"
#include "field_blade.glsl"

layout(push_constant) uniform Which {
    int cascade;
    layout(offset = 8) uvec2 grass_draw; // x slot, y level + 2 * view
} which;

FieldBlade field_blade() {
    uint at = field_bases[4u * which.grass_draw.x + which.grass_draw.y] + uint(gl_InstanceIndex);
    return field_blades[at % uint(field_blades.length())];
}

// Height and side of this vertex.
vec2 field_row(uint morph) {
    return windrow_grass_row(gl_VertexIndex, int(which.grass_draw.y & 1u), uintBitsToFloat(morph));
}

// [m] from the anchor. `size` [m] length and half width, `bend` [rad] x and z.
WindrowVertex field_point(FieldBlade made, vec2 size, vec2 bend, vec2 row, vec3 eye, float least) {
    WindrowBlade blade = grass.blade;
    blade.size.x = size.x;
    blade.size.z = size.y;
    vec3 sight = made.root.xyz - eye;
    vec3 view = sight / max(length(sight), 1e-6);
    WindrowBladePlant plant = windrow_blade_plant(blade, vec3(0.0, 1.0, 0.0), made.traits.xy, vec3(bend.x, 0.0, bend.y), view);
    WindrowVertex vertex = windrow_blade_vertex(blade, plant, row.x, row.y);
    vertex.position += made.root.xyz;
    return wide_enough(vertex, row.y, windrow_blade_half_width(blade, row.x), eye, least);
}

#endif
