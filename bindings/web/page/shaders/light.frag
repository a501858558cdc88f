#version 300 es
// What a sun of an elevation and a haze gives, in six texels: optical depths of the air and of the haze, irradiance of its beam, and
// of the sky on level ground, radiance near the horizon under the sun and opposite (as vegetation/render/frame_block.cpp has them).
precision highp float;
#include "vegetation/shaders/numerics/sky.glsl"
uniform vec4 sun;  // xyz toward it, w radius
uniform vec3 given; // x irradiance above the air, y haze, z asymmetry of its scattering
uniform vec3 wavelengths;
out vec4 colour;
void main() {
    WindrowSky sky;
    sky.sun = sun;
    sky.rayleigh = vec4(windrow_rayleigh_depth(wavelengths.x), windrow_rayleigh_depth(wavelengths.y), windrow_rayleigh_depth(wavelengths.z), given.x);
    sky.haze = vec4(windrow_haze_depth(wavelengths.x, given.y), windrow_haze_depth(wavelengths.y, given.y), windrow_haze_depth(wavelengths.z, given.y), given.z);
    int n = int(gl_FragCoord.x);
    vec3 sum = vec3(0.0);
    if (n == 3)
        for (int row = 0; row < 16; ++row)
            for (int column = 0; column < 32; ++column) {
                float mu = (float(row) + 0.5) / 16.0, across = sqrt(1.0 - mu * mu), turn = 6.2831853 * (float(column) + 0.5) / 32.0;
                sum += windrow_sky_radiance(sky, vec3(across * cos(turn), mu, across * sin(turn))) * mu * (6.2831853 / 512.0);
            }
    if (n > 3) {
        vec2 level = normalize(sun.xz) * (n == 4 ? 1.0 : -1.0);
        colour = vec4(windrow_sky_radiance(sky, normalize(vec3(level.x, 0.08, level.y))), 0.0);
        return;
    }
    colour = n == 0 ? sky.rayleigh : n == 1 ? sky.haze : n == 2 ? vec4(windrow_sun_irradiance(sky), 0.0) : vec4(sum, 0.0);
}
