// The bunny and the beast of examples/scenes/fur as a test clothes them: their coats, poses and wind, and where a layer's vertex is
// by the device's own skin.
#pragma once

#include "vegetation/files/mesh_file.h"
#include "vegetation/program/furred_body.h"
#include "vegetation/program/picture_reader.h"
#include "vegetation/tests/fur/coat_numerics.h"
#include "vegetation/tests/fur/folder.h"
#include "vegetation/tests/fur/stage.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>

namespace windrow::vegetation::fur::test {

struct Subject {
    program::PictureScene scene{};
    std::size_t body = 0; ///< its number in the scene
    program::BodyModel model{};
    CoatSettings coat{};

    [[nodiscard]] const program::Body& worn() const { return scene.picture.bodies.at(body); }
    [[nodiscard]] glm::vec3 wind() const { return glm::normalize(scene.air.air.ambient); }

    /// Turned about the vertical by `turn` [rad]: the wind comes from another side.
    [[nodiscard]] windrow::Pose pose(double time, double turn) const {
        windrow::Pose pose = program::pose_of(scene, worn(), time);
        const glm::dquat about = glm::angleAxis(turn, glm::dvec3(0.0, 1.0, 0.0));
        const glm::dquat all = about * glm::dquat(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
        pose.rotation = {all.x, all.y, all.z, all.w};
        pose.position = k_anchor + about * pose.position;
        return pose;
    }
    [[nodiscard]] std::vector<glm::mat4> bones(double time) const {
        return model.skeleton ? fur::pose(*model.skeleton, time) : std::vector<glm::mat4>{};
    }
};

/// The coat is that of the scene without its pictures, which git does not hold.
inline Subject subject(const char* name) {
    const std::filesystem::path file =
        std::filesystem::path(WINDROW_SOURCE_DIR) / "examples/scenes/fur" / (std::string(name) + ".json");
    auto scene = program::read_picture_scene(file);
    EXPECT_TRUE(scene) << scene.error();
    Subject made;
    made.scene = *std::move(scene);
    const auto& bodies = made.scene.picture.bodies;
    const auto named = std::find_if(bodies.begin(), bodies.end(), [&](const auto& body) { return body.name == name; });
    EXPECT_NE(named, bodies.end()) << name;
    made.body = static_cast<std::size_t>(named - bodies.begin());
    made.coat = made.worn().coats.front().coat;
    made.coat.maps.length.clear();
    made.coat.maps.colour.clear();
    made.coat.levels.shadow_shells = 0;
    return made;
}

/// glmark2-data's file is what the scene's is made of.
inline Subject pictured_bunny() {
    Subject bunny = subject("bunny");
    auto mesh = read_mesh(glmark2("bunny.obj"), std::get<program::MeshSource>(bunny.worn().mesh).load);
    EXPECT_TRUE(mesh) << mesh.error();
    bunny.model.mesh = *std::move(mesh);
    return bunny;
}

inline Subject walking_beast() {
    Subject beast = subject("beast");
    windrow::detail::InputBudget budget;
    auto model = program::model_of(beast.scene, beast.worn(), budget);
    EXPECT_TRUE(model) << model.error();
    beast.model = *std::move(model);
    return beast;
}

/// Nothing of the body is in view: a frame is the coat's own passes.
inline void skin_only(Stage& stage, double seconds) {
    stage.draw(camera_at({0.0, 900.0, 0.0}, {1.0, 1000.0, 0.0}), seconds);
}

/// [m] From a vertex of the skin to its layer at height h: shell_vertex.glsl's bent form.
inline glm::dvec3 layer_offset(const Coat& coat, const CoatSkinBlock& skin, float h) {
    using namespace numerics;
    const auto shells = windrow::detail::shared(coat.block().shells);
    const WindrowCoatStrand strand = windrow_coat_strand(shells, glm::vec3(skin.normal), skin.position.w, glm::vec3(skin.load),
                                                         glm::vec3(skin.own), glm::vec3(skin.lag), glm::vec3(skin.lag_more));
    const glm::vec3 straight = (strand.stem.reach * h + shells.form.x * shells.form.z) * glm::vec3(skin.normal);
    return glm::dvec3((1.0f - skin.load.w) * (straight + windrow_coat_shift(strand, h)));
}

} // namespace windrow::vegetation::fur::test
