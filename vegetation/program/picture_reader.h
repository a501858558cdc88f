// Reads a scene file whole: the air as `windrow run` does, and the picture.
#pragma once

#include "fluid/result.h"
#include "scene/read_log.h"
#include "vegetation/program/picture_scene.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace windrow::vegetation::program {

/// Reads a scene of at most 16 MiB and the files that it names. Tells every fault, a line each: file, JSON path, value, fix.
[[nodiscard]] windrow::Result<PictureScene> read_picture_scene(const std::filesystem::path& file);

/// The same from text; `file` says where files are looked for and begins the sentences. `known` receives every key of the picture
/// that was asked for, whether the text has it or not.
[[nodiscard]] windrow::Result<PictureScene> read_picture_scene_text(std::string_view text, const std::filesystem::path& file,
                                                                    std::vector<windrow::scene::KnownKey>* known = nullptr);

} // namespace windrow::vegetation::program
