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
    fields.integer({"shells", "How many layers. Default: those of the material's fur line, else 32."}, layers.shells,
                   {.least = 2.0, .most = 4096.0});
    fields.real({"length", "Of the longest strands. Default: that of the material's fur line, else 0.03."}, layers.length,
                {.least = 1e-6, .most = 100.0, .unit = "m"});
}

/// The rest of them, but for the strand, which is a Drag.
template <class Fields>
void list_fields(Fields& fields, windrow::ShellSettings& layers) {
    fields.flag({"reaches_tip", "Whether the outermost lies at the tip, i / (N - 1), or short of it, i / N."},
                layers.reaches_tip);
    fields.real({"spacing", "Heights are (i / d)^spacing: above 1 layers gather at the skin."}, layers.spacing,
                {.least = 0.0, .most = 10.0, .above_least = true});
    fields.real({"bias", "Share of the length by which all layers are lifted."}, layers.bias, k_share_rule);
    fields.real({"push", "Of the tip for a direction of length 1; where translated."}, layers.push,
                {.least = -100.0, .most = 100.0, .unit = "m"});
    fields.real({"push_exponent", "The push grows as height^this."}, layers.push_exponent,
                {.least = 0.0, .most = 10.0, .above_least = true});
    fields.real({"droop", "Of the tip, where translated."}, layers.droop, {.least = 0.0, .most = 100.0, .unit = "m"});
    fields.real({"droop_shape", "p of the droop (p^h - 1) / (p - 1): above 1 it bends late."}, layers.droop_shape,
                {.least = 1e-3, .most = 1e3});
    fields.real({"sag", "Of the tip of a level strand, where not translated."}, layers.sag,
                {.least = 0.0, .most = 1.5707964, .unit = "rad"});
    fields.direction({"down", "Where things fall to: any length but 0."}, layers.down);
}

/// Of the strands, what a fur line may give.
template <class Fields>
void list_furs_fields(Fields& fields, fur::StrandFieldSettings& strands) {
    fields.real({"density", "Cells across a metre of the mesh's own space, or across a unit of uv. Default: that of the "
                            "material's fur line, else 100."},
                strands.density, {.least = 0.01, .most = 1e5});
    fields.real(
        {"thickness",
         "T of the cone: radius of a whole strand's root in half cells. Default: that of the material's fur line, else 1."},
        strands.thickness, {.least = 0.0, .most = 10.0});
}

