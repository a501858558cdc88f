// Reads `picture.trees`: stands of trees, each of one kind, at places of their own and by chance.
#pragma once

#include "scene/json_object.h"
#include "vegetation/program/picture_scene.h"

#include <vector>

namespace windrow::vegetation::program {

[[nodiscard]] std::vector<TreeStand> read_trees(windrow::scene::JsonObject& picture);

} // namespace windrow::vegetation::program
