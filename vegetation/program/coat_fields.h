// Every field of a coat of shells, as picture_fields.h lists those of the picture: key, range, unit. Reader and writer both go
// through these lists. Ranges are those of fur::validate.
//
// Beside what picture_fields.h asks of `Fields`: flag, direction (any vector but 0), position (float metres), word.
#pragma once

#include "vegetation/fur/coat_settings.h"
#include "vegetation/fur/lamps.h"
#include "vegetation/program/picture_fields.h"

namespace windrow::vegetation::program {

/// Of the layers, what a fur line may give.
template <class Fields>
void list_furs_fields(Fields& fields, windrow::ShellSettings& layers) {
    fields.integer("shells", layers.shells, {.least = 2.0, .most = 4096.0});
    fields.real("length", layers.length, {.least = 1e-6, .most = 100.0, .unit = "m"});
}

/// The rest of them, but for the strand, which is a Drag.
template <class Fields>
void list_fields(Fields& fields, windrow::ShellSettings& layers) {
    fields.flag("reaches_tip", layers.reaches_tip);
    fields.real("spacing", layers.spacing, {.least = 0.0, .most = 10.0, .above_least = true});
    fields.real("bias", layers.bias, k_share_rule);
    fields.real("push", layers.push, {.least = -100.0, .most = 100.0, .unit = "m"});
    fields.real("push_exponent", layers.push_exponent, {.least = 0.0, .most = 10.0, .above_least = true});
    fields.real("droop", layers.droop, {.least = 0.0, .most = 100.0, .unit = "m"});
    fields.real("droop_shape", layers.droop_shape, {.least = 1e-3, .most = 1e3});
    fields.real("sag", layers.sag, {.least = 0.0, .most = 1.5707964, .unit = "rad"});
    fields.direction("down", layers.down);
}

/// Of the strands, what a fur line may give.
template <class Fields>
void list_furs_fields(Fields& fields, fur::StrandFieldSettings& strands) {
    fields.real("density", strands.density, {.least = 0.01, .most = 1e5});
    fields.real("thickness", strands.thickness, {.least = 0.0, .most = 10.0});
}

/// The rest of them.
template <class Fields>
void list_fields(Fields& fields, fur::StrandFieldSettings& strands) {
    using fur::StrandProfile;
    using fur::StrandShape;
    fields.real("stretch", strands.stretch, {.least = 0.05, .most = 20.0});
    fields.real("row_shift", strands.row_shift, {.least = 0.0, .most = 0.5});
    fields.integer("seed", strands.seed, {.least = 0.0, .most = 1e6});
    fields.real("jitter", strands.jitter, k_share_rule);
    fields.real("wriggle", strands.wriggle, k_share_rule);
    fields.real("phase", strands.phase, {.least = -1e4, .most = 1e4});
    fields.real("low", strands.low, k_share_rule);
    fields.real("high", strands.high, k_share_rule);
    fields.word("profile", strands.profile,
                {{"cone", StrandProfile::cone}, {"centre", StrandProfile::centre}, {"edge", StrandProfile::edge}});
    fields.real("cut_min", strands.cut_min, k_share_rule);
    fields.real("cut_max", strands.cut_max, k_share_rule);
    fields.real("cut_exponent", strands.cut_exponent, {.least = 1e-3, .most = 10.0});
    fields.word("shape", strands.shape,
                {{"round", StrandShape::round}, {"oval", StrandShape::oval}, {"strip", StrandShape::strip}});
    fields.real("half_length", strands.half_length, {.least = 0.05, .most = 1.0, .unit = "cells"});
    fields.real("lift", strands.lift, k_share_rule);
    fields.real("shaft", strands.shaft, {.least = 0.0, .most = 0.5, .unit = "cells"});
    fields.real("bow", strands.bow, {.least = 0.0, .most = 0.5, .unit = "cells"});
    fields.real("bow_turns", strands.bow_turns, {.least = -8.0, .most = 8.0});
    fields.real("tuft", strands.tuft, {.least = 0.0, .most = 0.9});
    fields.real("tuft_size", strands.tuft_size, {.least = 1.0, .most = 1000.0, .unit = "cells"});
}

template <class Fields>
void list_fields(Fields& fields, fur::Comb& comb) {
    fields.direction("along", comb.along);
    fields.real("bend", comb.bend, {.least = 0.0, .most = 1.5, .unit = "rad"});
    fields.real("tousle", comb.tousle, {.least = 0.0, .most = 3.0, .unit = "rad"});
    fields.real("tousle_size", comb.tousle_size, {.least = 0.0, .most = 100.0, .above_least = true, .unit = "m"});
}

template <class Fields>
void list_fields(Fields& fields, fur::Spot& spot) {
    constexpr NumberRule k_spot_rule{.least = -1e4, .most = 1e4, .unit = "m"};
    fields.position("from", spot.from, k_spot_rule);
    fields.position("to", spot.to, k_spot_rule);
    fields.real("radius", spot.radius, {.least = 0.0, .most = 1000.0, .above_least = true, .unit = "m"});
    fields.real("soft", spot.soft, {.least = 0.0, .most = 1000.0, .unit = "m"});
    fields.real("length", spot.length, k_share_rule);
    fields.colour("colour", spot.colour);
    fields.real("tint", spot.tint, k_share_rule);
    fields.real("glow", spot.glow, {.least = 0.0, .most = 100.0});
}

/// But for the files.
template <class Fields>
void list_fields(Fields& fields, fur::CoatMaps& maps) {
    using fur::Projection;
    fields.real("influence_a", maps.influence_a, k_share_rule);
    fields.real("influence_b", maps.influence_b, k_share_rule);
    fields.real("noise_tiles", maps.noise_tiles, {.least = 0.0, .most = 1000.0, .above_least = true});
    fields.word("projection", maps.projection,
                {{"uv", Projection::uv}, {"side", Projection::side}, {"top", Projection::top}, {"front", Projection::front}});
    fields.real("bald_below", maps.bald_below, k_share_rule);
}

template <class Fields>
void list_fields(Fields& fields, fur::CoatLook& look) {
    constexpr NumberRule k_power_rule{.least = 1.0, .most = 1000.0};
    fields.colour("root", look.root);
    fields.colour("tip", look.tip);
    fields.colour("second", look.second);
    fields.colour("skin", look.skin);
    fields.real("second_size", look.second_size, {.least = 0.0, .most = 1e4, .above_least = true, .unit = "m"});
    fields.real("tip_power", look.tip_power, {.least = 0.0, .most = 10.0, .above_least = true});
    fields.real("variation", look.variation, {.least = 0.0, .most = 0.9});
    fields.real("occlusion", look.occlusion, {.least = 0.0, .most = 5.0});
    fields.real("occlusion_bias", look.occlusion_bias, k_share_rule);
    fields.real("wrap", look.wrap, k_share_rule);
    fields.real("gloss", look.gloss, {.least = 0.0, .most = 10.0});
    fields.real("gloss_power", look.gloss_power, k_power_rule);
    fields.real("sheen", look.sheen, {.least = 0.0, .most = 10.0});
    fields.real("sheen_power", look.sheen_power, k_power_rule);
    fields.real("through", look.through, k_share_rule);
    fields.real("strand_normals", look.strand_normals, k_share_rule);
    fields.flag("exact_normals", look.exact_normals);
    fields.real("square_normals", look.square_normals, k_share_rule);
    fields.integer("cel_steps", look.cel_steps, {.least = 0.0, .most = 8.0});
}

template <class Fields>
void list_fields(Fields& fields, fur::CoatLevels& levels) {
    fields.integer("least_shells", levels.least_shells, {.least = 2.0, .most = 4096.0});
    fields.real("full_until", levels.full_until, {.least = 0.0, .most = 1e6, .above_least = true, .unit = "m"});
    fields.integer("march", levels.march, {.least = 0.0, .most = 16.0});
    fields.flag("skip_empty", levels.skip_empty);
    fields.flag("outer_first", levels.outer_first);
    fields.flag("depth_first", levels.depth_first);
    fields.flag("one_draw_each", levels.one_draw_each);
    fields.flag("shadow_strands", levels.shadow_strands);
    fields.integer("shadow_shells", levels.shadow_shells, {.least = 0.0, .most = 4096.0});
}

template <class Fields>
void list_fields(Fields& fields, windrow::CascadeConfig& inertia) {
    fields.integer("stages", inertia.stages, {.least = 1.0, .most = 64.0});
    fields.number("lag", inertia.lag, {.least = 0.0, .most = 60.0, .above_least = true, .unit = "s"});
}

/// But for what the layers and the mesh's box say already: its height and its half size.
template <class Fields>
void list_fields(Fields& fields, fur::CloudShellSettings& cloud) {
    fields.real("cover", cloud.cover, k_share_rule);
    fields.real("size", cloud.size, {.least = 0.01, .most = 1e5, .unit = "m"});
    fields.real("base", cloud.base, {.least = 0.01, .most = 1.0});
    fields.real("billow", cloud.billow, k_share_rule);
    fields.integer("octaves", cloud.octaves, {.least = 1.0, .most = 8.0});
    fields.integer("seed", cloud.seed, {.least = 0.0, .most = 1e6});
    fields.real("fading", cloud.fading, {.least = 0.01, .most = 1e6, .unit = "m"});
    fields.flag("round_rim", cloud.round_rim);
}

/// But for its parts.
template <class Fields>
void list_fields(Fields& fields, fur::CoatSettings& coat) {
    using fur::StrandsOn;
    using fur::WindAt;
    fields.word("strands_on", coat.strands_on, {{"surface", StrandsOn::surface}, {"uv", StrandsOn::uv}});
    fields.real("wriggle_hz", coat.wriggle_hz, {.least = -100.0, .most = 100.0, .unit = "Hz"});
    fields.flag("translated", coat.translated);
    fields.word("wind_at", coat.wind_at, {{"strand", WindAt::strand}, {"shell", WindAt::shell}, {"pixel", WindAt::pixel}});
    fields.real("wind_share", coat.wind_share, {.least = 0.0, .most = 100.0});
    fields.real("foot_push", coat.foot_push, {.least = 0.0, .most = 1.5707964, .unit = "rad"});
    fields.flag("mirrored", coat.mirrored);
    fields.flag("drifts", coat.drifts);
    fields.flag("bare", coat.bare);
}

template <class Fields>
void list_fields(Fields& fields, fur::Lamp& lamp) {
    fields.place("position", lamp.position, k_place_rule);
    fields.position("colour", lamp.colour, {.least = 0.0, .most = 1e6});
    fields.real("reach", lamp.reach, {.least = 0.0, .most = 1e4, .above_least = true, .unit = "m"});
}

} // namespace windrow::vegetation::program
