// Every field of a picture's structures that is a number, a place or a colour: its key, its range, its unit. The reader and the
// writer both go through these lists, so that neither can forget what the other knows; defaults are the structures' own.
//
// `Fields` has real, number, integer, whole, place, colour, pair: FieldReader and FieldWriter.
#pragma once

#include "scene/air_reader.h"
#include "vegetation/program/picture_scene.h"

namespace windrow::vegetation::program {

using windrow::scene::k_place_rule;
using windrow::scene::NumberRule;

inline constexpr NumberRule k_share_rule{.least = 0.0, .most = 1.0};

/// But for position and target, which may be paths.
template <class Fields>
void list_fields(Fields& fields, render::Camera& camera) {
    fields.real("view_deg", camera.view_deg, {.least = 1.0, .most = 150.0, .unit = "deg"});
    fields.real("near", camera.near, {.least = 1e-3, .most = 1e3, .unit = "m"});
    fields.real("far", camera.far, {.least = 1.01e-3, .most = 1e9, .unit = "m"});
    fields.real("exposure", camera.exposure, {.least = 1e-6, .most = 1e6});
}

template <class Fields>
void list_fields(Fields& fields, render::Sun& sun) {
    fields.real("elevation_deg", sun.elevation_deg, {.least = 1.0, .most = 90.0, .unit = "deg"});
    fields.real("azimuth_deg", sun.azimuth_deg, {.least = -360.0, .most = 360.0, .unit = "deg"});
    fields.real("irradiance", sun.irradiance, {.least = 1e-6, .most = 100.0});
    fields.real("haze", sun.haze, {.least = 0.0, .most = 0.5});
    fields.real("radius_deg", sun.radius_deg, {.least = 0.05, .most = 5.0, .unit = "deg"});
}

template <class Fields>
void list_fields(Fields& fields, render::Fog& fog) {
    fields.real("density", fog.density, {.least = 0.0, .most = 1.0, .unit = "1/m"});
    fields.real("fall", fog.fall, {.least = 0.0, .most = 1.0, .unit = "1/m"});
    fields.number("base", fog.base, k_place_rule);
}

template <class Fields>
void list_fields(Fields& fields, render::Clouds& clouds) {
    fields.real("cover", clouds.cover, k_share_rule);
    fields.number("height", clouds.height, k_place_rule);
    fields.real("size", clouds.size, {.least = 1.0, .most = 1e5, .unit = "m"});
    fields.real("depth", clouds.depth, {.least = 0.0, .most = 100.0});
    fields.pair("drift", clouds.drift, {.least = -200.0, .most = 200.0, .unit = "m/s"}, "x, z");
}

/// But for the file and the hills.
template <class Fields>
void list_fields(Fields& fields, Ground& ground) {
    fields.number("low", ground.low, {.least = -1e5, .most = 1e5, .unit = "m"});
    fields.number("high", ground.high, {.least = -1e5, .most = 1e5, .unit = "m"});
    fields.place("corner", ground.corner, k_place_rule);
    fields.pair("extent", ground.extent, {.least = 0.01, .most = 1e5, .unit = "m"}, "x, z");
}

template <class Fields>
void list_fields(Fields& fields, Hills& hills) {
    fields.number("height", hills.height, {.least = 0.0, .most = 1e4, .unit = "m"});
    fields.number("length", hills.length, {.least = 1.0, .most = 1e5, .unit = "m"});
    fields.whole("seed", hills.seed, {.least = 0.0, .most = 4294967295.0});
}

/// What the wind meets: windrow::Drag, whose length a layer names itself.
template <class Fields>
void list_fields(Fields& fields, windrow::Drag& stalk) {
    fields.real("width", stalk.width, {.least = 1e-6, .most = 100.0, .unit = "m"});
    fields.real("rigidity", stalk.rigidity, {.least = 1e-12, .most = 1e12, .unit = "N m2"});
    fields.real("drag_coefficient", stalk.drag_coefficient, {.least = 0.0, .most = 10.0});
    fields.real("air_density", stalk.air_density, {.least = 0.0, .most = 2000.0, .unit = "kg/m3"});
    fields.real("vogel_exponent", stalk.vogel_exponent, {.least = -2.0, .most = 0.0});
    fields.real("vogel_speed", stalk.vogel_speed, {.least = 1e-3, .most = 1e3, .unit = "m/s"});
    fields.real("most_bend", stalk.most_bend, {.least = 0.0, .most = 2.5, .unit = "rad"});
}

template <class Fields>
void list_fields(Fields& fields, windrow::BladeSettings& blade) {
    fields.real("length", blade.stalk.length, {.least = 1e-4, .most = 200.0, .unit = "m"});
    fields.real("length_spread", blade.length_spread, {.least = 0.0, .most = 0.9});
    fields.real("width", blade.width, {.least = 0.0, .most = 10.0, .unit = "m"});
    fields.real("tip_width", blade.tip_width, k_share_rule);
    fields.real("taper", blade.taper, {.least = 0.0, .most = 10.0, .above_least = true});
    fields.real("along_wind", blade.along_wind, k_share_rule);
    fields.real("stiffness_spread", blade.stiffness_spread, {.least = 0.0, .most = 0.9});
    fields.real("own_bend", blade.own_bend, {.least = -3.0, .most = 3.0, .unit = "rad"});
    fields.real("own_bend_spread", blade.own_bend_spread, {.least = 0.0, .most = 3.0, .unit = "rad"});
    fields.real("own_curve", blade.own_curve, k_share_rule);
    fields.real("view_bend", blade.view_bend, {.least = 0.0, .most = 3.0, .unit = "rad"});
}

/// But for the blade.
template <class Fields>
void list_fields(Fields& fields, grass::GrassSettings& grass) {
    constexpr NumberRule k_reach_rule{.least = 1e-3, .most = 1e4, .unit = "m"};
    fields.real("density", grass.density, {.least = 0.1, .most = 64.0, .unit = "1/m"});
    fields.real("jitter", grass.jitter, k_share_rule);
    fields.whole("seed", grass.seed, {.least = 0.0, .most = 4294967295.0});
    fields.integer("chunk_cells", grass.chunk_cells, {.least = 8.0, .most = 256.0});
    fields.real("split_distance", grass.split_distance, k_reach_rule);
    fields.real("cut_distance", grass.cut_distance, k_reach_rule);
    fields.real("morph_from", grass.morph_from, {.least = 0.0, .most = 0.99});
    fields.real("fade_from", grass.fade_from, {.least = 0.0, .most = 0.99});
    fields.real("shadow_distance", grass.shadow_distance, {.least = 0.0, .most = 1e4, .unit = "m"});
    fields.real("least_width", grass.least_width, {.least = 0.0, .most = 0.01, .unit = "rad"});
    fields.real("thin_from", grass.thin_from, {.least = 0.1, .most = 1e4, .unit = "m"});
    fields.real("thin_power", grass.thin_power, {.least = 0.0, .most = 3.0});
    fields.real("thin_widen", grass.thin_widen, k_share_rule);
    fields.real("clump_size", grass.clump_size, {.least = 0.01, .most = 100.0, .unit = "m"});
    fields.real("clump_height", grass.clump_height, {.least = 0.0, .most = 0.9});
    fields.real("clump_lean", grass.clump_lean, k_share_rule);
    fields.real("clump_fan", grass.clump_fan, k_share_rule);
    fields.real("patch_size", grass.patch_size, {.least = 0.1, .most = 1000.0, .unit = "m"});
    fields.real("patch_height", grass.patch_height, {.least = 0.0, .most = 0.9});
    fields.integer("most_chunks", grass.most_chunks, {.least = 1.0, .most = 32767.0});
}

template <class Fields>
void list_fields(Fields& fields, render::PlantLook& look) {
    fields.colour("root", look.root);
    fields.colour("tip", look.tip);
    fields.colour("dry", look.dry);
    fields.colour("through", look.through);
    fields.real("variation", look.variation, {.least = 0.0, .most = 0.9});
    fields.real("root_light", look.root_light, k_share_rule);
    fields.real("gloss", look.gloss, {.least = 1.0, .most = 1000.0});
    fields.real("against_light", look.against_light, {.least = 0.0, .most = 20.0});
    fields.colour("second", look.second);
    fields.real("dryness", look.dryness, k_share_rule);
    fields.real("fold", look.fold, {.least = 0.0, .most = 1.2, .unit = "rad"});
    fields.real("midrib", look.midrib, k_share_rule);
    fields.real("soften", look.soften, k_share_rule);
    fields.real("self_shade", look.self_shade, {.least = 0.0, .most = 5.0});
    fields.colour("head", look.head);
    fields.real("head_from", look.head_from, {.least = 0.3, .most = 1.0});
    fields.real("head_width", look.head_width, {.least = 0.0, .most = 0.5, .unit = "m"});
    fields.colour("soil", look.soil);
    fields.real("even_from", look.even_from, {.least = 1e-3, .most = 1e6, .unit = "m"});
}

/// What the renderer asks beside the field.
template <class Fields>
void list_fields(Fields& fields, GrassLayer& layer) {
    fields.integer("most_blades", layer.most_blades, {.least = 1024.0, .most = 4194304.0});
    fields.integer("shadows", layer.shadows, {.least = 0.0, .most = 2.0});
}

/// In the mask's own keys; the seed is the layer's.
template <class Fields>
void list_fields(Fields& fields, grass::BarePatches& patches) {
    fields.real("bare", patches.share, {.least = 0.0, .most = 0.95});
    fields.real("bare_size", patches.size, {.least = 0.2, .most = 1000.0, .unit = "m"});
}

template <class Fields>
void list_fields(Fields& fields, grass::FootPath& path) {
    fields.real("width", path.width, {.least = 0.0, .most = 20.0, .unit = "m"});
    fields.real("at", path.at, {.least = -1e5, .most = 1e5, .unit = "m"});
}

template <class Fields>
void list_fields(Fields& fields, grass::Brush& brush) {
    fields.pair("centre", brush.centre, {.least = -1e6, .most = 1e6, .unit = "m"}, "x, z");
    fields.real("radius", brush.radius, {.least = 0.001, .most = 1e5, .unit = "m"});
    fields.real("strength", brush.strength, k_share_rule);
    fields.real("hardness", brush.hardness, k_share_rule);
}

template <class Fields>
void list_fields(Fields& fields, StandPlace& place) {
    fields.pair("at", place.at, {.least = -1e9, .most = 1e9, .unit = "m"}, "x, z");
    fields.real("size", place.size, {.least = 0.05, .most = 10.0});
    fields.real("yaw_deg", place.yaw_deg, {.least = -360.0, .most = 360.0, .unit = "deg"});
}

template <class Fields>
void list_fields(Fields& fields, trees::ClearCircle& circle) {
    fields.pair("centre", circle.centre, {.least = -1e9, .most = 1e9, .unit = "m"}, "x, z");
    fields.number("radius", circle.radius, {.least = 0.0, .most = 1e6, .unit = "m"});
}

/// But for the circles that stay clear.
template <class Fields>
void list_fields(Fields& fields, trees::TreeScatter& scatter) {
    fields.integer("count", scatter.count, {.least = 0.0, .most = 100'000.0});
    fields.pair("low", scatter.low, {.least = -1e9, .most = 1e9, .unit = "m"}, "x, z");
    fields.pair("high", scatter.high, {.least = -1e9, .most = 1e9, .unit = "m"}, "x, z");
    fields.number("apart", scatter.apart, {.least = 0.0, .most = 1000.0, .unit = "m"});
    fields.real("groves", scatter.groves, k_share_rule);
    fields.number("grove_length", scatter.grove_length, {.least = 1.0, .most = 1e5, .unit = "m"});
    fields.real("size_spread", scatter.size_spread, {.least = 0.0, .most = 0.9});
    fields.whole("seed", scatter.seed, {.least = 0.0, .most = 4294967295.0});
}

/// But for the kind, the springs and where they stand.
template <class Fields>
void list_fields(Fields& fields, TreeStand& stand) {
    fields.whole("seed", stand.seed, {.least = 0.0, .most = 4294967295.0});
    fields.integer("variants", stand.variants, {.least = 1.0, .most = 8.0});
}

template <class Fields>
void list_fields(Fields& fields, Fan& fan) {
    fields.place("position", fan.position, k_place_rule);
    fields.place("direction", fan.direction, k_place_rule);
    fields.number("radius", fan.radius, {.least = 0.05, .most = 50.0, .unit = "m"});
    fields.number("turns_hz", fan.turns_hz, {.least = 0.0, .most = 100.0, .unit = "Hz"});
}

/// But for the path, the figure and the jumps.
template <class Fields>
void list_fields(Fields& fields, Walker& walker) {
    fields.real("radius", walker.radius, {.least = 0.0, .most = 100.0, .above_least = true, .unit = "m"});
    fields.real("weight", walker.weight, k_share_rule);
}

template <class Fields>
void list_fields(Fields& fields, windrow::SpringClass& spring) {
    fields.number("frequency_hz", spring.frequency_hz, {.least = 1e-4, .most = 1000.0, .unit = "Hz"});
    fields.number("damping", spring.damping, {.least = 0.0, .most = 1000.0});
}

/// But for the spring.
template <class Fields>
void list_fields(Fields& fields, windrow::GroundConfig& ground) {
    constexpr NumberRule k_time_rule{.least = 0.01, .most = 1e6, .unit = "s"};
    fields.integer("texels", ground.texels, {.least = 8.0, .most = 512.0});
    fields.real("texel_size", ground.texel_size, {.least = 0.01, .most = 100.0, .unit = "m"});
    fields.real("push", ground.push, {.least = 0.0, .most = 2.5, .unit = "rad"});
    fields.real("trail_share", ground.trail_share, k_share_rule);
    fields.real("trail_time", ground.trail_time, k_time_rule);
    fields.real("trample_time", ground.trample_time, k_time_rule);
    fields.real("clearance", ground.clearance, {.least = 0.001, .most = 100.0, .unit = "m"});
    fields.real("rim", ground.rim, {.least = 0.001, .most = 12800.0, .unit = "m"});
    fields.real("longest_stride", ground.longest_stride, {.least = 0.01, .most = 1e4, .unit = "m"});
    fields.integer("most_walkers", ground.most_walkers, {.least = 1.0, .most = 256.0});
}

template <class Fields>
void list_fields(Fields& fields, windrow::Sampling& sampling) {
    fields.real("strength", sampling.strength, {.least = 0.0, .most = 1000.0});
    fields.real("limit", sampling.limit, {.least = 0.0, .most = 1e6, .unit = "m/s"});
    fields.real("detail", sampling.detail, k_share_rule);
    fields.real("detail_length", sampling.detail_length, {.least = 1e-3, .most = 1e6, .unit = "m"});
}

} // namespace windrow::vegetation::program
