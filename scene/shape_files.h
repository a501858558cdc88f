// Meshes, voxel grids and heights that the obstacles of a scene name: each file is read once and shared.
#pragma once

#include "fluid/obstacle.h"
#include "scene/height_files.h"
#include "scene/json_object.h"
#include "scene/setting_reader.h"

#include <concepts>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

namespace windrow::scene {

class ShapeFiles {
  public:
    /// `folder` is the scene's.
    explicit ShapeFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// What the file at a key holds; null where it is missing or cannot be used, which is noted.
    void read(JsonObject& object, const Key& key, std::shared_ptr<const TriangleMesh>& mesh);
    void read(JsonObject& object, const Key& key, std::shared_ptr<const VoxelGrid>& grid);
    void read(JsonObject& object, const Key& key, std::shared_ptr<const HeightMap>& heights);
    /// The same with holes, of a ground.
    void read_ground(JsonObject& object, const Key& key, std::shared_ptr<const HeightMap>& heights);
    /// The file of a ground's holes.
    [[nodiscard]] std::optional<std::filesystem::path> holes_of(JsonObject& object) const;

  private:
    template <class Kind>
    using Files = std::map<std::string, std::shared_ptr<const Kind>>; ///< by the file and how it is read

    template <class Kind, class Parse>
    void read(JsonObject& object, const Key& key, const char* what, Files<Kind>& files, std::shared_ptr<const Kind>& shared,
              const Parse& parse, const std::string& how = "");
    void read_heights(JsonObject& object, const Key& key, std::shared_ptr<const HeightMap>& heights,
                      const std::optional<std::filesystem::path>& holes);

    std::filesystem::path folder_;
    Files<TriangleMesh> meshes_; ///< null: rejected
    Files<VoxelGrid> grids_;
    Files<HeightMap> heights_;
};

template <HasSettings Value>
void read_optional(JsonObject& object, const Key& key, std::optional<Value>& value, ShapeFiles& files);

/// All settings of an object of their own, those from files too, which `present` objects must name.
template <class Struct>
void read_with_files(JsonObject object, Struct& value, ShapeFiles& files, bool present = true) {
    read_settings(object, value, [&](const auto& row, auto& member) {
        const Key key{row.name, row.meaning};
        if constexpr (requires { files.read(object, key, member); }) {
            constexpr bool has_holes = std::same_as<Struct, Ground>;
            if (!present) { // known where no file is named too
                (void)object.text(key, "");
                if constexpr (std::same_as<decltype(member), std::shared_ptr<const HeightMap>&>)
                    (void)height_keys(object);
                if constexpr (has_holes)
                    (void)files.holes_of(object);
            } else if constexpr (has_holes) {
                files.read_ground(object, key, member);
            } else {
                files.read(object, key, member);
            }
            return true;
        } else if constexpr (requires { read_optional(object, key, member, files); }) {
            read_optional(object, key, member, files);
            return true;
        } else {
            return false;
        }
    });
    object.finish();
}

template <HasSettings Value>
void read_optional(JsonObject& object, const Key& key, std::optional<Value>& value, ShapeFiles& files) {
    Value given{};
    const bool present = object.value().contains(key.name);
    read_with_files(object.object(key), given, files, present);
    if (present)
        value = given;
}

} // namespace windrow::scene
