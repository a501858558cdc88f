// What a vertex of a blade hands on of its light, and what a fragment makes of it: five numbers, and its side -1 to 1.
//
//   L_k = radiance behind the air, of the left half and of the right one     k = 1, 2
//   l_k = light on them over a scale, 1 where the air hides them             handed on: "lit"
//   c   = (L_1 + L_2) / (l_1 + l_2)                                          handed on: "colour", as leaves have it
//   L   = c (sqrt(l_1) (1 - t) + sqrt(l_2) t)^2, t = 1/2 + clamp(3 side, -1, 1) / 2    the fragment's
//
// Between two rows both colour and light change, and a product of two lines is not a line: L by itself, interpolated, is lighter
// than the light of a leaf between (by 1.4 of 255 levels over a picture of wheat, where this is within 0.1). Across the fold the
// light goes by the square of a cosine's sum (leaf_light.glsl), so that its root is what is even there.
#ifndef WINDROW_RENDER_BLADE_LIGHT_GLSL
#define WINDROW_RENDER_BLADE_LIGHT_GLSL

struct BladeLight {
    vec3 colour;
    vec2 lit;
};

// `left` and `right` are radiance before the air; `leaf` what a leaf reflects and lets through, `light` the irradiance in the open,
// of which only the sums matter; `air` as air_before gives it.
BladeLight blade_light(vec3 left, vec3 right, vec3 leaf, vec3 light, vec4 air) {
    const vec3 sum = vec3(1.0);
    float scale = 0.1 * dot(leaf, sum) * dot(light, sum); // of a leaf in the open l is about 1
    BladeLight made;
    made.lit = max(mix(vec2(1.0), vec2(dot(left, sum), dot(right, sum)) / max(scale, 1e-6), air.w), 1e-3);
    made.colour = mix(2.0 * air.rgb, left + right, air.w) / (made.lit.x + made.lit.y);
    return made;
}

vec3 blade_radiance(vec3 colour, vec2 lit, float side) {
    vec2 root = sqrt(max(lit, 0.0));
    float across = mix(root.x, root.y, 0.5 + clamp(1.5 * side, -0.5, 0.5)); // the fold is the middle third
    return colour * (across * across);
}

#endif
