// A field of strands on a skin: where they stand, how long each is, how it narrows. The equations, and what a shader is told of
// one point, stand in vegetation/shaders/numerics/strand_field.glsl; where the layers lie is windrow::Shells (coupling/shell.h).
//
//     const fur::StrandFieldBlock fur = fur::block({.density = 300.0f, .low = 0.5f});
//     fur::StrandHit hit = fur::strand_at(fur, uv, h);         // hit.inside > 0: a strand
//
// Lengths in the plane count in cells, each of which bears one strand.
#pragma once

#include "fluid/result.h"
#include "vegetation/fur/strand_numerics.h"

#include <cstdint>

namespace windrow::vegetation::fur {

/// How a strand narrows. With h over the strand's own length as t:
enum class StrandProfile : std::uint8_t {
    cone,   ///< radius thickness / 2 (length - h): the plain one; long strands are thicker than short ones
    centre, ///< radius^2 from cut_min at the root to cut_max at the tip as t^cut_exponent; equal ones make cylinders
    edge,   ///< spikes that touch: distance from Voronoi's edges above cut_min to cut_max as t^cut_exponent
};

/// The section of a strand. Those that are not round lie along v, and need a uv.
enum class StrandShape : std::uint8_t {
    round,
    oval,  ///< pointed at both ends: a feather
    strip, ///< a rectangle: cut paper, a carpet's loops
};

struct StrandFieldSettings {
    /// Cells across a unit of uv, or across a metre of a mesh's rest space; 0.01 to 1e5. Default 100. Where u and density make
    /// more than 1e5 cells, floats no longer tell places within a cell apart.
    float density = 100.0f;
    /// A cell's length along v over its width, 0.05 to 20. Default 1. Not on surfaces.
    float stretch = 1.0f;
    /// By what share of a cell every other row is shifted, 0 to 0.5. Default 0; 0.5 lays feathers as tiles lie. Not on surfaces.
    float row_shift = 0.0f;
    /// Another pattern for each, 0 to 1e6. Default 0.
    int seed = 0;

    /// How far strands stand from the middles of their cells, 0 (a grid) to 1. Default 1. Surfaces always have all of it. Costs
    /// up to 9 hashes a point in place of 1. Rows that are shifted take a little off it: see strand_field.cpp.
    float jitter = 1.0f;
    /// How much of the jitter wanders with `phase`, 0 to 1. Default 0. Not on surfaces.
    float wriggle = 0.0f;
    /// [turns] Of the wriggle, -1e4 to 1e4: seconds times a rate. Default 0.
    float phase = 0.0f;

    /// Lengths are even between these shares of the shell's, 0 to 1. Default 0.4 to 1. Equal ones make a clipped field.
    float low = 0.4f;
    float high = 1.0f;

    StrandProfile profile = StrandProfile::cone;
    /// T of the cone, 0 to 10: the radius of a whole strand's root in half cells. Default 1: the circle that its cell holds.
    /// Above, neighbours merge.
    float thickness = 1.0f;
    /// Of the other profiles, 0 to 1 each. Default 0.2 to 0: the centre form narrows to its tip if min > max, the edge form if
    /// min < max.
    float cut_min = 0.2f;
    float cut_max = 0.0f;
    /// Above 0, at most 10. Default 1: a centre's section falls evenly. 2 makes a straight cone of a centre form without cut_max.
    float cut_exponent = 1.0f;

    StrandShape shape = StrandShape::round;
    /// [cells] Half length of ovals and strips along v, 0.05 to 1. Default 0.7: feathers overlap. Not of round ones.
    float half_length = 0.7f;
    /// How far a feather lies down, 0 to 1: 0 stands, 1 rises from the skin at its root to its whole length at its end, as scales
    /// do. Default 0. Not of round ones.
    float lift = 0.0f;
    /// [cells] Half width of the line along a feather's middle at its root, 0 (none) to 0.5. Default 0.
    float shaft = 0.0f;

    /// [cells] How far tips stand off their roots by strands' own bow, 0 to 0.5. Default 0. Not in the edge form.
    float bow = 0.0f;
    /// Turns that a bow winds from root to tip, -8 to 8. Default 0.25; 2 makes locks of wool.
    float bow_turns = 0.25f;
    /// How close tips gather in tufts, 0 (none) to 0.9. Default 0. Wet fur has 0.7. Costs 18 hashes on uv, about twice as many on
    /// surfaces.
    float tuft = 0.0f;
    /// [cells] Mean width of a tuft, 1 to 1000. Default 6.
    float tuft_size = 6.0f;
};

/// WindrowStrandField of vegetation/shaders/numerics/strand_field.glsl says what each component is; std140.
using StrandFieldBlock = numerics::WindrowStrandField;
static_assert(sizeof(StrandFieldBlock) == 6 * 16);
using StrandHit = numerics::WindrowStrandHit;

/// Refuses what is out of range, and bows and shapes that reach beyond the cells that are searched; every reason.
[[nodiscard]] windrow::Result<void> validate(const StrandFieldSettings& settings);

/// What shaders are told, of settings that `validate` takes.
[[nodiscard]] StrandFieldBlock block(const StrandFieldSettings& settings);

/// The strand at uv, on the layer of height h, 0 to 1 of the length there.
[[nodiscard]] StrandHit strand_at(const StrandFieldBlock& field, glm::vec2 uv, float h);
/// The strand on a skin through x [m] of the rest space, whose unit normal is n.
[[nodiscard]] StrandHit strand_on(const StrandFieldBlock& field, glm::vec3 x, glm::vec3 n, float h);

/// The largest h, 0 to 1, at which anything is drawn: layers above it need not be.
[[nodiscard]] float strand_top(const StrandFieldSettings& settings);
[[nodiscard]] bool layer_empty(const StrandFieldSettings& settings, float h);

} // namespace windrow::vegetation::fur
