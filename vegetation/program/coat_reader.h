// Reads one coat of a body (vegetation/fur/coat_settings.h).
#pragma once

#include "scene/json_object.h"
#include "vegetation/program/body.h"

#include <filesystem>

namespace windrow::vegetation::program {

/// Names of maps that lead out of `folder` are refused; the maps themselves are read when they are drawn.
[[nodiscard]] BodyCoat read_coat(windrow::scene::JsonObject object, const std::filesystem::path& folder);

} // namespace windrow::vegetation::program
