// Reads and writes the skeleton of a body (vegetation/fur/skeleton.h).
#pragma once

#include "scene/json_object.h"
#include "vegetation/program/body.h"

#include <nlohmann/json.hpp>

namespace windrow::vegetation::program {

[[nodiscard]] BodySkeleton read_skeleton(windrow::scene::JsonObject object);
[[nodiscard]] nlohmann::json write_skeleton(const BodySkeleton& skeleton);

} // namespace windrow::vegetation::program
