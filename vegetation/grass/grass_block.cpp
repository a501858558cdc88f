#include "vegetation/grass/grass_block.h"

#include <algorithm>

namespace windrow::vegetation::grass {
namespace {

windrow::numerics::WindrowBlade shared(const windrow::BladeBlock& block) {
    return {block.size, block.form, block.own, {block.drag.load}};
}

} // namespace

std::uint64_t chunk_bytes(const GrassSettings& settings) {
    const std::uint64_t places =
        static_cast<std::uint64_t>(settings.chunk_cells) * static_cast<std::uint64_t>(settings.chunk_cells);
    constexpr std::uint64_t views = 2, levels = 2, command = 16, chunk_place = 8;
    return places * (sizeof(BladeRecord) + views * sizeof(std::uint32_t)) + views * levels * command + chunk_place;
}

float blade_reach(const GrassSettings& settings) {
    // The bend keeps its length within 0.4 % (shaders/numerics/stem.glsl).
    const float longest = 1.004f * settings.blade.stalk.length * (1.0f + settings.blade.length_spread);
    // Where blades thin out, those that are left are wider.
    const glm::vec4 thin(settings.thin_from, settings.thin_power, settings.thin_widen, 0.0f);
    const float share = windrow::numerics::windrow_grass_fraction(thin, settings.cut_distance);
    const float width = settings.blade.width * windrow::numerics::windrow_grass_wider(thin, share);
    return longest + 0.5f * std::max(width, settings.min_width * settings.cut_distance);
}

Block block_of(const GrassSettings& settings, const HeightMap& heights, const PlacementMask& mask) {
    Block block{};
    block.corner.w = blade_reach(settings);
    block.eye.w = settings.min_width;
    block.reach = {settings.morph_from * settings.split_distance, settings.split_distance,
                   settings.fade_from * settings.cut_distance, settings.cut_distance};
    block.ground = {settings.density, settings.jitter, std::min(settings.shadow_distance, settings.cut_distance),
                    static_cast<float>(settings.far_vertices / 2)};
    block.cells = glm::ivec4(cells_of(heights, settings), settings.chunk_cells, static_cast<std::int32_t>(settings.seed));
    block.corners = glm::ivec4(heights.grid().corners, mask.grid().corners);
    block.spacing = glm::vec4(heights.grid().spacing, mask.grid().spacing);
    block.thin = {settings.thin_from, settings.thin_power, settings.thin_widen, 0.0f};
    block.clump = {1.0f / settings.clump_size, settings.clump_height, settings.clump_lean, settings.clump_fan};
    block.patches = {1.0f / settings.patch_size, settings.patch_height, 0.0f, 0.0f};
    if (const auto blades = windrow::Blades::create(settings.blade))
        block.blade = shared(blades->block());
    return block;
}

BladeRecord blade_at(const Block& block, const HeightMap& heights, const PlacementMask& mask, glm::ivec2 cell) {
    if (cell.x >= block.cells.x || cell.y >= block.cells.y)
        return BladeRecord(0.0f);
    const glm::vec2 place =
        windrow::numerics::windrow_grass_place(cell, block.ground.x, block.ground.y, static_cast<std::uint32_t>(block.cells.w));
    const float size =
        windrow::numerics::windrow_grass_size(mask.alpha(place)) * windrow::numerics::windrow_grass_growth(block, place);
    return {place.x, std::min(heights.height(place), heights.drawn_height(place)), place.y, size};
}

} // namespace windrow::vegetation::grass
