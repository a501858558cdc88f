#include "vegetation/program/picture_reader.h"

#include "scene/json_document.h"
#include "scene/number_text.h"
#include "scene/scene_reader.h"
#include "scene/text_file.h"
#include "vegetation/program/body_reader.h"
#include "vegetation/program/fan_reader.h"
#include "vegetation/program/field_reader.h"
#include "vegetation/program/grass_reader.h"
#include "vegetation/program/ground_reader.h"
#include "vegetation/program/picture_fields.h"
#include "vegetation/program/tree_reader.h"
#include "vegetation/program/walker_reader.h"

namespace windrow::vegetation::program {
namespace {

using nlohmann::json;
using windrow::scene::figure;
using windrow::scene::Key;
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

CameraSource read_camera(JsonObject object, std::span<const std::string> names) {
    CameraSource camera;
    const auto place = [&](const Key& key, const Key& path_key, glm::dvec3& where, std::optional<std::size_t>& path) {
        where = object.vector(key, where, k_place_rule);
        path = object.name(path_key, names, "paths");
        object.not_both(key.name, path_key.name);
    };
    place({"position", "Where it is."}, {"path", "Name of the path that it moves along instead."}, camera.lens.position,
          camera.path);
    place({"target", "What it looks at; not straight above or below."},
          {"target_path", "Name of the path that the target moves along instead."}, camera.lens.target, camera.target_path);
    camera.above_ground = object.boolean(
        {"above_ground", "Whether heights of position and target, or of their paths, count from the ground below each."},
        camera.above_ground);
    FieldReader fields(object);
    list_fields(fields, camera.lens);
    object.finish();
    return camera;
}

/// What only the whole tells: each camera of the run, and how many pictures there are.
void judge(const PictureScene& scene, JsonObject& picture) {
    if (scene.frame_count() > windrow::scene::k_most_frames) {
        picture.refuse("frames_per_second", "is " + figure(scene.frames_per_second()) + " 1/s, which makes " +
                                                std::to_string(scene.frame_count()) + " pictures: give at most " +
                                                std::to_string(windrow::scene::k_most_frames) +
                                                " of them, by a smaller one or a shorter $.duration.");
        return;
    }
    const bool moves = scene.picture.camera.path || scene.picture.camera.target_path;
    for (std::int64_t frame = 0; frame < (moves ? scene.frame_count() : 1); ++frame) {
        const double time = static_cast<double>(frame) / scene.frames_per_second();
        const auto judged = render::validate(camera_at(scene, time));
        if (judged)
            continue;
        JsonObject camera = picture.object("camera");
        note_refusals(judged, "camera.", camera);
        if (moves)
            camera.refuse("is so at " + figure(time) + " s, where its paths have led it: move one of them aside.");
        return;
    }
}

Picture read_picture(JsonObject& object, std::span<const std::string> names, const std::filesystem::path& folder) {
    Picture picture;
    picture.size = object.whole_pair({"size", "Width and height."}, picture.size, {.least = 16.0, .most = 8192.0, .unit = "px"},
                                     "width, height");
    picture.frames_per_second = object.optional_number({"frames_per_second", "Pictures. Default: the scene's."},
                                                       {.least = 0.001, .most = 10'000.0, .unit = "1/s"});
    picture.settle = object.number({"settle", "Of wind before the first picture, so that gusts have come in."}, picture.settle,
                                   {.least = 0.0, .most = 3600.0, .unit = "s"});
    picture.camera = read_camera(object.object({"camera", "The eye."}), names);
    read_part(object.object({"sun", "The sun and the air that it shines through."}), picture.sun);
    read_part(object.object({"fog", "What the air takes from the sight of far things."}), picture.fog);
    read_part(object.object({"clouds", "A level sheet of clouds that drifts and shades the ground."}), picture.clouds);
    picture.ground =
        read_ground(object.object({"ground", "The ground. Default: level, 100 m x 100 m about the origin."}), folder);
    picture.grass = read_grass(object, picture.ground.heights->extent(), folder);
    picture.trees = read_trees(object);
    picture.walkers = read_walkers(object, names);
    picture.fans = read_fans(object);
    picture.ground_memory = read_ground_memory(object);
    picture.bodies = read_bodies(object, names, folder);
    picture.lamps = read_lamps(object);
    read_part(object.object({"sampling", "How plants read the wind."}), picture.sampling);
    object.finish();
    return picture;
}

windrow::Result<PictureScene> read_text(std::string_view text, const std::filesystem::path& file,
                                        windrow::detail::InputBudget& budget, std::vector<windrow::scene::KnownKey>* known) {
    const auto document = windrow::scene::parse_json(text, file.string());
    if (!document)
        return windrow::Error{document.error()};
    auto air = windrow::scene::read_scene_json(*document, file, budget);
    static const json k_none = json::object();
    const bool given = document->is_object() && document->contains("picture") && (*document)["picture"].is_object();
    ReadLog log(file.string(), budget, known);
    JsonObject object(given ? (*document)["picture"] : k_none, "$.picture", "$.picture", log);
    Picture picture = read_picture(object, path_names(*document), file.parent_path());
    if (!air)
        return windrow::Error{log.faults() > 0 ? air.error() + "\n" + log.error().message : air.error()};
    PictureScene scene{.air = *std::move(air), .picture = std::move(picture), .inputs = budget};
    if (log.faults() == 0)
        judge(scene, object);
    if (log.faults() > 0)
        return log.error();
    return scene;
}

} // namespace

windrow::Result<PictureScene> read_picture_scene(const std::filesystem::path& file) {
    windrow::detail::InputBudget budget;
    const auto text = windrow::scene::read_text_file(file, {.most_bytes = windrow::scene::k_most_scene_bytes}, budget);
    if (!text)
        return windrow::Error{text.error()};
    return read_text(*text, file, budget, nullptr);
}

windrow::Result<PictureScene> read_picture_scene_text(std::string_view text, const std::filesystem::path& file,
                                                      std::vector<windrow::scene::KnownKey>* known) {
    windrow::detail::InputBudget budget;
    return read_text(text, file, budget, known);
}

} // namespace windrow::vegetation::program
