// Reads `picture.trees`. The items are kept as they stand, each an object.
#pragma once

#include "scene/json_object.h"

#include <nlohmann/json.hpp>
#include <vector>

namespace meadow {

[[nodiscard]] std::vector<nlohmann::json> read_trees(windrow::scene::JsonObject& picture);

} // namespace meadow
