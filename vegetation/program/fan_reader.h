// Reads `picture.fans`: machines that are drawn where a motor blows.
#pragma once

#include "scene/json_object.h"
#include "vegetation/program/picture_scene.h"

#include <vector>

namespace windrow::vegetation::program {

[[nodiscard]] std::vector<Fan> read_fans(windrow::scene::JsonObject& picture);

} // namespace windrow::vegetation::program
