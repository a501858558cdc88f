// What colour a speed has in the debug views, linear light: ink, blue, sea blue, teal, leaf, straw, lighter and lighter. The
// stops of the map that `windrow run` draws its slices with (cli/drawing/colour_map.cpp has them in OKLab), joined by straight
// lines; tests hold the two together.
#ifndef WINDROW_SPEED_COLOUR_GLSL
#define WINDROW_SPEED_COLOUR_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// `share` of the scale, 0 calm to 1 fast; held beyond.
WINDROW_FN vec3 windrow_speed_colour(float share) {
    float at = 5.0f * clamp(share, 0.0f, 1.0f);
    vec3 colour = mix(vec3(0.003f, 0.004f, 0.018f), vec3(0.010f, 0.029f, 0.152f), min(at, 1.0f));
    colour = mix(colour, vec3(0.008f, 0.131f, 0.312f), clamp(at - 1.0f, 0.0f, 1.0f));
    colour = mix(colour, vec3(0.006f, 0.366f, 0.337f), clamp(at - 2.0f, 0.0f, 1.0f));
    colour = mix(colour, vec3(0.225f, 0.682f, 0.238f), clamp(at - 3.0f, 0.0f, 1.0f));
    colour = mix(colour, vec3(0.955f, 0.951f, 0.378f), clamp(at - 4.0f, 0.0f, 1.0f));
    return colour;
}

#endif
