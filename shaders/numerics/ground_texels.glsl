// Sampling of the ground memory: texels of (lean x, lean z, trample, length of the trail), blended linearly, and faded over the
// blend zone to the lean of the wind alone. The blend zone follows the point, not the window, which moves by whole texels, so a
// shift of the window changes no value.
//
// A language that keeps texels elsewhere than in a sampler3D (of one layer) defines WINDROW_GROUND, the type of the parameter
// that stands for them, and windrow_ground_texel, before this text.
#ifndef WINDROW_GROUND_TEXELS_GLSL
#define WINDROW_GROUND_TEXELS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "ground.glsl"
#include "window.glsl"

#ifndef WINDROW_GROUND
#define WINDROW_GROUND sampler3D
WINDROW_FN vec4 windrow_ground_texel(WINDROW_GROUND texels, ivec2 slot) { return texelFetch(texels, ivec3(slot, 0), 0); }
#endif

// Where a frame's texels lie. The layout of windrow::GroundPlaceBlock (coupling/motion_blocks.h). Usable in a std140 block.
struct WindrowGroundPlace {
    vec4 corner; // xy [m] low corner (x and z) from the anchor, z [m] edge of a texel, w texels an axis
    // xy [m] the point that the rim follows, from the anchor; z [m] reach: distance at which all has faded; w [m] width of the
    // fading
    vec4 blend_zone;
    vec4 slot; // xy slot of the low corner; zw lean of the wind outside
};

// (lean x, lean z, trample, trail) at `p` [m] from the anchor, of which x and z count.
WINDROW_FN vec4 windrow_ground_at(WINDROW_GROUND texels, WindrowGroundPlace place, vec3 p) {
    vec4 outside = vec4(place.slot.z, place.slot.w, 0.0f, 0.0f);
    float share = windrow_blend_fraction(p.x - place.blend_zone.x, place.blend_zone.z, place.blend_zone.w) *
                  windrow_blend_fraction(p.z - place.blend_zone.y, place.blend_zone.z, place.blend_zone.w);
    if (!(share > 0.0f))
        return outside;
    vec2 at = (vec2(p.x, p.z) - vec2(place.corner.x, place.corner.y)) / place.corner.z - vec2(0.5f, 0.5f);
    vec2 whole = floor(at);
    vec2 between = at - whole;
    int n = int(place.corner.w);
    ivec2 low = ivec2(clamp(int(whole.x), 0, n - 1), clamp(int(whole.y), 0, n - 1));
    ivec2 high = ivec2(clamp(int(whole.x) + 1, 0, n - 1), clamp(int(whole.y) + 1, 0, n - 1));
    ivec2 corner = ivec2(int(place.slot.x), int(place.slot.y));
    vec4 ll = windrow_ground_texel(texels, windrow_ground_slot(low, corner, n));
    vec4 hl = windrow_ground_texel(texels, windrow_ground_slot(ivec2(high.x, low.y), corner, n));
    vec4 lh = windrow_ground_texel(texels, windrow_ground_slot(ivec2(low.x, high.y), corner, n));
    vec4 hh = windrow_ground_texel(texels, windrow_ground_slot(high, corner, n));
    vec4 l = ll + between.x * (hl - ll);
    vec4 h = lh + between.x * (hh - lh);
    return outside + share * (l + between.y * (h - l) - outside);
}

#endif