/// The rest of them.
template <class Fields>
void list_fields(Fields& fields, fur::StrandFieldSettings& strands) {
    using fur::StrandProfile;
    using fur::StrandShape;
    fields.real({"stretch", "A cell's length along v over its width; on uv."}, strands.stretch, {.least = 0.05, .most = 20.0});
    fields.real({"row_shift", "Share of a cell by which every other row is shifted; on uv."}, strands.row_shift,
                {.least = 0.0, .most = 0.5});
    fields.integer({"seed", "Another number, another pattern."}, strands.seed, {.least = 0.0, .most = 1e6});
    fields.real({"jitter", "How far strands stand from the middles of their cells: 0 is a grid."}, strands.jitter, k_share_rule);
    fields.real({"wriggle", "How much of the jitter wanders in time; on uv."}, strands.wriggle, k_share_rule);
    fields.real({"phase", "Of the wriggle at time 0."}, strands.phase, {.least = -1e4, .most = 1e4});
    fields.real({"low", "Shortest strands, as a share of the length."}, strands.low, k_share_rule);
    fields.real({"high", "Longest strands, as a share of the length."}, strands.high, k_share_rule);
    fields.word({"profile", "How a strand narrows: cone; centre: from cut_min to cut_max; edge: spikes that touch, from the "
                            "edges of Voronoi's cells."},
                strands.profile,
                {{"cone", StrandProfile::cone}, {"centre", StrandProfile::centre}, {"edge", StrandProfile::edge}});
    fields.real({"cut_min", "Of centre and edge, at the root."}, strands.cut_min, k_share_rule);
    fields.real({"cut_max", "Of centre and edge, at the tip."}, strands.cut_max, k_share_rule);
    fields.real({"cut_exponent", "Of centre and edge."}, strands.cut_exponent, {.least = 1e-3, .most = 10.0});
    fields.word({"shape", "Section of a strand: round, oval (a feather), strip (paper); the last two on uv."}, strands.shape,
                {{"round", StrandShape::round}, {"oval", StrandShape::oval}, {"strip", StrandShape::strip}});
    fields.real({"half_length", "Half length of ovals and strips along v."}, strands.half_length,
                {.least = 0.05, .most = 1.0, .unit = "cells"});
    fields.real({"lift", "How far a feather lies down: 0 stands, 1 rises from the skin at its root."}, strands.lift,
                k_share_rule);
    fields.real({"shaft", "Half width of the line along a feather's middle."}, strands.shaft,
                {.least = 0.0, .most = 0.5, .unit = "cells"});
    fields.real({"bow", "How far tips stand off their roots by a bow of their own."}, strands.bow,
                {.least = 0.0, .most = 0.5, .unit = "cells"});
    fields.real({"bow_turns", "Turns that a bow winds from root to tip."}, strands.bow_turns, {.least = -8.0, .most = 8.0});
    fields.real({"tuft", "How close tips gather in tufts."}, strands.tuft, {.least = 0.0, .most = 0.9});
    fields.real({"tuft_size", "Mean width of a tuft."}, strands.tuft_size, {.least = 1.0, .most = 1000.0, .unit = "cells"});
}

template <class Fields>
void list_fields(Fields& fields, fur::Comb& comb) {
    fields.direction({"along", "Where tips point to, in the mesh's space: any length but 0."}, comb.along);
    fields.real({"bend", "Of the tip."}, comb.bend, {.least = 0.0, .most = 1.5, .unit = "rad"});
    fields.real({"tousle", "By which the comb turns by chance within the skin."}, comb.tousle,
                {.least = 0.0, .most = 3.0, .unit = "rad"});
    fields.real({"tousle_size", "Over which that chance changes."}, comb.tousle_size,
                {.least = 0.0, .most = 100.0, .unit = "m", .above_least = true});
}

template <class Fields>
void list_fields(Fields& fields, fur::Spot& spot) {
    constexpr Range k_spot_rule{.least = -1e4, .most = 1e4, .unit = "m"};
    fields.position({"from", "One end of its middle line."}, spot.from, k_spot_rule);
    fields.position({"to", "The other."}, spot.to, k_spot_rule);
    fields.real({"radius", "[m]"}, spot.radius, {.least = 0.0, .most = 1000.0, .unit = "m", .above_least = true});
    fields.real({"soft", "Over which it fades outward."}, spot.soft, {.least = 0.0, .most = 1000.0, .unit = "m"});
    fields.real({"length", "Factor on the strands' length; 0 is bald."}, spot.length, k_share_rule);
    fields.colour({"colour", "Linear."}, spot.colour);
    fields.real({"tint", "Share of the colour in the strands'."}, spot.tint, k_share_rule);
    fields.real({"glow", "Light of its own where bald, times the colour: eyes."}, spot.glow, {.least = 0.0, .most = 100.0});
}

/// But for the files.
template <class Fields>
void list_fields(Fields& fields, fur::CoatMaps& maps) {
    using fur::Projection;
    fields.real({"influence_a", "Of noise_a."}, maps.influence_a, k_share_rule);
    fields.real({"influence_b", "Of noise_b."}, maps.influence_b, k_share_rule);
    fields.real({"noise_tiles", "Times that both repeat over uv."}, maps.noise_tiles,
                {.least = 0.0, .most = 1000.0, .above_least = true});
    fields.word(
        {"projection",
         "How length and colour lie on the mesh: by uv, or seen from the side (along x), the top or the front (along z)."},
        maps.projection,
        {{"uv", Projection::uv}, {"side", Projection::side}, {"top", Projection::top}, {"front", Projection::front}});
    fields.real({"bald_below", "Share of the length below which the skin is drawn."}, maps.bald_below, k_share_rule);
}

