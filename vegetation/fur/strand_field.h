// A field of strands on a skin: position, length and taper of each strand. The equations and the shader block of one point are in
// vegetation/shaders/numerics/strand_field.glsl; windrow::Shells (coupling/shell.h) places the layers.
//
//     const fur::StrandFieldBlock fur = fur::block({.density = 300.0f, .low = 0.5f});
//     fur::StrandHit hit = fur::strand_at(fur, uv, h);         // hit.inside > 0: a strand
//
// Lengths in the plane count in cells, each of which bears one strand.
#pragma once

#include "../../coupling/drag.h"
#include "strand_numerics.h"

#include <cstdint>

namespace windrow::vegetation::fur {

/// Taper of a strand. With h over the strand's own length as t:
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
    float density = 100.0f;
    float stretch = 1.0f;
    float row_shift = 0.0f;
    int seed = 0;
    float jitter = 1.0f;
    float wriggle = 0.0f;
    float phase = 0.0f;
    float low = 0.4f;
    float high = 1.0f;
    StrandProfile profile = StrandProfile::cone;
    float thickness = 1.0f;
    float cut_min = 0.2f;
    float cut_max = 0.0f;
    float cut_exponent = 1.0f;
    StrandShape shape = StrandShape::round;
    float half_length = 0.7f;
    float lift = 0.0f;
    float shaft = 0.0f;
    float bow = 0.0f;
    float bow_turns = 0.25f;
    float tuft = 0.0f;
    float tuft_size = 6.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("density", &StrandFieldSettings::density, {0.01, 1e5},
                    "Cells across a metre of the mesh's own space, or across a unit of uv. Of a mesh from a file, the default is "
                    "that of the material's fur line. With more than 1e5 cells along u, floats no longer resolve places "
                    "within a cell."),
            Setting("stretch", &StrandFieldSettings::stretch, {0.05, 20.0}, "A cell's length along v over its width; on uv."),
            Setting("row_shift", &StrandFieldSettings::row_shift, {0.0, 0.5},
                    "Fraction of a cell by which every other row is shifted; on uv. 0.5 lays feathers as tiles lie."),
            Setting("seed", &StrandFieldSettings::seed, {0.0, 1e6}, "Another number, another pattern."),
            Setting("jitter", &StrandFieldSettings::jitter, k_fraction_range,
                    "Distance of strands from the centres of their cells: 0 is a grid. Surfaces always have all of it. Costs "
                    "up to 9 hashes a point in place of 1; rows that are shifted take a little off it."),
            Setting("wriggle", &StrandFieldSettings::wriggle, k_fraction_range,
                    "Fraction of the jitter that changes in time; on uv."),
            Setting("phase", &StrandFieldSettings::phase, {-1e4, 1e4}, "Of the wriggle at time 0, in turns."),
            Setting("low", &StrandFieldSettings::low, k_fraction_range, "Shortest strands, as a fraction of the length."),
            Setting("high", &StrandFieldSettings::high, k_fraction_range,
                    "Longest strands, as a fraction of the length. As low: a clipped field."),
            Setting("profile", &StrandFieldSettings::profile,
                    "Taper of a strand: cone; centre: from cut_min to cut_max; edge: spikes that touch, from the edges of "
                    "Voronoi's cells."),
            Setting("thickness", &StrandFieldSettings::thickness, {0.0, 10.0},
                    "T of the cone: radius of a whole strand's root in half cells; above 1 neighbours merge. Of a mesh from a "
                    "file, the default is that of the material's fur line."),
            Setting("cut_min", &StrandFieldSettings::cut_min, k_fraction_range, "Of centre and edge, at the root."),
            Setting("cut_max", &StrandFieldSettings::cut_max, k_fraction_range,
                    "Of centre and edge, at the tip. Below cut_min the centre form narrows to its tip, above it the edge form."),
            Setting("cut_exponent", &StrandFieldSettings::cut_exponent, {1e-3, 10.0},
                    "Of centre and edge. At 1 a centre's section falls evenly; 2 makes a straight cone of one without cut_max."),
            Setting("shape", &StrandFieldSettings::shape,
                    "Section of a strand: round, oval (a feather), strip (paper); the last two on uv."),
            Setting("half_length", &StrandFieldSettings::half_length, {0.05, 1.0, "cells"},
                    "Half length of ovals and strips along v. At 0.7 feathers overlap."),
            Setting(
                "lift", &StrandFieldSettings::lift, k_fraction_range,
                "Slope of a feather: 0 is upright; at 1 it rises from the skin at its root to its whole length at its end, as "
                "scales do."),
            Setting("shaft", &StrandFieldSettings::shaft, {0.0, 0.5, "cells", "none"},
                    "Half width of the line along a feather's middle."),
            Setting("bow", &StrandFieldSettings::bow, {0.0, 0.5, "cells"},
                    "How far tips stand off their roots by a bow of their own. Not in the edge form."),
            Setting("bow_turns", &StrandFieldSettings::bow_turns, {-8.0, 8.0},
                    "Turns that a bow winds from root to tip; 2 makes locks of wool."),
            Setting("tuft", &StrandFieldSettings::tuft, {0.0, 0.9},
                    "Closeness of tips in tufts; wet fur has 0.7. Costs 18 hashes on uv, about twice as many on surfaces."),
            Setting("tuft_size", &StrandFieldSettings::tuft_size, {1.0, 1000.0, "cells"}, "Mean width of a tuft."),
        };
    }
};

/// WindrowStrandField of vegetation/shaders/numerics/strand_field.glsl says what each component is; std140.
using StrandFieldBlock = numerics::WindrowStrandField;
static_assert(sizeof(StrandFieldBlock) == 6 * 16);
using StrandHit = numerics::WindrowStrandHit;

/// Rejects what is out of range, and bows and shapes that reach beyond the cells that are searched; every reason.
[[nodiscard]] windrow::Result<void> validate(const StrandFieldSettings& settings);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const StrandFieldSettings& settings);

/// Shader block of valid settings.
[[nodiscard]] StrandFieldBlock block(const StrandFieldSettings& settings);

/// The strand at uv, on the layer of height h, 0 to 1 of the length there.
[[nodiscard]] StrandHit strand_at(const StrandFieldBlock& field, glm::vec2 uv, float h);
/// The strand on a skin through x [m] of the rest space, whose unit normal is n.
[[nodiscard]] StrandHit strand_on(const StrandFieldBlock& field, glm::vec3 x, glm::vec3 n, float h);

/// The largest h, 0 to 1, at which anything is drawn: layers above it need not be.
[[nodiscard]] float strand_top(const StrandFieldSettings& settings);
[[nodiscard]] bool layer_empty(const StrandFieldSettings& settings, float h);

} // namespace windrow::vegetation::fur

template <>
inline constexpr std::array<const char*, 3> windrow::k_words<windrow::vegetation::fur::StrandProfile>{"cone", "centre", "edge"};
template <>
inline constexpr std::array<const char*, 3> windrow::k_words<windrow::vegetation::fur::StrandShape>{"round", "oval", "strip"};
