// The parts of a scene file, each read by a function: `air`, `motors`, `obstacles`, `drag`, `paths`.
#pragma once

#include "scene/json_object.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace windrow::scene {

/// What was read, and whether the scene itself says where the box is.
struct ReadAir {
    Config config;
    std::vector<SceneLevel> outer{};
    bool has_centre = false;
};
/// `folder` is the scene's: a map of its roughness is beside it.
[[nodiscard]] ReadAir read_air(JsonObject air, const std::filesystem::path& folder);

[[nodiscard]] std::vector<SceneMotor> read_motors(JsonObject& scene, std::span<const std::string> path_names);

[[nodiscard]] std::vector<DragDeposit> read_drag(JsonObject& scene);

/// `folder` is the scene's: meshes and voxel grids are beside it.
[[nodiscard]] std::vector<SceneObstacle> read_obstacles(JsonObject& scene, std::span<const std::string> path_names,
                                                        const std::filesystem::path& folder);

[[nodiscard]] std::vector<SceneSmoke> read_smoke(JsonObject& scene, std::span<const std::string> path_names);

/// `from` and `until` [s] of something that acts for a time; `what` is its name for sentences.
void read_times(JsonObject& object, const char* what, double& from, double& until);

/// Named paths that the box follows and that motors and obstacles move along, as points in the scene or as a table beside it. `folder` is the
/// scene's.
[[nodiscard]] std::vector<ScenePath> read_paths(JsonObject& scene, const std::filesystem::path& folder);

/// The file that `key` names. Rejects a name that leads out of the scene's folder, so that a folder with a scene can be moved as a
/// whole, and a scene from somebody else reads nothing outside its own. Nothing where the key is absent or rejected.
[[nodiscard]] std::optional<std::filesystem::path> file_beside(JsonObject& object, const Key& key,
                                                               const std::filesystem::path& folder);

} // namespace windrow::scene
