#version 300 es
// The sky above the horizon, with its clouds, once a scene: x the azimuth, y from the horizon (1/2) to the zenith (1).
#include "page.glsl"
#include "vegetation/shaders/numerics/cloud_layer.glsl"
in vec2 ndc;
uniform vec2 cover; // of the clouds, their optical depth
out vec4 colour;
void main() {
    float turn = 3.14159265 * ndc.x;
    float y = max(ndc.y, 0.0);
    y *= y;
    vec3 ray = vec3(sqrt(1.0 - y * y) * cos(turn + 3.14159265), y, sqrt(1.0 - y * y) * sin(turn + 3.14159265));
    ray.xz = -ray.xz;
    WindrowClouds clouds = WindrowClouds(vec4(300.0, 300.0, 1100.0, 1.0 / 900.0), vec4(cover.x, cover.y, 0.6, 0.0));
    vec4 seen = windrow_cloud_radiance(clouds, sky.sun.xyz, vec3(0.0, 2.0, 0.0), ray, sunlight.rgb, 0.318309886 * skylight.rgb);
    colour = vec4(min(seen.rgb + seen.a * windrow_sky_radiance(sky, ray), vec3(6e4)), 1.0);
}
