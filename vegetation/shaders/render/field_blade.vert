// A blade of a field, bent by this frame's wind, with the light that each of its rows sends to the eye; and where the same vertex
// was a frame ago.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "blade_light.glsl"
#include "field_vertex.glsl"
#include "grass_light.glsl"
#include "grass_view.glsl"
#include "shading.glsl"

// Nine floats: a vertex costs what it hands on, and above sixteen three times as much a float. On an NVIDIA H200 33 of them were
// half of the blades' time, and the arithmetic of both stages nothing.
layout(location = 0) out vec3 leaf;        // blade_light.glsl: colour
layout(location = 1) out vec3 lit;         // xy its light on the left half and on the right one, z side -1 to 1
layout(location = 2) out vec3 clip_before; // x, y and w a frame ago

void main() {
    FieldBlade blade = field_blade();
    vec2 row = field_row(blade.traits.z);
    float least = frame.eye_before.w * smoothstep(0.0, 0.25 * grass.blade.size.x, blade.size.x); // what shrinks away may vanish
    WindrowVertex now = field_point(blade, blade.size.xy, blade.bend.xy, row, frame.eye.xyz, least);
    WindrowVertex before =
        field_point(blade, blade.size.zw, blade.bend.zw, field_row(blade.traits.w), frame.eye_before.xyz, least);
    gl_Position = frame.view_projection * vec4(now.position, 1.0);
    clip_before = (frame.view_projection_before * vec4(before.position, 1.0)).xyw;
    if (frame.terrain_size.z != 0) { // as it is, whatever the light
        leaf = grass_view(frame.terrain_size.z, blade.bend.xy, grass_draw.y & 1u, uintBitsToFloat(blade.traits.z), grass_draw.x);
        leaf *= (0.35 + 0.65 * row.x) / frame.eye.w;
        lit = vec3(1.0, 1.0, row.y);
        return;
    }

    vec3 sight = frame.eye.xyz - now.position;
    float distance = length(sight);
    sight /= distance;
    // Height over the ground of the tallest, as if the blade had not shrunk away: a low blade stands in the shade of taller ones.
    // Afar it is what the ground there has.
    float full = grass.blade.size.x * max(blade.looks.w, 1e-3);
    float height = (now.position.y - blade.root.y) / grass.blade.size.x * full / max(blade.size.x, 1e-3 * full);
    float tall = clamp(mix(height, row.x, 0.35), 0.0, 1.0);
    tall = mix(tall, k_seen_height, 0.85 * smoothstep(0.3, 1.0, distance / look.size.y));
    vec3 albedo = grass_albedo(look, tall, blade.looks.y, blade.looks.z, blade.root.w);
    vec3 shines = grass_through(look, albedo, tall);
    if (row.x > field_head()) {
        albedo = look.head.rgb * (1.0 + look.tip.w * (2.0 * blade.looks.z - 1.0));
        shines = 0.3 * albedo;
    }
    // A crease along the middle, where a blade is seen wide enough to show it.
    float facing = dot(now.normal, sight);
    float shows = clamp(blade.size.y * abs(facing) / max(3.0 * frame.eye_before.w * distance, 1e-6) - 0.3, 0.0, 1.0);
    albedo *= 1.0 + look.shape.z * shows * (row.y == 0.0 ? 1.0 : -0.3);
    float even = look.shape.w + (0.85 - look.shape.w) * smoothstep(0.0, look.size.y, distance);
    even = mix(even, 1.0, blade.canopy.z); // afar a wave goes on over the ground
    vec3 to_sun = frame.sky.sun.xyz;
    float mapped = 1.0 - smoothstep(0.8 * frame.shadow_texel.w, frame.shadow_texel.w, distance);
    float own_shade = mix(1.0, grass_self_shade(look, tall), 1.0 - 0.6 * mapped); // the near map has some of it
    vec3 sun = frame.sunlight.rgb * (sun_fraction(now.position, to_sun) * own_shade);
    float open = grass_open(look, tall);
    vec3 sky = frame.skylight.rgb * open, below = frame.groundlight.rgb * open;
    float bent = 1.0 - now.tangent.y * now.tangent.y;
    float gloss = mix(row.x * (0.4 + 0.6 * bent), grass_canopy_gloss(look, blade.canopy.xy), blade.canopy.z);
    // On edge neither face is seen: the normal goes from one to the other by way of the eye's side, else thin blades would be
    // dotted.
    vec3 face =
        mix(normalize(sight + vec3(0.0, 1.0, 0.0)), facing < 0.0 ? -now.normal : now.normal, smoothstep(0.0, 0.4, abs(facing)));
    vec3 aside = look.second.w * shows * cross(now.tangent, now.normal); // of the right half; the left half leans the other way
    vec3 canopy = grass_canopy_normal(look, vec3(0.0, 1.0, 0.0), blade.canopy.z * blade.canopy.xy);
    vec3 n = normalize(mix(normalize(face - aside), canopy, even));
    vec3 left = grass_radiance(look, albedo, shines, n, to_sun, sight, sun, sky, below, gloss);
    vec3 right = left;
    if (look.second.w * shows > 0.0) { // a fold that is seen
        n = normalize(mix(normalize(face + aside), canopy, even));
        right = grass_radiance(look, albedo, shines, n, to_sun, sight, sun, sky, below, gloss);
    }
    BladeLight light = blade_light(left, right, albedo + shines, frame.sunlight.rgb + frame.skylight.rgb, blade.fog);
    leaf = light.colour;
    lit = vec3(light.lit, row.y);
}
