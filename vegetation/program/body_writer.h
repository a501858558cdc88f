// Bodies back to JSON: what body_reader.h reads again as it was.
#pragma once

#include "scene/scene.h"
#include "vegetation/program/body.h"

#include <nlohmann/json.hpp>

namespace windrow::vegetation::program {

/// All keys, defaults too; of a coat on a file's mesh only those of the fur line's that the scene gave.
[[nodiscard]] nlohmann::json write_body(const Body& body, const windrow::scene::Scene& air);

} // namespace windrow::vegetation::program
