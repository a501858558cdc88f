// What the shaders of examples/cpu_textures.cpp take as push constants. Positions [m] x and z from the middle of the picture.
layout(push_constant) uniform Plane {
    vec4 tower;     // xy where, z its radius
    vec4 house;     // xy where, zw its half size
    vec2 half_size; // of the picture
    vec2 pixels;    // of the picture
    vec2 box_half;  // of the wind's box
    // clang-format off
} plane;
// clang-format on
