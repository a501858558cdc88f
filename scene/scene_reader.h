// Reads a scene file. What each key means, its unit, default and range: the tables of the settings (fluid/setting.h), as text in
// docs/scene_keys.md.
#pragma once

#include "fluid/result.h"
#include "scene/body_box.h"
#include "scene/read_log.h"
#include "scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace windrow::scene {

/// Beyond it a scene is an accident.
inline constexpr std::size_t k_max_scene_bytes = std::size_t{16} << 20;

/// How files are read that this folder has no reader for; null: they are not.
struct FileReaders {
    HeightPictureReader heights = nullptr; ///< height maps of other formats than PGM
    MeshBoxReader meshes = nullptr;        ///< meshes of bodies of other formats than OBJ
};

/// Reads a scene of at most 16 MiB and the files that it names, with what its picture does to the air. Tells every fault, a line
/// each: file, JSON path, value, fix.
[[nodiscard]] Result<Scene> read_scene(const std::filesystem::path& file, const FileReaders& readers = {});

/// The same from text; `file` says where paths are looked for and begins the sentences. `known` receives every key that was asked
/// for, whether the text has it or not, those of the picture aside.
[[nodiscard]] Result<Scene> read_scene_text(std::string_view text, const std::filesystem::path& file,
                                            std::vector<KnownKey>* known = nullptr);

/// The same from parsed text, with the budget of the files that the scene names, without the picture: add_picture_air adds what that
/// does to the air.
[[nodiscard]] Result<Scene> read_scene_json(const nlohmann::json& document, const std::filesystem::path& file,
                                            detail::InputBudget& budget, std::vector<KnownKey>* known = nullptr,
                                            HeightPictureReader heights = nullptr);

} // namespace windrow::scene
