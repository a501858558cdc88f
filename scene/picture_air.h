// What the air needs of a scene's picture: hills that it flows over, trees that slow it (stand_source.h), and what carries it along (carried.h). A run and a renderer read
// it by the same functions, so that one scene has one air.
//
// Air that the scene moves already is not moved twice. There is no wake on a path that a wake or an obstacle of the scene is on,
// one wake for all that is drawn on the same path, and none where `wake` of the walker or of the body's motion is false.
#pragma once

#include "scene/body_box.h"
#include "scene/body_motion.h"
#include "scene/ground_source.h"
#include "scene/scene.h"
#include "scene/stand_source.h"
#include "scene/walker.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace windrow::scene {

/// What the air needs of a body.
struct MovedBody {
    std::string name = "body";
    BodyPlace place{};
    BodyMotion motion{};
    bool furred = false;                  ///< a body without a coat is invisible, and has no wake
    const nlohmann::json* mesh = nullptr; ///< value of its key, which outlives this; null: the default
};

struct PictureAir {
    GroundSource ground{};
    std::vector<Walker> walkers{};
    std::vector<MovedBody> bodies{};
    std::vector<StandSource> trees{};
};

/// Reads the value of `picture`, and nothing of it that the air does not need. `folder` is the scene's.
[[nodiscard]] PictureAir read_picture_air(JsonObject picture, std::span<const std::string> path_names,
                                          const std::filesystem::path& folder);

/// Adds hills to Scene::obstacles, trees to Scene::planted and what is moved to Scene::carried. A body whose mesh cannot be read has no wake, and a
/// sentence in Scene::warnings says why.
void add_picture_air(Scene& scene, const PictureAir& picture, ReadLog& log, MeshBoxReader meshes);

} // namespace windrow::scene
