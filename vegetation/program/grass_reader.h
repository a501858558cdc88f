// Reads `picture.grass`: layers of blades, each with its class of plant, its field, its look and its mask.
#pragma once

#include "scene/json_object.h"
#include "vegetation/program/picture_scene.h"

#include <filesystem>
#include <span>
#include <vector>

namespace windrow::vegetation::program {

/// A class that a layer may begin with.
struct PlantClass {
    const char* name;
    windrow::Drag (*stalk)();
};
/// Those of coupling/plant_classes.h, by its functions' names.
[[nodiscard]] std::span<const PlantClass> plant_classes();

[[nodiscard]] std::vector<GrassLayer> read_grass(windrow::scene::JsonObject& picture, glm::vec2 extent,
                                                 const std::filesystem::path& folder);

} // namespace windrow::vegetation::program
