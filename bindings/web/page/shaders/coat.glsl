// A coat of the page: the layout of coats.js. The equations are the library's and vegetation/shaders/fur's.
#include "page.glsl"
#include "vegetation/shaders/numerics/coat_lean.glsl"
#include "vegetation/shaders/numerics/strand_light.glsl"

struct CoatSpot {
    vec4 from; // xyz [m] in the mesh's space; w radius
    vec4 to;   // xyz; w [m] width of the soft edge
    vec4 tint; // rgb; w share
    vec4 more; // x length
};
layout(std140) uniform Coat {
    WindrowShells shells;
    WindrowStrandField field;
    vec4 coat_place;  // xyz [m]; w layers
    vec4 coat_turn;   // x, y cosine and sine of its yaw
    vec4 comb;        // xyz direction in the mesh's space; w [rad] bend
    vec4 tousle;      // x [rad]; y 1 / [m]; w bald_below
    vec4 root_colour; // rgb; w power of root to tip
    vec4 tip_colour;  // rgb; w variation
    vec4 second;      // rgb; w 1 / [m] of patches
    vec4 skin_colour; // rgb; w bias of the occlusion
    vec4 coat_light;  // x occlusion exponent; y wrap; z gloss; w its power
    vec4 sheen;       // x sheen; y its power; z through; w strand normals
    ivec4 coat_counts; // x vertices; y spots
    CoatSpot spots[24];
};

vec3 coat_turned(vec3 v) { return vec3(coat_turn.x * v.x + coat_turn.y * v.z, v.y, coat_turn.x * v.z - coat_turn.y * v.x); }

float spot_weight(CoatSpot spot, vec3 x) {
    vec3 along = spot.to.xyz - spot.from.xyz;
    float share = clamp(dot(x - spot.from.xyz, along) / max(dot(along, along), 1e-20), 0.0, 1.0);
    float beyond = length(x - spot.from.xyz - share * along) - spot.from.w;
    return 1.0 - smoothstep(0.0, max(spot.to.w, 1e-6), beyond);
}
// Share of the strands' length at a place.
float coat_length(vec3 x) {
    float share = 1.0;
    for (int n = 0; n < coat_counts.y; ++n)
        share *= mix(1.0, spots[n].more.x, spot_weight(spots[n], x));
    return share;
}
