#version 300 es
// One fragment a vertex of a coat: the bend that the wind holds there, and the comb's (vegetation/shaders/fur/coat_skin.comp).
#include "coat.glsl"
#include "shaders/coupling/windrow_plants.glsl"
uniform sampler2D skin_places; // two texels a vertex: place and normal in the mesh's space
layout(location = 0) out vec4 bend; // xyz [rad] of the wind; w share of the strands' length
layout(location = 1) out vec4 own;  // xyz [rad] of the comb

vec3 combed(vec3 at, vec3 n) {
    vec3 along = windrow_across(comb.xyz, n);
    float size = length(along);
    if (!(size > 1e-4) || !(comb.w > 0.0))
        return vec3(0.0);
    along /= size;
    vec3 cell = at * tousle.y + 512.0;
    float chance = windrow_place_noise(cell.xy + 0.7 * cell.z) + windrow_place_noise(cell.yz + 0.3 * cell.x + 40.0) - 1.0;
    float turn = 2.0 * tousle.x * chance;
    return (cos(turn) * along + sin(turn) * cross(n, along)) * (comb.w * smoothstep(0.0, 0.3, size));
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    bend = own = vec4(0.0);
    if (64 * texel.y + texel.x >= coat_counts.x)
        return;
    vec3 at = texelFetch(skin_places, ivec2(2 * texel.x, texel.y), 0).xyz, n = texelFetch(skin_places, ivec2(2 * texel.x + 1, texel.y), 0).xyz;
    float map = coat_length(at);
    vec3 up = coat_turned(n), position = coat_place.xyz + coat_turned(at);
    vec3 wind = windrow_wind_on(position + 0.5 * shells.form.x * up, vec3(0.0));
    bend = vec4(windrow_shell_load(shells, up, max(map, 0.05), wind), map);
    own = vec4(windrow_across(coat_turned(combed(at, n)), up), 0.0);
}
