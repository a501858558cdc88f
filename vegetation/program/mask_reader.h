// Reads the `mask` of a layer of grass: a picture or an even alpha, bare patches, a path, and strokes upon it.
#pragma once

#include "scene/json_object.h"
#include "vegetation/program/picture_scene.h"

#include <filesystem>

namespace windrow::vegetation::program {

/// `object` is finished here. `extent` [m]: the heights' own. `seed`: the layer's. The mask is made unless it was refused.
[[nodiscard]] MaskSource read_mask(windrow::scene::JsonObject object, glm::vec2 extent, std::uint32_t seed,
                                   const std::filesystem::path& folder);

} // namespace windrow::vegetation::program
