#version 300 es
#include "page.glsl"
in vec2 ndc;
out vec4 colour;
void main() {
    vec4 end = from_clip * vec4(ndc, 1.0, 1.0);
    vec3 ray = normalize(end.xyz / end.w - eye.xyz);
    colour = vec4(toned(sky_of(ray) + min(windrow_sun_radiance(sky, ray), vec3(40.0))), 1.0);
}
