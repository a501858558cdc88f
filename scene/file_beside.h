// A file that a scene names.
#pragma once

#include "scene/json_object.h"

#include <filesystem>
#include <optional>

namespace windrow::scene {

/// Where the file lies that `key` names. Refuses a name that leads out of the scene's folder, so that a folder with a scene can
/// be handed on as a whole, and a scene from somebody else reads nothing beside its own. Nothing where the key is absent or
/// refused.
[[nodiscard]] std::optional<std::filesystem::path> file_beside(JsonObject& object, const char* key,
                                                               const std::filesystem::path& folder);

} // namespace windrow::scene
