// What is known of each visible blade of a grass field once a frame, beside the field's own lists: set 2 of a render::GrassLayer.
//
//   lists in their order, near blades before far ones:   field_blades[field_bases[4 slot + 2 view + level] + instance]
//
// There is room for so many; of more, those beyond are not drawn.
#ifndef WINDROW_RENDER_FIELD_BLADE_GLSL
#define WINDROW_RENDER_FIELD_BLADE_GLSL

#include "plant_look.glsl"

#ifndef FIELD_ACCESS
#define FIELD_ACCESS readonly
#endif

struct FieldBlade {
    vec4 root;    // xyz [m] from the anchor; w how dry its place is, 0 to 1
    vec4 bend;    // [rad] x and z in this frame's wind, x and z in the last one's
    vec4 size;    // [m] length of its class and half its width, as it is now; the same as it was a frame ago
    uvec4 traits; // xy its hash; z bits of its morph, w of the morph a frame ago
    vec4 looks;   // chances, 0 to 1: xy its clump's, z its own; w size over its class's
    vec4 fog;     // rgb light of the air before it, w share of its own light that comes through
    vec4 canopy;  // [rad] xy how grass leans here as a whole, x and z; z how much of it is seen, 0 near to 1 afar; w 0
};

layout(std140, set = 2, binding = 0) uniform Look { PlantLook look; };
layout(std430, set = 2, binding = 1) FIELD_ACCESS buffer FieldBlades { FieldBlade field_blades[]; };
layout(std430, set = 2, binding = 2) FIELD_ACCESS buffer FieldBases { uint field_bases[]; };

#endif