template <class Fields>
void list_fields(Fields& fields, fur::CoatLook& look) {
    constexpr Range k_power_rule{.least = 1.0, .most = 1000.0};
    fields.colour({"root", "At the skin."}, look.root);
    fields.colour({"tip", "At the tip."}, look.tip);
    fields.colour({"second", "Tips of other patches: each patch is somewhere between tip and this."}, look.second);
    fields.colour({"skin", "Where nothing grows."}, look.skin);
    fields.real({"second_size", "Of those patches."}, look.second_size,
                {.least = 0.0, .most = 1e4, .unit = "m", .above_least = true});
    fields.real({"tip_power", "Root to tip by height^this."}, look.tip_power, {.least = 0.0, .most = 10.0, .above_least = true});
    fields.real({"variation", "Share by which single strands are lighter or darker."}, look.variation,
                {.least = 0.0, .most = 0.9});
    fields.real({"occlusion", "A of min(1, h^A + bias): how far up the dark root reaches."}, look.occlusion,
                {.least = 0.0, .most = 5.0});
    fields.real({"occlusion_bias", "Light that reaches the root."}, look.occlusion_bias, k_share_rule);
    fields.real({"wrap", "1 half-Lambert, 0 Lambert."}, look.wrap, k_share_rule);
    fields.real({"gloss", "Amount of Blinn-Phong."}, look.gloss, {.least = 0.0, .most = 10.0});
    fields.real({"gloss_power", "Its exponent."}, look.gloss_power, k_power_rule);
    fields.real({"sheen", "Hair's light along its strands (Kajiya and Kay)."}, look.sheen, {.least = 0.0, .most = 10.0});
    fields.real({"sheen_power", "Its exponent."}, look.sheen_power, k_power_rule);
    fields.real({"through", "Light that shines through tips against the sun."}, look.through, k_share_rule);
    fields.real({"strand_normals", "How much of each strand's own roundness is seen."}, look.strand_normals, k_share_rule);
    fields.flag({"exact_normals",
                 "Normals of the strands' own form, in place of a turn from its side at the root to the skin's at the tip."},
                look.exact_normals);
    fields.real({"square_normals", "0 away from the strand's middle, 1 away from its cell's edge."}, look.square_normals,
                k_share_rule);
    fields.integer({"cel_steps", "Levels of light; 0 is smooth."}, look.cel_steps, {.least = 0.0, .most = 8.0});
}

template <class Fields>
void list_fields(Fields& fields, fur::CoatLevels& levels) {
    fields.integer({"least_shells", "Afar."}, levels.least_shells, {.least = 2.0, .most = 4096.0});
    fields.real({"full_until", "Distance up to which all shells are drawn; beyond, as 1 / distance."}, levels.full_until,
                {.least = 0.0, .most = 1e6, .unit = "m", .above_least = true});
    fields.integer({"march", "Steps a fragment may look between its layer and the next inner one."}, levels.march,
                   {.least = 0.0, .most = 16.0});
    fields.flag({"skip_empty", "Layers above every tip are not drawn."}, levels.skip_empty);
    fields.flag({"outer_first", "Outer layers first hide what lies below."}, levels.outer_first);
    fields.flag({"depth_first", "A pass that writes depth alone before the colours."}, levels.depth_first);
    fields.flag({"one_draw_each", "The naive form, one draw a layer: a baseline."}, levels.one_draw_each);
    fields.flag({"shadow_strands", "Whether the shadow has the strands' form, or the body's."}, levels.shadow_strands);
    fields.integer({"shadow_shells", "Layers in the shadow's map; 0 casts none."}, levels.shadow_shells,
                   {.least = 0.0, .most = 4096.0});
}

