// Settings of a field of grass, without its ground and its mask.
#pragma once

#include "../../coupling/blade.h"
#include "../../fluid/result.h"

#include <cstdint>

namespace windrow::vegetation::grass {

/// Culling of a frame before it is drawn.
enum class Culling {
    none,   ///< only the distance cut: every chunk and blade within it is drawn
    chunks, ///< chunks out of view, by the quadtree
    blades  ///< and of the others each blade out of view, on the GPU
};

struct GrassSettings {
    windrow::BladeSettings blade{.view_bend = 0.5f};
    float density = 6.0f;
    float jitter = 1.0f;
    std::uint32_t seed = 0;
    int chunk_cells = 96;
    float split_distance = 25.0f;
    float cut_distance = 90.0f;
    float morph_from = 0.6f;
    float fade_from = 0.75f;
    float shadow_distance = 40.0f;
    float min_width = 0.0007f;
    float thin_from = 10.0f;
    float thin_power = 0.0f;
    float thin_widen = 1.0f;
    float clump_size = 0.35f;
    float clump_height = 0.0f;
    float clump_lean = 0.0f;
    float clump_fan = 0.0f;
    float patch_size = 6.0f;
    float patch_height = 0.0f;
    int max_chunks = 160;
    int far_vertices = 7;
    Culling culling = Culling::blades;

    static constexpr auto settings() {
        return std::tuple{
            Setting("", &GrassSettings::blade, "The class of blades. Its view bend covers the ground when seen from above."),
            Setting("density", &GrassSettings::density, {0.1, 64.0, "1/m"},
                    "Blade places along a metre of each axis: 6 are 36 a square metre."),
            Setting("jitter", &GrassSettings::jitter, k_fraction_range,
                    "Fraction of its cell over which the place of a blade is random, along each axis. 0 is the grid; 1 shows no "
                    "rows."),
            Setting("seed", &GrassSettings::seed, k_seed_range, "Another number, another field of the same kind."),
            Setting("chunk_cells", &GrassSettings::chunk_cells, {8.0, 256.0},
                    "Blade places along a chunk's side: 96 are 16 m at 6 a metre. Larger chunks are fewer draws and coarser "
                    "culling."),
            Setting(
                "split_distance", &GrassSettings::split_distance, {1e-3, 1e4, "m"},
                "Distance of the eye where 15 vertices become far_vertices; below cut_distance. At 25 a blade of 0.3 m has 14 "
                "pixels at 1080p and 50 degrees, and a strip of 5 is off by 1.4 pixels at most, one of 7 by 1."),
            Setting("cut_distance", &GrassSettings::cut_distance, {1e-3, 1e4, "m"},
                    "Distance beyond which no blade is drawn. At 90 a blade has 4 pixels and the ground's colour takes over."),
            Setting("morph_from", &GrassSettings::morph_from, {0.0, 0.99},
                    "Fraction of split_distance at which near blades begin to morph into far ones. Later is sudden."),
            Setting("fade_from", &GrassSettings::fade_from, {0.0, 0.99},
                    "Fraction of cut_distance at which blades begin to shrink into the ground."),
            Setting("shadow_distance", &GrassSettings::shadow_distance, {0.0, 1e4, "m", "none do"},
                    "As far as blades cast shadows; no more than cut_distance counts."),
            Setting("min_width", &GrassSettings::min_width, {0.0, 0.01, "rad"},
                    "Least width at which a blade is drawn. 0.0007 is about a pixel at 1080p; thinner ones flicker."),
            Setting("thin_from", &GrassSettings::thin_from, {0.1, 1e4, "m"},
                    "From here on fewer blades are drawn, each wider for it."),
            Setting("thin_power", &GrassSettings::thin_power, {0.0, 3.0, "", "all are drawn"},
                    "Their number falls as (thin_from / distance)^thin_power. 1.5 halves it with every 1.6 times the distance; "
                    "from 2 on the eye sees few and wide blades."),
            Setting("thin_widen", &GrassSettings::thin_widen, k_fraction_range,
                    "By how much of what is lost the others are wider. 1: what they cover from above stays; 0.6 keeps far ones "
                    "slender for a low eye."),
            Setting("clump_size", &GrassSettings::clump_size, {0.01, 100.0, "m"},
                    "Mean distance between the middles of clumps; 0.35 is a tuft."),
            Setting("clump_height", &GrassSettings::clump_height, {0.0, 0.9},
                    "Fraction by which clumps may be lower than the class."),
            Setting("clump_lean", &GrassSettings::clump_lean, k_fraction_range,
                    "How much of the direction that a blade faces is its clump's: 0 its own, 1 all as one."),
            Setting("clump_fan", &GrassSettings::clump_fan, k_fraction_range,
                    "How much blades face outward from their clump's middle: a tuft that opens."),
            Setting("patch_size", &GrassSettings::patch_size, {0.1, 1000.0, "m"}, "Size of patches that grow lower."),
            Setting("patch_height", &GrassSettings::patch_height, {0.0, 0.9}, "Fraction by which the lowest patches are lower."),
            Setting("max_chunks", &GrassSettings::max_chunks, {1.0, 32767.0},
                    "Chunks that have memory at once. 160 are a view of 90 degrees to 90 m and its shadows; where a view needs "
                    "more, the farthest are left out and counted (GrassReport::left_out)."),
            Setting("far_vertices", &GrassSettings::far_vertices, {5.0, 7.0},
                    "Vertices of a far blade, 7, or 5, which differ in a picture. A layer with heads always has 7: three are the "
                    "head's."),
            Setting("culling", &GrassSettings::culling,
                    "Culling of a frame. All draw the same picture; the others measure what it saves.", k_not_stored),
        };
    }
};

/// Every reason why it cannot be used, a line each.
[[nodiscard]] windrow::Result<void> validate(const GrassSettings& settings);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const GrassSettings& settings);

} // namespace windrow::vegetation::grass

template <>
inline constexpr std::array<const char*, 3> windrow::k_words<windrow::vegetation::grass::Culling>{"none", "chunks", "blades"};
