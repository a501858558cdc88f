// What plants look like: the layout of render::PlantLookBlock (vegetation/render/plant_look_block.h). Colours are linear albedo.
#ifndef WINDROW_RENDER_PLANT_LOOK_GLSL
#define WINDROW_RENDER_PLANT_LOOK_GLSL

struct PlantLook {
    vec4 root;    // rgb; w what the neighbours leave of the sky's light at the root, 0 to 1
    vec4 tip;     // rgb; w share of the colour's spread between one plant and the next
    vec4 dry;     // rgb of the driest tips; w exponent of the gloss
    vec4 through; // rgb of light that shines through; w how much more of it against the light
    // x [m] from which on blades are drawn wider, y [m] where normals have become the ground's; z share of dry patches, w how far waves of
    // the wind turn its normal afar
    vec4 size;
    vec4 second; // rgb of other clumps' tips; w tangent of the fold along a blade
    vec4 head;   // rgb of seed heads and flowers; w from which height on, 1 none
    vec4 soil;   // rgb of bare ground, w 0
    // x [m] half of a head's width, y how much of the sun the neighbours take, z how much lighter the midrib is, w share of the
    // ground's normal near the eye
    vec4 shape;
};

#endif
