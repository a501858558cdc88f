// Reads the `mask` of a layer of grass: a picture or an even alpha, bare patches, a path, and strokes upon it.
#pragma once

#include "fluid/input_budget.h"
#include "scene/json_object.h"
#include "vegetation/program/picture_scene.h"

#include <filesystem>

namespace windrow::vegetation::program {

/// `object` is finished here. `extent` [m]: the heights' own. `seed`: the layer's. The mask is made unless it was refused.
[[nodiscard]] MaskSource read_mask(windrow::scene::JsonObject object, glm::vec2 extent, std::uint32_t seed,
                                   const std::filesystem::path& folder);

/// A mask from a PGM in the scene's folder, which takes its part of `budget`.
[[nodiscard]] windrow::Result<grass::PlacementMask> read_pgm(const std::filesystem::path& file,
                                                             const std::filesystem::path& folder, glm::vec2 extent,
                                                             windrow::detail::InputBudget& budget);

} // namespace windrow::vegetation::program
