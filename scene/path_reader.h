// Reads `paths`: named ways that the box follows and that motors move on, as points in the scene or as a table beside it.
#pragma once

#include "scene/json_object.h"
#include "scene/scene.h"

#include <filesystem>
#include <vector>

namespace windrow::scene {

/// `folder` is the scene's: tables are named relative to it and lie in it, so that a folder with a scene can be handed on as a
/// whole, and a scene from somebody else reads nothing beside its own.
[[nodiscard]] std::vector<ScenePath> read_paths(JsonObject& scene, const std::filesystem::path& folder);

} // namespace windrow::scene
