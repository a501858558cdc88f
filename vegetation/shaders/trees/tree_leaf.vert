// A leaf card in the wind, and its light: cards are small, so that sun, shade and fog are taken at their corners.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "../render/shading.glsl"
#include "tree_parts.glsl"

layout(location = 0) out vec4 card; // x along, y across, z growth, w chance
layout(location = 1) out vec3 normal;
layout(location = 2) out vec4 sun;  // rgb irradiance that reaches the card; w share of the sky's light
layout(location = 3) out vec4 tone; // rgb what the fog adds; w what it leaves
layout(location = 4) out vec3 to_eye;
layout(location = 5) out vec3 clip_now;
layout(location = 6) out vec3 clip_before;
layout(location = 7) out vec3 shade;     // x how near the crown's rim, 0 to 1; y the tree's own chance; z [m/s] wind at its twig
layout(location = 8) flat out uvec2 own; // hash of the card on its tree

void main() {
    TreePlace place = places[gl_InstanceIndex];
    TreeVertex vertex = vertices[gl_VertexIndex];
    float scale = tree_scale(place, vertex, frame.eye.xyz);
    float scale_before = tree_scale(place, vertex, frame.eye_before.xyz);
    WindrowTreeVertex now = tree_point(place, vertex, tree_rest(place, vertex, frame.eye.xyz, scale, 1.0), scale);
    WindrowTreeVertex before =
        tree_point_before(place, vertex, tree_rest(place, vertex, frame.eye_before.xyz, scale_before, 1.0), scale_before);
    vec3 at = place.base.xyz + now.position;
    own = tree_leaf_hash(place, vertex);

    vec3 to_sun = frame.sky.sun.xyz;
    vec3 out_of_crown = tree_turned(place, vertex.open.xyz);
    float through_crown = clamp(vertex.open.w + dot(out_of_crown, to_sun), 0.0, 1.0);
    // The map has sharp shade of branches and of other trees; the crown's own is smoother and holds where the map ends. A leaf of
    // the rim is looked up a little outside of it: the map has whole cards where there are leaves with gaps.
    vec3 outside = at + 0.35 * place.base.w * out_of_crown / max(length(out_of_crown), 0.3);
    float lit = sun_fraction(outside, to_sun) * mix(0.3, 1.0, through_crown);
    sun = vec4(frame.sunlight.rgb * lit, clamp(vertex.open.w + 0.6 * out_of_crown.y, 0.04, 1.0));
    shade = vec3(clamp(vertex.open.w + 0.5 * length(vertex.open.xyz), 0.0, 1.0), place.turn.z,
                 tree_state(place, vertex.parts.y).velocity.w);
    normal = now.normal;
    to_eye = normalize(frame.eye.xyz - at);
    card = vec4(vertex.normal.w, vertex.centre.w, scale, uintBitsToFloat(vertex.parts.z));
    vec3 added = fogged(vec3(0.0), at);
    tone = vec4(added, fogged(vec3(1.0), at).g - added.g);
    gl_Position = frame.view_projection * vec4(at, 1.0);
    clip_now = gl_Position.xyw;
    clip_before = (frame.view_projection_before * vec4(place.base.xyz + before.position, 1.0)).xyw;
}
