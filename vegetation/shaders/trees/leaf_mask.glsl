// What a leaf card shows: leaves strewn over it, or needles in combs along a twig.
//
// u runs along the card from root to tip, v across it from -1 to 1; the card is the kite |v| + |2 u - 1| <= 1. Leaves: two grids
// of cells, a leaf turned by chance in each, left out where its cell is beyond the kite. A card that has grown to stand for many
// has more cells, up to k_max_wide times, so that leaves stay as large as they are. Needles: side twigs leave the twig at a
// slant, u - s |v| is constant along one, and bear combs. Where leaves are smaller than a pixel, their mean. A leaf that flutters
// (flutter.glsl) turns about its own length: its width goes by the cosine. Ours.
#ifndef WINDROW_LEAF_MASK_GLSL
#define WINDROW_LEAF_MASK_GLSL

#include "shaders/numerics/flutter.glsl"
#include "shaders/numerics/place_noise.glsl"
#include "../render/sample_bits.glsl"

struct LeafMask {
    float coverage; // share of the pixel
    float leaf;     // chance of the leaf that is seen, 0 to 1
    float along;    // on that leaf, 0 to 1
    float turn;     // [rad] of that leaf about its length
};

const float k_max_wide = 5.0;
const float k_cells = 4.4; // along a card

// One grid of leaves: `at` in cells, `pixel` the size of a pixel there.
void add_leaves(inout LeafMask mask, vec2 at, vec2 card_cells, float pixel, int salt, uvec2 card_hash, WindrowFlutter flutter,
                float wind) {
    vec2 below = floor(at);
    ivec2 cell = ivec2(below) + ivec2(salt);
    uvec2 hash = windrow_plant_hash(uvec2(cell));
    // The middle of the cell on the card: its leaf hangs on the twig if that is on the card.
    vec2 middle = (below + 0.5) / card_cells;
    float rim = abs(2.0 * middle.x - 1.0) + abs(2.0 * middle.y);
    if (rim > 1.02)
        return;
    float turn = 6.28318531 * windrow_fraction(hash.x);
    vec2 off = at - below - 0.5;
    vec2 on = vec2(cos(turn) * off.x + sin(turn) * off.y, cos(turn) * off.y - sin(turn) * off.x);
    float along = clamp(on.x / 1.05 + 0.5, 0.0, 1.0);
    // Independent of the model, which other trees use too, and of the leaf's direction.
    float fluttered = windrow_flutter_angle(flutter, flutter.now, windrow_plant_hash(hash ^ card_hash), wind);
    float half_width = 1.05 * along * (1.0 - along) * (1.35 - 0.7 * along) * windrow_turn_cosine(0.159154943 * fluttered);
    float shown = clamp((half_width - abs(on.y)) / pixel + 0.5, 0.0, 1.0) * step(abs(on.x), 0.52);
    if (shown > mask.coverage) {
        mask.coverage = shown;
        mask.leaf = windrow_fraction(hash.y);
        mask.along = along;
        mask.turn = fluttered;
    }
}

LeafMask broad_mask(float u, float v, float wide, float chance, uvec2 card_hash, WindrowFlutter flutter, float wind) {
    vec2 card_cells = vec2(1.0, 0.8) * k_cells * min(wide, k_max_wide);
    vec2 at = vec2(u, 0.5 * v) * card_cells;
    float pixel = max(length(vec2(fwidth(at.x), fwidth(at.y))), 1e-4);
    LeafMask mask = LeafMask(0.0, 0.5, 0.5, 0.0);
    int salt = int(500.0 * (chance + 2.0));
    add_leaves(mask, at, card_cells, pixel, salt, card_hash, flutter, wind);
    vec2 aside = vec2(0.5, 0.37);
    LeafMask other = mask;
    add_leaves(other, at + aside, card_cells, pixel, salt + 4000, card_hash, flutter, wind);
    mask = other;
    float rim = 1.3 * length(vec2(2.0 * u - 1.0, v)); // round: a kite's corners would show
    vec2 clump = vec2(u, 0.5 * v) + 3.7 * (1.0 + chance);
    float noise = 0.5 * windrow_place_noise(clump * 8.0) + 0.5 * windrow_place_noise(clump * 19.0);
    float even = clamp(4.0 * (noise - 0.17 - 0.5 * rim * rim) + 0.5, 0.0, 1.0);
    float small = max(smoothstep(0.6, 1.4, pixel), smoothstep(2.0, 5.0, wide));
    mask.coverage = mix(mask.coverage, even, small);
    mask.leaf = mix(mask.leaf, clamp(0.5 + 2.0 * (noise - 0.5), 0.0, 1.0), small);
    mask.turn *= 1.0 - small;
    return mask;
}

LeafMask needle_mask(float u, float v, float wide, float chance) {
    const float slant = 0.3;
    float side = abs(v);
    float t = u - slant * side;
    float end = max(min(t / (0.5 - slant), (1.0 - t) / (0.5 + slant)), 1e-3); // side at which the kite ends along this needle
    float along = clamp(side / end, 0.0, 1.0);
    // Side twigs as fingers; on each, near enough to be seen, needles.
    float count = 6.0 * min(wide, 3.0);
    float place = t * count + (v < 0.0 ? 0.5 : 0.0);
    float across = abs(fract(place) - 0.5);
    float pixel = max(fwidth(t * count), 1e-4);
    float comb = 12.0 * side + 3.0 * across;
    float needles = smoothstep(0.15, 0.3, abs(fract(comb) - 0.5) + 0.15 - 0.5 * across);
    float needle_pixel = fwidth(comb);
    float half_width = 0.40 * (1.0 - 0.6 * along * along) * mix(needles, 0.85, smoothstep(0.25, 0.7, needle_pixel));
    LeafMask mask;
    mask.coverage = clamp((half_width - across) / pixel + 0.5, 0.0, 1.0);
    float rim = 1.3 * length(vec2(2.0 * u - 1.0, v));
    vec2 clump = vec2(t, 0.35 * v) + 3.7 * (1.0 + chance); // along needles
    float noise = 0.55 * windrow_place_noise(clump * vec2(9.0, 4.0)) + 0.45 * windrow_place_noise(clump * vec2(21.0, 8.0));
    float even = clamp(3.0 * (noise - 0.1 - 0.55 * rim * rim) + 0.5, 0.0, 1.0);
    mask.coverage = mix(mask.coverage, even, max(smoothstep(0.5, 1.0, pixel), smoothstep(1.2, 2.5, wide)));
    mask.coverage = max(mask.coverage, clamp((0.05 - side) / max(fwidth(v), 1e-4) + 0.5, 0.0, 1.0) * step(u, 0.95)); // the twig
    mask.leaf = mix(windrow_place_chance(ivec2(int(floor(place)), int(1000.0 * chance))), noise, 0.5);
    mask.along = along;
    mask.turn = 0.0;
    return mask;
}

// `wide` is the card's growth, 1 or more; `chance` -1 to 1 its own; `card_hash` is another for each tree; `wind` [m/s] the speed at
// its twig.
LeafMask leaf_mask(float u, float v, float wide, float chance, bool needles, uvec2 card_hash, WindrowFlutter flutter,
                   float wind) {
    if (needles)
        return needle_mask(u, v, max(wide, 1.0), chance);
    return broad_mask(u, v, max(wide, 1.0), chance, card_hash, flutter, wind);
}

#endif
