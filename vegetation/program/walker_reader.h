// Reads `picture.walkers` and `picture.ground_memory`: who presses the grass down, and how it remembers.
#pragma once

#include "scene/json_object.h"
#include "vegetation/program/picture_scene.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace windrow::vegetation::program {

/// `path_names`: of the scene's paths.
[[nodiscard]] std::vector<Walker> read_walkers(windrow::scene::JsonObject& picture, std::span<const std::string> path_names);

/// Nothing where the key is absent: a ground without memory.
[[nodiscard]] std::optional<windrow::GroundConfig> read_ground_memory(windrow::scene::JsonObject& picture);

} // namespace windrow::vegetation::program
