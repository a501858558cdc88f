// The vertices of a field's blade. Sets as field_blades.comp has them.
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
};

FieldBlade field_blade() {
    uint at = field_bases[4u * grass_draw.x + grass_draw.y] + uint(gl_InstanceIndex);
    if (at >= uint(field_blades.length())) { // no room for it: it has no size
        FieldBlade none = field_blades[0];
        none.size = vec4(0.0);
        return none;
    }
    return field_blades[at];
}

// Height on the blade from which on it is a head; 1 none.
float field_head() { return look.head.w; }

// Height and side of this vertex. Where there is a head the upper three rows and the tip are its own.
vec2 field_row(uint morph) {
    vec2 row = windrow_grass_row(gl_VertexIndex, int(grass_draw.y & 1u), int(grass.ground.w), uintBitsToFloat(morph));
    const float below = 4.0 / 7.0;
    if (field_head() < 1.0)
        row.x = row.x < below ? row.x * field_head() / below : mix(field_head(), 1.0, (row.x - below) / (1.0 - below));
    return row;
}

// [m] from the anchor. `size` [m] length and half width, `bend` [rad] x and z.
WindrowVertex field_point(FieldBlade made, vec2 size, vec2 bend, vec2 row, vec3 eye, float least) {
    WindrowBlade blade = grass.blade;
    blade.size.x = size.x;
    blade.size.z = size.y;
    vec3 sight = made.root.xyz - eye;
    vec3 view = sight / max(length(sight), 1e-6);
    WindrowBladePlant plant = windrow_blade_plant(blade, vec3(0.0, 1.0, 0.0), made.traits.xy, vec3(bend.x, 0.0, bend.y), view);
    float half_width = windrow_blade_half_width(blade, row.x);
    if (row.x > field_head()) { // a seed head or a flower at the end, round across: as wide from every side
        float u = (row.x - field_head()) / (1.0 - field_head());
        float grown = min(size.y / max(grass.blade.size.z, 1e-6), 1.6); // as the stalk; a far one stays a head
        half_width = max(half_width, look.shape.x * grown * 2.0 * sqrt(u * (1.0 - u)));
        least = max(least, 0.8 * half_width / max(length(sight), 1e-3));
    }
    WindrowVertex vertex = windrow_blade_point(plant, row.x, row.y * half_width);
    vertex.position += made.root.xyz;
    return wide_enough(vertex, row.y, half_width, eye, least);
}

#endif
