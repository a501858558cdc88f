// The ground memory in a shader: lean of the plants by wind and walkers, and the traces of walkers. For any stage.
//
//     #define WINDROW_GROUND_SET 2                       // yours; default 0
//     #include "coupling/windrow_ground.glsl"
//     vec4 ground = windrow_ground(p);                   // at p [m] from the anchor, of which x and z count
//     vec4 before = windrow_ground_previous(p);          // a frame ago, for motion vectors
//
// x, y the lean along x and z [rad], as a stem's bend: windrow_level(ground.xy) of windrow_plants.glsl; z how hard
// plants are pressed now (0 to 1), w [rad] length of the lean that stays as a trail.
//
// Set WINDROW_GROUND_SET (0 unless defined), bindings from WINDROW_GROUND_BINDING (0 unless defined):
//   + 0   uniform buffer   windrow::GroundBlock (coupling/motion_blocks.h)
//   + 1   sampler3D        texture of this frame, n x n x 1, in slots
//   + 2   sampler3D        texture of the frame before
// Any sampler does: texels are fetched and blended by hand, since slots wrap and texture units weigh with 8 fractional bits.
#ifndef WINDROW_GROUND_MEMORY_GLSL
#define WINDROW_GROUND_MEMORY_GLSL

#ifndef WINDROW_GROUND_SET
#define WINDROW_GROUND_SET 0
#endif
#ifndef WINDROW_GROUND_BINDING
#define WINDROW_GROUND_BINDING 0
#endif

#include "../numerics/ground_texels.glsl"

layout(std140, set = WINDROW_GROUND_SET, binding = WINDROW_GROUND_BINDING) uniform WindrowGroundFrame {
    WindrowGroundPlace windrow_ground_now;
    WindrowGroundPlace windrow_ground_before;
};
layout(set = WINDROW_GROUND_SET, binding = WINDROW_GROUND_BINDING + 1) uniform sampler3D windrow_ground_texels;
layout(set = WINDROW_GROUND_SET, binding = WINDROW_GROUND_BINDING + 2) uniform sampler3D windrow_ground_texels_before;

vec4 windrow_ground(vec3 p) { return windrow_ground_at(windrow_ground_texels, windrow_ground_now, p); }

vec4 windrow_ground_previous(vec3 p) { return windrow_ground_at(windrow_ground_texels_before, windrow_ground_before, p); }

#endif
