#version 300 es
// One fragment a blade: its spring, the ground's memory, its light and size. The vertices of the blade read the result.
#include "plants.glsl"
#include "shaders/numerics/ground_texels.glsl"

uniform sampler2D swing_before, ripple_before;
uniform sampler3D ground_memory;
layout(std140) uniform Ground { WindrowGroundPlace ground_place; };

layout(location = 0) out vec4 swing_now;  // bend x, z [rad]; its velocity
layout(location = 1) out vec4 ripple_now; // what the detail adds; its velocity
layout(location = 2) out vec4 shown;      // bend x, z; z 256 clump + dry in whole numbers, light in the fraction; w yaw, size

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int n = cells.x, k = texel.y / n;
    ivec2 slot = ivec2(texel.x, texel.y - k * n);
    ivec2 cell = cell_in(n, base[k].xy, slot);
    bool goes_on = cells.z == 1 && cell == cell_in(n, base[k].zw, slot);
    vec2 place = place_of(k, cell);
    vec3 root = vec3(place.x, ground_height(place), place.y), up = vec3(0.0, 1.0, 0.0);
    uvec2 hash = windrow_plant_hash(windrow_grass_key(cell, seed_of(k), 0u));

    float share = level_share(k, place);
    if (share <= 0.0) { // another level's blades stand there
        swing_now = ripple_now = shown = vec4(0.0);
        return;
    }
    WindrowSwing swing;
    vec4 before = texelFetch(swing_before, texel, 0), ripple = texelFetch(ripple_before, texel, 0);
    swing.bend = before.xy;
    swing.velocity = before.zw;
    swing.ripple = ripple.xy;
    swing.ripple_speed = ripple.zw;
    int band = windrow_spring_band(windrow_blade_quickness(blade_class, hash));
    swing = windrow_blade_swing(swing_steps[band], blade_class, root, up, hash, vec3(0.0), goes_on, swing);
    swing_now = vec4(swing.bend, swing.velocity);
    ripple_now = vec4(swing.ripple, swing.ripple_speed);

    vec2 bend = swing.bend;
    if (grid.w > 0.5) {
        vec4 trodden = windrow_ground_at(ground_memory, ground_place, root);
        bend = (1.0 - trodden.z) * bend + trodden.xy;
    }
    WindrowClump clump = clump_of(place);
    float size = share * (1.0 - clumps.y * windrow_fraction(clump.chance.x * 2654435761u)) *
                 (1.0 - patches.y * windrow_place_noise((place + 512.0) * patches.x));
    WindrowGrass faces;
    faces.clump = clumps;
    uint yaw = windrow_grass_facing(faces, hash, clump).x >> 24u;
    float light = sun_fraction(root + vec3(0.0, 0.6 * blade_class.size.x, 0.0));
    float colours = 256.0 * floor(255.0 * windrow_fraction(clump.chance.y)) + floor(255.0 * windrow_dryness(place + 512.0));
    shown = vec4(bend, colours + 0.996 * light, float(yaw) + 0.999 * clamp(size, 0.0, 1.0));
}
