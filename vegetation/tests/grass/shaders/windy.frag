// still.frag's colours from what grass_wind.vert gives; what is no number, or no unit vector, is not drawn, and misses in the
// picture.
#version 460
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 look;
layout(location = 0) out vec4 pixel;

void main() {
    float square = dot(normal, normal);
    // interpolated between unit vectors: shorter, never longer
    if (!(abs(position.x) < 1e6) || !(square > 0.25 && square < 1.0001))
        discard;
    pixel = vec4(look.zw, 0.25 + 0.75 * look.x, 1.0);
}
