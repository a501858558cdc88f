#include "vegetation/program/picture_reader.h"

#include "fluid/core/message.h"
#include "pictures/picture_files.h"
#include "scene/json_document.h"
#include "scene/number_text.h"
#include "scene/picture_air.h"
#include "scene/scene_reader.h"
#include "scene/text_file.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/program/part_reader.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>

namespace windrow::vegetation::program {
namespace {

using nlohmann::json;
using windrow::scene::figure;
using windrow::scene::ReadLog;

/// As Scene::paths will have them, whether the rest of the scene can be used or not.
std::vector<std::string> path_names(const json& document) {
    std::vector<std::string> names;
    const json paths = document.is_object() ? document.value("paths", json::object()) : json::object();
    if (paths.is_object())
        for (const auto& [name, value] : paths.items())
            names.push_back(name);
    return names;
}

/// What only the whole tells: each camera of the run, and how many pictures there are.
void judge(const PictureScene& scene, JsonObject& picture) {
    const auto& obstacles = scene.air.obstacles;
    for (std::size_t n = 0; n < scene.picture.obstacles.size(); ++n) {
        const std::string& name = scene.picture.obstacles[n].name;
        if (std::none_of(obstacles.begin(), obstacles.end(), [&](const auto& obstacle) { return obstacle.name == name; }))
            picture.log().reject(picture.path() + ".obstacles[" + std::to_string(n) + "]",
                                 "is for \"" + name + "\", but no obstacle of $.obstacles has that name: give one of theirs.");
    }
    if (scene.frame_count() > windrow::scene::k_max_frames) {
        picture.reject("frames_per_second",
                       detail::message("is ", figure(scene.frames_per_second()), " 1/s, which makes ", scene.frame_count(),
                                       " pictures: give at most ", windrow::scene::k_max_frames,
                                       " of them, by a smaller one or a shorter $.duration."));
        return;
    }
    const bool moves = scene.picture.camera.path || scene.picture.camera.target_path;
    for (std::int64_t frame = 0; frame < (moves ? scene.frame_count() : 1); ++frame) {
        const double time = static_cast<double>(frame) / scene.frames_per_second();
        const render::Camera seen = camera_at(scene, time);
        if (render::validate(seen))
            continue;
        JsonObject camera = picture.object("camera");
        check_read(camera, seen);
        if (moves)
            camera.reject("has this fault at " + figure(time) + " s on its paths: change one of them.");
        return;
    }
}

Picture read_picture(JsonObject& object, Surroundings& around) {
    Picture picture;
    read_parts(object, picture, around, [&](const auto& row, auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (std::same_as<Member, glm::ivec2>) {
            member = object.whole_pair({row.name, row.meaning}, member, row.range, "width, height");
            return true;
        } else if constexpr (std::same_as<Member, render::Quality>) {
            JsonObject quality = object.object({row.name, row.meaning});
            const std::size_t faults_before = object.log().faults();
            read_parts(quality, member, around);
            if (object.log().faults() == faults_before)
                check_read(quality, member);
            quality.finish();
            return true;
        } else if constexpr (std::same_as<Member, std::optional<windrow::GroundConfig>>) {
            const std::size_t faults_before = object.log().faults();
            windrow::scene::read_value(object, {row.name, row.meaning}, member, row.range);
            if (JsonObject memory = object.object({row.name, row.meaning}); member && object.log().faults() == faults_before)
                check_read(memory, *member);
            return true;
        }
        return false;
    });
    // A press that nothing remembers would not be seen at all.
    if (!picture.walkers.empty() && !object.value().contains("ground_memory"))
        object.reject("walkers", "is given, but \"ground_memory\" is not: add \"ground_memory\": {}, or remove it.");
    object.finish();
    return picture;
}

/// The box of a mesh that is no OBJ.
windrow::Result<windrow::scene::BodyBox> read_box(const std::filesystem::path& file, const fur::MeshLoad& load,
                                                  const std::filesystem::path& folder, windrow::detail::InputBudget& budget) {
    const auto mesh = fur::read_mesh(file, load, folder, budget);
    return mesh ? windrow::Result(windrow::scene::BodyBox{mesh->low, mesh->high}) : mesh.failure();
}

/// What the air needs of a picture that was read without a fault from `value`.
windrow::scene::PictureAir air_of(const Picture& picture, const json& value) {
    windrow::scene::PictureAir air{.ground = picture.ground, .walkers = picture.walkers, .trees = picture.trees};
    for (const Body& body : picture.bodies) {
        const json& own = value["bodies"][air.bodies.size()];
        air.bodies.push_back({.name = body.name,
                              .place = body.place,
                              .motion = body.motion,
                              .furred = !body.coats.empty(),
                              .mesh = own.contains("mesh") ? &own["mesh"] : nullptr});
    }
    return air;
}

windrow::Result<PictureScene> read_text(std::string_view text, const std::filesystem::path& file,
                                        windrow::detail::InputBudget& budget, std::vector<windrow::scene::KnownKey>* known) {
    const auto document = windrow::scene::parse_json(text, file.string());
    if (!document)
        return document.failure();
    auto air = windrow::scene::read_scene_json(*document, file, budget, nullptr, windrow::pictures::read_heights);
    static const json k_none = json::object();
    const bool given = document->is_object() && document->contains("picture") && (*document)["picture"].is_object();
    ReadLog log(file.string(), budget, known);
    log.heights = windrow::pictures::read_heights;
    JsonObject object(given ? (*document)["picture"] : k_none, "$.picture", "$.picture", log);
    const std::vector<std::string> names = path_names(*document);
    const std::filesystem::path folder = file.parent_path();
    Surroundings around{.paths = names, .folder = folder};
    Picture picture = read_picture(object, around);
    if (!air)
        return windrow::Error{log.faults() > 0 ? air.error() + "\n" + log.error().message : air.error()};
    PictureScene scene{.air = *std::move(air), .picture = std::move(picture)};
    if (log.faults() == 0) {
        windrow::scene::add_picture_air(scene.air, air_of(scene.picture, object.value()), log, read_box);
        judge(scene, object);
    }
    scene.inputs = budget;
    std::ranges::move(log.take_warnings(), std::back_inserter(scene.air.warnings));
    if (log.faults() > 0)
        return log.error();
    return scene;
}

} // namespace

void read_part(JsonObject object, CameraSource& camera, Surroundings& around) {
    read_parts(object, camera, around);
    object.not_both("position", "path");
    object.not_both("target", "target_path");
    object.finish();
}

void read_part(JsonObject object, StandSource& stand, Surroundings&) {
    windrow::scene::read_stand(std::move(object), stand);
}

void read_part(JsonObject object, GroundSource& ground, Surroundings& around) {
    windrow::scene::read_ground(std::move(object), ground, around.folder);
    around.extent = ground.heights->extent();
}

void read_part(JsonObject object, Walker& walker, Surroundings& around) {
    windrow::scene::read_walker(std::move(object), walker, around.paths);
}

void read_part(JsonObject object, Fan& fan, Surroundings&) {
    const std::size_t faults_before = object.log().faults();
    read_object(object, fan);
    if (object.log().faults() == faults_before && !(glm::length(glm::dvec2(fan.direction.x, fan.direction.z)) > 1e-3))
        object.reject("direction", "has no horizontal component: give one, as in [1, 0, 0].");
}

windrow::Result<PictureScene> read_picture_scene(const std::filesystem::path& file) {
    windrow::detail::InputBudget budget;
    const auto text = windrow::scene::read_text_file(file, {.max_bytes = windrow::scene::k_max_scene_bytes}, budget);
    if (!text)
        return text.failure();
    return read_text(*text, file, budget, nullptr);
}

windrow::Result<PictureScene> read_picture_scene_text(std::string_view text, const std::filesystem::path& file,
                                                      std::vector<windrow::scene::KnownKey>* known) {
    windrow::detail::InputBudget budget;
    return read_text(text, file, budget, known);
}

} // namespace windrow::vegetation::program
