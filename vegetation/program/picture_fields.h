// Every field of a picture's structures that is a number, a place or a colour: its key, its range, its unit. The reader and the
// writer both go through these lists, so that neither can forget what the other knows; defaults are the structures' own.
//
// `Fields` has real, number, integer, whole, place, colour, pair: FieldReader and FieldWriter.
#pragma once

#include "scene/setting_reader.h"
#include "vegetation/program/picture_scene.h"

namespace windrow::vegetation::program {

using windrow::Range;
using windrow::scene::k_place_rule;

inline constexpr Range k_share_rule{.least = 0.0, .most = 1.0};

/// But for position and target, which may be paths.
template <class Fields>
void list_fields(Fields& fields, render::Camera& camera) {
    fields.real({"view_deg", "Height of the picture as an angle."}, camera.view_deg,
                {.least = 1.0, .most = 150.0, .unit = "deg"});
    fields.real({"near", "What is nearer is not drawn."}, camera.near, {.least = 1e-3, .most = 1e3, .unit = "m"});
    fields.real({"far", "Nor what is farther; 1.01 to 1e6 times near."}, camera.far,
                {.least = 1.01e-3, .most = 1e9, .unit = "m"});
    fields.real({"exposure", "Factor on light before the film's curve."}, camera.exposure, {.least = 1e-6, .most = 1e6});
}

template <class Fields>
void list_fields(Fields& fields, render::Sun& sun) {
    fields.real({"elevation_deg", "Above the horizon."}, sun.elevation_deg, {.least = 1.0, .most = 90.0, .unit = "deg"});
    fields.real({"azimuth_deg", "Where it stands, from x (0) toward z (90)."}, sun.azimuth_deg,
                {.least = -360.0, .most = 360.0, .unit = "deg"});
    fields.real({"irradiance", "Above the air, in units of the picture."}, sun.irradiance, {.least = 1e-6, .most = 100.0});
    fields.real({"haze", "Angstrom's turbidity. 0.06: a clear summer's day."}, sun.haze, {.least = 0.0, .most = 0.5});
    fields.real({"radius_deg", "Of the disk, as seen from the earth."}, sun.radius_deg,
                {.least = 0.05, .most = 5.0, .unit = "deg"});
}

template <class Fields>
void list_fields(Fields& fields, render::Fog& fog) {
    fields.real({"density", "At height base; 0: none. 0.0015 leaves 1/e at 670 m."}, fog.density,
                {.least = 0.0, .most = 1.0, .unit = "1/m"});
    fields.real({"fall", "It thins as exp(-fall * height)."}, fog.fall, {.least = 0.0, .most = 1.0, .unit = "1/m"});
    fields.number({"base", "Height."}, fog.base, k_place_rule);
}

template <class Fields>
void list_fields(Fields& fields, render::Clouds& clouds) {
    fields.real({"cover", "Share of the sky; 0: none."}, clouds.cover, k_share_rule);
    fields.number({"height", "Of the sheet, in the world."}, clouds.height, k_place_rule);
    fields.real({"size", "Of the largest lumps."}, clouds.size, {.least = 1.0, .most = 1e5, .unit = "m"});
    fields.real({"depth", "Optical depth of the thickest: 3 leaves a pale disk of the sun."}, clouds.depth,
                {.least = 0.0, .most = 100.0});
    fields.pair({"drift", "Along x and z: the wind up there."}, clouds.drift, {.least = -200.0, .most = 200.0, .unit = "m/s"},
                "x, z");
}

/// But for the file and the hills.
template <class Fields>
void list_fields(Fields& fields, Ground& ground) {
    fields.number({"low", "Height that black stands for."}, ground.low, {.least = -1e5, .most = 1e5, .unit = "m"});
    fields.number({"high", "Height that white stands for, above low."}, ground.high, {.least = -1e5, .most = 1e5, .unit = "m"});
    fields.place({"corner", "Place of the first sample; its y is added to all heights."}, ground.corner, k_place_rule);
    fields.pair({"extent", "Along x and z. Without heights: in a ratio of whole numbers."}, ground.extent,
                {.least = 0.01, .most = 1e5, .unit = "m"}, "x, z");
}

template <class Fields>
void list_fields(Fields& fields, Hills& hills) {
    fields.number({"height", "From the lowest possible place to the highest; 0: level."}, hills.height,
                  {.least = 0.0, .most = 1e4, .unit = "m"});
    fields.number({"length", "About half of what lies between two tops."}, hills.length,
                  {.least = 1.0, .most = 1e5, .unit = "m"});
    fields.whole({"seed", "Another number, other hills, of 64 kinds."}, hills.seed, {.least = 0.0, .most = 4294967295.0});
}

/// What the wind meets: windrow::Drag, whose length a layer names itself.
template <class Fields>
void list_fields(Fields& fields, windrow::Drag& stalk) {
    fields.real({"width", "What the wind meets across the stalk, leaves included."}, stalk.width,
                {.least = 1e-6, .most = 100.0, .unit = "m"});
    fields.real({"rigidity", "E I."}, stalk.rigidity, {.least = 1e-12, .most = 1e12, .unit = "N m2"});
    fields.real({"drag_coefficient", "A flat plate has 1.95, a round stem 1.1, a crown 0.3; 0: no wind bends it."},
                stalk.drag_coefficient, {.least = 0.0, .most = 10.0});
    fields.real({"air_density", "[kg/m3]"}, stalk.air_density, {.least = 0.0, .most = 2000.0, .unit = "kg/m3"});
    fields.real({"vogel_exponent", "What the drag loses by closing up of leaves, as speed to this power beyond vogel_speed."},
                stalk.vogel_exponent, {.least = -2.0, .most = 0.0});
    fields.real({"vogel_speed", "Where leaves begin to fold."}, stalk.vogel_speed, {.least = 1e-3, .most = 1e3, .unit = "m/s"});
    fields.real({"most_bend", "That the tip never exceeds."}, stalk.most_bend, {.least = 0.0, .most = 2.5, .unit = "rad"});
}

template <class Fields>
void list_fields(Fields& fields, windrow::BladeSettings& blade) {
    fields.real({"length", "Of a blade. Default: the class's; grass has 0.3."}, blade.stalk.length,
                {.least = 1e-4, .most = 200.0, .unit = "m"});
    fields.real({"length_spread", "Share by which lengths vary."}, blade.length_spread, {.least = 0.0, .most = 0.9});
    fields.real({"width", "Of the drawn strip at its root."}, blade.width, {.least = 0.0, .most = 10.0, .unit = "m"});
    fields.real({"tip_width", "The tip's width over the root's."}, blade.tip_width, k_share_rule);
    fields.real({"taper", "How the width falls: width (1 - (1 - tip_width) h^taper)."}, blade.taper,
                {.least = 0.0, .most = 10.0, .above_least = true});
    fields.real({"along_wind", "Share of the load that bends the blade along the wind; the rest about its own wide axis only."},
                blade.along_wind, k_share_rule);
    fields.real({"stiffness_spread", "Share by which stiffness varies."}, blade.stiffness_spread, {.least = 0.0, .most = 0.9});
    fields.real({"own_bend", "Bend of the tip at rest, toward the face."}, blade.own_bend,
                {.least = -3.0, .most = 3.0, .unit = "rad"});
    fields.real({"own_bend_spread", "[rad]"}, blade.own_bend_spread, {.least = 0.0, .most = 3.0, .unit = "rad"});
    fields.real({"own_curve", "Where it bends by itself: 0 an even arc, 1 all at the tip."}, blade.own_curve, k_share_rule);
    fields.real({"view_bend", "Added to the own bend when seen from straight above."}, blade.view_bend,
                {.least = 0.0, .most = 3.0, .unit = "rad"});
}

/// But for the blade.
template <class Fields>
void list_fields(Fields& fields, grass::GrassSettings& grass) {
    constexpr Range k_reach_rule{.least = 1e-3, .most = 1e4, .unit = "m"};
    fields.real({"density", "Blade places along a metre of each axis."}, grass.density,
                {.least = 0.1, .most = 64.0, .unit = "1/m"});
    fields.real({"jitter", "Share of its cell over which a blade's place is drawn by chance; 0: a grid."}, grass.jitter,
                k_share_rule);
    fields.whole({"seed", "Another number, another field of the same kind."}, grass.seed, {.least = 0.0, .most = 4294967295.0});
    fields.integer({"chunk_cells", "Blade places along a chunk's side."}, grass.chunk_cells, {.least = 8.0, .most = 256.0});
    fields.real({"split_distance", "Where 15 vertices become 7; below cut_distance."}, grass.split_distance, k_reach_rule);
    fields.real({"cut_distance", "Where no blade is drawn."}, grass.cut_distance, k_reach_rule);
    fields.real({"morph_from", "Share of split_distance at which near blades begin to morph into far ones."}, grass.morph_from,
                {.least = 0.0, .most = 0.99});
    fields.real({"fade_from", "Share of cut_distance at which blades begin to shrink into the ground."}, grass.fade_from,
                {.least = 0.0, .most = 0.99});
    fields.real({"shadow_distance", "As far as blades cast shadows; 0: none do."}, grass.shadow_distance,
                {.least = 0.0, .most = 1e4, .unit = "m"});
    fields.real({"least_width", "Least width at which a blade is drawn: a pixel."}, grass.least_width,
                {.least = 0.0, .most = 0.01, .unit = "rad"});
    fields.real({"thin_from", "From here on fewer blades are drawn, each wider for it."}, grass.thin_from,
                {.least = 0.1, .most = 1e4, .unit = "m"});
    fields.real({"thin_power", "Their share falls as (thin_from / distance)^thin_power; 0: all are drawn."}, grass.thin_power,
                {.least = 0.0, .most = 3.0});
    fields.real({"thin_widen", "By how much of what is lost the others are wider; 1: what they cover from above stays."},
                grass.thin_widen, k_share_rule);
    fields.real({"clump_size", "Mean distance between the middles of clumps."}, grass.clump_size,
                {.least = 0.01, .most = 100.0, .unit = "m"});
    fields.real({"clump_height", "Share by which clumps may be lower than the class."}, grass.clump_height,
                {.least = 0.0, .most = 0.9});
    fields.real({"clump_lean", "How much of where a blade faces is its clump's: 0 its own, 1 all as one."}, grass.clump_lean,
                k_share_rule);
    fields.real({"clump_fan", "How much blades face outward from their clump's middle."}, grass.clump_fan, k_share_rule);
    fields.real({"patch_size", "Size of patches that grow lower."}, grass.patch_size,
                {.least = 0.1, .most = 1000.0, .unit = "m"});
    fields.real({"patch_height", "Share by which the lowest patches are lower."}, grass.patch_height,
                {.least = 0.0, .most = 0.9});
    fields.integer({"most_chunks", "Chunks that have memory at once."}, grass.most_chunks, {.least = 1.0, .most = 32767.0});
}

template <class Fields>
void list_fields(Fields& fields, render::PlantLook& look) {
    fields.colour({"root", "Where it leaves the ground."}, look.root);
    fields.colour({"tip", "Of a fresh one."}, look.tip);
    fields.colour({"dry", "The driest tips."}, look.dry);
    fields.colour({"through", "Light that shines through it."}, look.through);
    fields.real({"variation", "Share by which single plants are lighter or darker."}, look.variation,
                {.least = 0.0, .most = 0.9});
    fields.real({"root_light", "What the neighbours leave of the sky's light at the root."}, look.root_light, k_share_rule);
    fields.real({"gloss", "Exponent of the shine."}, look.gloss, {.least = 1.0, .most = 1000.0});
    fields.real({"against_light", "How much more shines through against the light."}, look.against_light,
                {.least = 0.0, .most = 20.0});
    fields.colour({"second", "Fresh tips of other clumps: each clump lies between tip and this."}, look.second);
    fields.real({"dryness", "How much dry patches and single dry blades show."}, look.dryness, k_share_rule);
    fields.real({"fold", "By which both halves of a blade stand out of its plane."}, look.fold,
                {.least = 0.0, .most = 1.2, .unit = "rad"});
    fields.real({"midrib", "Share by which the crease is lighter."}, look.midrib, k_share_rule);
    fields.real({"soften", "Share of the ground's normal in a near blade's: 0 shows each blade, 1 an even meadow."}, look.soften,
                k_share_rule);
    fields.real({"self_shade", "Optical depth of the neighbours along the sun's beam, from tip to root."}, look.self_shade,
                {.least = 0.0, .most = 5.0});
    fields.colour({"head", "Of seed heads and flowers."}, look.head);
    fields.real({"head_from", "Share of the length at which they begin; 1: none."}, look.head_from, {.least = 0.3, .most = 1.0});
    fields.real({"head_width", "Their width."}, look.head_width, {.least = 0.0, .most = 0.5, .unit = "m"});
    fields.colour({"soil", "Of the ground between the roots and where the first layer does not grow."}, look.soil);
    fields.real({"even_from", "Where normals have become the ground's and ground the plants' colour."}, look.even_from,
                {.least = 1e-3, .most = 1e6, .unit = "m"});
}

/// What the renderer asks beside the field.
template <class Fields>
void list_fields(Fields& fields, GrassLayer& layer) {
    fields.integer(
        {"most_blades", "Visible blades that are looked at once a frame, 96 bytes each; more take the bend of others."},
        layer.most_blades, {.least = 1024.0, .most = 4194304.0});
    fields.integer({"shadows", "How many of the two shadow maps it is drawn into."}, layer.shadows, {.least = 0.0, .most = 2.0});
}

/// In the mask's own keys; the seed is the layer's.
template <class Fields>
void list_fields(Fields& fields, grass::BarePatches& patches) {
    fields.real({"bare", "Share of the ground, about, on which it does not grow, in patches by the seed of the layer."},
                patches.share, {.least = 0.0, .most = 0.95});
    fields.real({"bare_size", "Size of those patches."}, patches.size, {.least = 0.2, .most = 1000.0, .unit = "m"});
}

template <class Fields>
void list_fields(Fields& fields, grass::FootPath& path) {
    fields.real({"width", "That is bare; 0: no path."}, path.width, {.least = 0.0, .most = 20.0, .unit = "m"});
    fields.real({"at", "Where along x it winds, from the ground's corner."}, path.at, {.least = -1e5, .most = 1e5, .unit = "m"});
}

template <class Fields>
void list_fields(Fields& fields, grass::Brush& brush) {
    fields.pair({"centre", "From the ground's corner, along x and z; may lie outside."}, brush.centre,
                {.least = -1e6, .most = 1e6, .unit = "m"}, "x, z");
    fields.real({"radius", "[m]"}, brush.radius, {.least = 0.001, .most = 1e5, .unit = "m"});
    fields.real({"strength", "What the stroke adds or takes at its middle; falls to 0 at the radius."}, brush.strength,
                k_share_rule);
    fields.real({"hardness", "Share of the radius that has the whole strength."}, brush.hardness, k_share_rule);
}

template <class Fields>
void list_fields(Fields& fields, StandPlace& place) {
    fields.pair({"at", "x and z; it stands on the ground there."}, place.at, {.least = -1e9, .most = 1e9, .unit = "m"}, "x, z");
    fields.real({"size", "Factor on all its lengths."}, place.size, {.least = 0.05, .most = 10.0});
    fields.real({"yaw_deg", "Turn about the vertical."}, place.yaw_deg, {.least = -360.0, .most = 360.0, .unit = "deg"});
}

template <class Fields>
void list_fields(Fields& fields, trees::ClearCircle& circle) {
    fields.pair({"centre", "x and z."}, circle.centre, {.least = -1e9, .most = 1e9, .unit = "m"}, "x, z");
    fields.number({"radius", "[m]"}, circle.radius, {.least = 0.0, .most = 1e6, .unit = "m"});
}

/// But for the circles that stay clear.
template <class Fields>
void list_fields(Fields& fields, trees::TreeScatter& scatter) {
    fields.integer({"count", "How many, at most: fewer where the region has no room."}, scatter.count,
                   {.least = 0.0, .most = 100'000.0});
    fields.pair({"low", "Corner of the region, x and z."}, scatter.low, {.least = -1e9, .most = 1e9, .unit = "m"}, "x, z");
    fields.pair({"high", "The other corner, beyond low."}, scatter.high, {.least = -1e9, .most = 1e9, .unit = "m"}, "x, z");
    fields.number({"apart", "Least distance between two trunks."}, scatter.apart, {.least = 0.0, .most = 1000.0, .unit = "m"});
    fields.real({"groves", "0: evenly; 1: in groves alone."}, scatter.groves, k_share_rule);
    fields.number({"grove_length", "Size of a grove."}, scatter.grove_length, {.least = 1.0, .most = 1e5, .unit = "m"});
    fields.real({"size_spread", "Sizes are 1 - spread to 1 + spread."}, scatter.size_spread, {.least = 0.0, .most = 0.9});
    fields.whole({"seed", "Another number, other places."}, scatter.seed, {.least = 0.0, .most = 4294967295.0});
}

/// But for the kind, the springs and where they stand.
template <class Fields>
void list_fields(Fields& fields, TreeStand& stand) {
    fields.whole({"seed", "Another number, other trees of the kind."}, stand.seed, {.least = 0.0, .most = 4294967295.0});
    fields.integer({"variants", "Different trees of the kind; places take them in turn."}, stand.variants,
                   {.least = 1.0, .most = 8.0});
}

template <class Fields>
void list_fields(Fields& fields, Fan& fan) {
    fields.place({"position", "Of the hub; its foot stands on the ground below."}, fan.position, k_place_rule);
    fields.place({"direction", "Where it blows; needs a level part."}, fan.direction, k_place_rule);
    fields.number({"radius", "[m]"}, fan.radius, {.least = 0.05, .most = 50.0, .unit = "m"});
    fields.number({"turns_hz", "Turns a second."}, fan.turns_hz, {.least = 0.0, .most = 100.0, .unit = "Hz"});
}

/// But for the path, the figure and the jumps.
template <class Fields>
void list_fields(Fields& fields, Walker& walker) {
    fields.real({"radius", "How far it reaches."}, walker.radius,
                {.least = 0.0, .most = 100.0, .unit = "m", .above_least = true});
    fields.real({"weight", "0: presses nothing; 1: all of ground_memory.push."}, walker.weight, k_share_rule);
}

template <class Fields>
void list_fields(Fields& fields, windrow::SpringClass& spring) {
    fields.number({"frequency_hz", "Natural frequency."}, spring.frequency_hz, {.least = 1e-4, .most = 1000.0, .unit = "Hz"});
    fields.number({"damping", "Ratio; 1 returns as fast as it can without a swing."}, spring.damping,
                  {.least = 0.0, .most = 1000.0});
}

/// But for the spring.
template <class Fields>
void list_fields(Fields& fields, windrow::GroundConfig& ground) {
    constexpr Range k_time_rule{.least = 0.01, .most = 1e6, .unit = "s"};
    fields.integer({"texels", "Along each side of its square window."}, ground.texels, {.least = 8.0, .most = 512.0});
    fields.real({"texel_size", "[m]"}, ground.texel_size, {.least = 0.01, .most = 100.0, .unit = "m"});
    fields.real({"push", "Lean to which a walker pushes what is right beside it."}, ground.push,
                {.least = 0.0, .most = 2.5, .unit = "rad"});
    fields.real({"trail_share", "Share of that lean that stays as a trail."}, ground.trail_share, k_share_rule);
    fields.real({"trail_time", "In which a trail falls to 1/e."}, ground.trail_time, k_time_rule);
    fields.real({"trample_time", "In which the press itself falls to 1/e."}, ground.trample_time, k_time_rule);
    fields.real({"clearance", "Height of the feet at which they touch no plant more."}, ground.clearance,
                {.least = 0.001, .most = 100.0, .unit = "m"});
    fields.real({"rim", "Over which the memory fades out at the window's edge; at most a quarter of the window."}, ground.rim,
                {.least = 0.001, .most = 12800.0, .unit = "m"});
    fields.real({"longest_stride", "Who comes farther in one step was teleported and sweeps nothing."}, ground.longest_stride,
                {.least = 0.01, .most = 1e4, .unit = "m"});
    fields.integer({"most_walkers", "Of a step that touch the window."}, ground.most_walkers, {.least = 1.0, .most = 256.0});
}

template <class Fields>
void list_fields(Fields& fields, windrow::Sampling& sampling) {
    fields.real({"strength", "Factor on the wind; 0 stills everything."}, sampling.strength, {.least = 0.0, .most = 1000.0});
    fields.real({"limit", "Never exceeded, after the strength."}, sampling.limit, {.least = 0.0, .most = 1e6, .unit = "m/s"});
    fields.real({"detail", "Small-scale detail as a share of the local speed. Needs gusts."}, sampling.detail, k_share_rule);
    fields.real({"detail_length", "From one ripple to the next."}, sampling.detail_length,
                {.least = 1e-3, .most = 1e6, .unit = "m"});
}

} // namespace windrow::vegetation::program
