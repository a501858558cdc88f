// Reads `picture.ground`: heights out of a picture, hills by chance, or level ground.
#pragma once

#include "scene/json_object.h"
#include "vegetation/program/picture_scene.h"

#include <filesystem>

namespace windrow::vegetation::program {

/// `object` is finished here. The heights are made in any case, level ones where the file's are refused, so that what stands on
/// them can be read and judged.
[[nodiscard]] Ground read_ground(windrow::scene::JsonObject object, const std::filesystem::path& folder);

} // namespace windrow::vegetation::program
