// A vertex of Dear ImGui: place in pixels, place in the texture, colour in sRGB.
#version 450

layout(set = 0, binding = 0, std430) readonly buffer Vertices {
    uint words[]; // ImDrawVert: x, y, u, v, RGBA
};
layout(push_constant) uniform Push {
    vec2 scale;
    vec2 shift;
};
layout(location = 0) out vec2 place;
layout(location = 1) out vec4 colour;

void main() {
    const int first = gl_VertexIndex * 5;
    place = vec2(uintBitsToFloat(words[first + 2]), uintBitsToFloat(words[first + 3]));
    colour = unpackUnorm4x8(words[first + 4]);
    colour.rgb = pow(colour.rgb, vec3(2.2)); // the target is linear
    gl_Position = vec4(vec2(uintBitsToFloat(words[first]), uintBitsToFloat(words[first + 1])) * scale + shift, 0.0, 1.0);
}
