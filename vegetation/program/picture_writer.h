// Writes a picture as the reader reads it: every key with its value, defaults too.
#pragma once

#include "vegetation/program/picture_scene.h"

#include <nlohmann/json.hpp>

namespace windrow::vegetation::program {

/// The object for the scene's key `picture`. What it says is read back as the same structure; floats have the digits that name
/// them and no more, so that a file that was read and written says what it said. Left out is what stands for nothing: a file, a
/// path, a memory that the picture lacks.
[[nodiscard]] nlohmann::json write_picture(const PictureScene& scene);

} // namespace windrow::vegetation::program