template <class Fields>
void list_fields(Fields& fields, windrow::CascadeConfig& inertia) {
    fields.integer({"stages", "How many follow one another."}, inertia.stages, {.least = 1.0, .most = 64.0});
    fields.number({"lag", "Mean delay of the tip."}, inertia.lag, {.least = 0.0, .most = 60.0, .unit = "s", .above_least = true});
}

/// But for what the layers and the mesh's box say already: its height and its half size.
template <class Fields>
void list_fields(Fields& fields, fur::CloudShellSettings& cloud) {
    fields.real({"cover", "Share of the plane that is covered, roughly."}, cloud.cover, k_share_rule);
    fields.real({"size", "Of a heap."}, cloud.size, {.least = 0.01, .most = 1e5, .unit = "m"});
    fields.real({"base", "How far a heap hangs below its plane over how far it stands above; 1 mirrors."}, cloud.base,
                {.least = 0.01, .most = 1.0});
    fields.real({"billow", "How much a finer noise eats of the heaps' form."}, cloud.billow, k_share_rule);
    fields.integer({"octaves", "Of the heaps' noise."}, cloud.octaves, {.least = 1.0, .most = 8.0});
    fields.integer({"seed", "Another number, another sky."}, cloud.seed, {.least = 0.0, .most = 1e6});
    fields.real({"fading", "Over which clouds thin out toward the mesh's rim."}, cloud.fading,
                {.least = 0.01, .most = 1e6, .unit = "m"});
    fields.flag({"round_rim", "Whether the rim is an ellipse, or the rectangle itself."}, cloud.round_rim);
}

/// But for its parts.
template <class Fields>
void list_fields(Fields& fields, fur::CoatSettings& coat) {
    using fur::StrandsOn;
    using fur::WindAt;
    fields.word({"strands_on",
                 "How strands are laid: evenly over any surface (round ones), or by the cells of the mesh's uv (all forms)."},
                coat.strands_on, {{"surface", StrandsOn::surface}, {"uv", StrandsOn::uv}});
    fields.real({"wriggle_hz", "Turns a second of the strands' wriggle."}, coat.wriggle_hz,
                {.least = -100.0, .most = 100.0, .unit = "Hz"});
    fields.flag(
        {"translated",
         "Whether layers are pushed and droop as in the shell literature, in place of strands that bend and keep their length."},
        coat.translated);
    fields.word({"wind_at", "Where a strand feels the wind: once a vertex, at each shell's vertex, or at each pixel's root "
                            "(meshes of a few vertices)."},
                coat.wind_at, {{"strand", WindAt::strand}, {"shell", WindAt::shell}, {"pixel", WindAt::pixel}});
    fields.real({"wind_share", "Of the wind that it feels."}, coat.wind_share, {.least = 0.0, .most = 100.0});
    fields.real({"foot_push", "Lean of the tip away from a walker's foot, beside its middle. Not in the translate form."},
                coat.foot_push, {.least = 0.0, .most = 1.5707964, .unit = "rad"});
    fields.flag({"mirrored", "Layers on both sides of the skin, half of them each: clouds."}, coat.mirrored);
    fields.flag({"drifts", "The pattern moves along with the air: clouds."}, coat.drifts);
    fields.flag({"bare", "The skin alone."}, coat.bare);
}

template <class Fields>
void list_fields(Fields& fields, fur::Lamp& lamp) {
    fields.place({"position", "[m]"}, lamp.position, k_place_rule);
    fields.position({"colour", "Irradiance across the beam at 1 m, in the picture's units."}, lamp.colour,
                    {.least = 0.0, .most = 1e6});
    fields.real({"reach", "Beyond it falls to nothing."}, lamp.reach,
                {.least = 0.0, .most = 1e4, .unit = "m", .above_least = true});
}

} // namespace windrow::vegetation::program
