// Reads `bodies` and `lamps` of a picture (vegetation/program/body.h).
#pragma once

#include "scene/json_object.h"
#include "vegetation/fur/lamps.h"
#include "vegetation/program/body.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace windrow::vegetation::program {

/// `path_names` are those of the scene; files are looked for in `folder`.
[[nodiscard]] std::vector<Body> read_bodies(windrow::scene::JsonObject& picture, std::span<const std::string> path_names,
                                            const std::filesystem::path& folder);
[[nodiscard]] std::vector<fur::Lamp> read_lamps(windrow::scene::JsonObject& picture);

} // namespace windrow::vegetation::program
