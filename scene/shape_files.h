// Meshes, voxel grids and heights that the obstacles of a scene name: each file is read once and shared.
#pragma once

#include "fluid/obstacle.h"
#include "scene/json_object.h"

#include <filesystem>
#include <map>
#include <memory>

namespace windrow::scene {

class ShapeFiles {
  public:
    /// `folder` is the scene's.
    explicit ShapeFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// What the file at a key holds; null where it is missing or cannot be used, which is noted.
    void read(JsonObject& object, const Key& key, std::shared_ptr<const TriangleMesh>& mesh);
    void read(JsonObject& object, const Key& key, std::shared_ptr<const VoxelGrid>& grid);
    void read(JsonObject& object, const Key& key, std::shared_ptr<const HeightMap>& heights);

  private:
    template <class Kind>
    using Files = std::map<std::filesystem::path, std::shared_ptr<const Kind>>;

    template <class Kind, class Parse>
    void read(JsonObject& object, const Key& key, const char* what, Files<Kind>& files, std::shared_ptr<const Kind>& shared,
              const Parse& parse);

    std::filesystem::path folder_;
    Files<TriangleMesh> meshes_; ///< null: rejected
    Files<VoxelGrid> grids_;
    Files<HeightMap> heights_;
};

} // namespace windrow::scene
