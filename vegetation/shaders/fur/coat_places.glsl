// What belongs to a place of the mesh: length and colour of its strands by pictures and spots. After coat.glsl.
//
// Pictures are texels of a buffer, each half as wide as the one before; four are blended by hand, at the level whose texels are
// as large as a pixel, so that a border is where it was painted, whatever the mesh.
#ifndef WINDROW_SHELLS_COAT_PLACES_GLSL
#define WINDROW_SHELLS_COAT_PLACES_GLSL

const int k_length_picture = 0;
const int k_colour_picture = 1;
const int k_noise_picture = 2;

vec4 texel_of(ivec4 picture, ivec2 at) {
    uvec2 packed = texels[picture.x + at.y * picture.y + at.x];
    return vec4(unpackHalf2x16(packed.x), unpackHalf2x16(packed.y));
}

// `at` 0 to 1 over the picture, v downward; `wide` [of the picture] what a pixel covers. Repeated or held at its rim.
vec4 picture_at(int which, vec2 at, float wide, bool repeats) {
    ivec4 picture = coat.pictures[which];
    int level = clamp(int(floor(log2(max(wide * float(picture.y), 1.0)) + 0.5)), 0, picture.w - 1);
    for (; level > 0; --level) {
        picture.x += picture.y * picture.z;
        picture.y = max(picture.y / 2, 1);
        picture.z = max(picture.z / 2, 1);
    }
    ivec2 size = picture.yz;
    vec2 cell = (repeats ? fract(at) : clamp(at, 0.0, 1.0)) * vec2(size) - 0.5;
    vec2 below = floor(cell);
    vec2 share = cell - below;
    ivec2 low = ivec2(below), high = low + 1;
    if (repeats) {
        low = (low + size) % size;
        high = high % size;
    } else {
        low = clamp(low, ivec2(0), size - 1);
        high = clamp(high, ivec2(0), size - 1);
    }
    return mix(mix(texel_of(picture, low), texel_of(picture, ivec2(high.x, low.y)), share.x),
               mix(texel_of(picture, ivec2(low.x, high.y)), texel_of(picture, high), share.x), share.y);
}

// Where a place of the mesh lies on the pictures.
vec2 projected(vec3 x, vec2 uv) {
    vec3 share = (x - coat.low.xyz) * coat.extent.xyz;
    int projection = int(coat.low.w);
    if (projection == 1)
        return vec2(1.0 - share.z, 1.0 - share.y);
    if (projection == 2)
        return share.xz;
    if (projection == 3)
        return vec2(share.x, 1.0 - share.y);
    return vec2(uv.x, 1.0 - uv.y);
}

// What a pixel that covers `wide` [m] of the mesh covers of the pictures.
float projected_width(float wide, float wide_uv) {
    if (int(coat.low.w) == 0)
        return wide_uv;
    return wide * max(coat.extent.x, max(coat.extent.y, coat.extent.z));
}

// Weight of a spot at a place of the mesh, 1 within it.
float spot_weight(CoatSpot spot, vec3 x) {
    vec3 along = spot.to.xyz - spot.from.xyz;
    float share = clamp(dot(x - spot.from.xyz, along) / max(dot(along, along), 1e-20), 0.0, 1.0);
    float beyond = length(x - spot.from.xyz - share * along) - spot.from.w;
    if (spot.to.w <= 0.0)
        return beyond <= 0.0 ? 1.0 : 0.0;
    return 1.0 - smoothstep(0.0, spot.to.w, beyond);
}

// Share of the strands' length at a place, 0 to 1; `wide` what a pixel covers of the pictures.
float place_length(vec3 x, vec2 uv, float wide) {
    float share = 1.0;
    if (coat.pictures[k_length_picture].w > 0)
        share = clamp(picture_at(k_length_picture, projected(x, uv), wide, false).x, 0.0, 1.0);
    for (int n = 0; n < coat.drawing.z; ++n)
        share *= mix(1.0, coat.spots[n].more.x, spot_weight(coat.spots[n], x));
    return share;
}

// rgb what root and tip are multiplied by; w light of its own, once.
struct PlaceColour {
    vec3 factor;
    vec3 tint; // and the share of it in w of `glow`
    float tinted;
    vec3 glow;
};
PlaceColour place_colour(vec3 x, vec2 uv, float wide) {
    PlaceColour place = PlaceColour(vec3(1.0), vec3(0.0), 0.0, vec3(0.0));
    if (coat.pictures[k_colour_picture].w > 0)
        place.factor = picture_at(k_colour_picture, projected(x, uv), wide, false).rgb;
    for (int n = 0; n < coat.drawing.z; ++n) {
        float weight = spot_weight(coat.spots[n], x);
        float share = weight * coat.spots[n].tint.w;
        // A later spot lies over an earlier one.
        float both = share + place.tinted * (1.0 - share);
        place.tint = both > 0.0 ? mix(place.tint, coat.spots[n].tint.rgb, share / both) : place.tint;
        place.tinted = both;
        place.glow = place.glow * (1.0 - weight) + weight * coat.spots[n].more.y * coat.spots[n].tint.rgb;
    }
    return place;
}

#endif
