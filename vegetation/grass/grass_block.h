// Shader blocks of the passes and the vertex stage of a grass field, and the same blades on the CPU.
#pragma once

#include "chunk_tree.h"
#include "grass_numerics.h"

#include <cstdint>

namespace windrow::vegetation::grass {

/// WindrowGrass of vegetation/shaders/numerics/grass.glsl says what each component is; std140.
using Block = windrow::numerics::WindrowGrass;
static_assert(sizeof(Block) == 11 * 16 + 12 * 16 + 64);

/// A blade as it is stored: xyz [m] its root from the field's corner, w its size, 0 where none stands. A chunk has
/// chunk_cells * chunk_cells of them, x fastest, also where the field ends within it.
using BladeRecord = glm::vec4;

/// [bytes] That one chunk's slot holds: records, an index list a view, draw commands.
[[nodiscard]] std::uint64_t chunk_bytes(const GrassSettings& settings);

/// All but what a frame sets (corner.xyz, eye, planes).
[[nodiscard]] Block block_of(const GrassSettings& settings, const HeightMap& heights, const PlacementMask& mask);

/// [m] How far any part of a blade goes from its root, in any wind.
[[nodiscard]] float blade_reach(const GrassSettings& settings);

/// The blade of a cell of the field: what the generating pass writes.
[[nodiscard]] BladeRecord blade_at(const Block& block, const HeightMap& heights, const PlacementMask& mask, glm::ivec2 cell);

} // namespace windrow::vegetation::grass
