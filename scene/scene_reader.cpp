#include "scene/scene_reader.h"

#include "fluid/core/message.h"
#include "scene/json_document.h"
#include "scene/nearest_word.h"
#include "scene/picture_air.h"
#include "scene/scene_parts.h"
#include "scene/setting_reader.h"
#include "scene/text_file.h"

#include <algorithm>
#include <iterator>

namespace windrow::scene {
namespace {

using detail::Figure, detail::message;
using nlohmann::json;

/// The name must be valid as a folder name.
const char* fault_of_name(const std::string& name) {
    if (name.empty())
        return "give at least one letter";
    if (name.size() > 100)
        return "give at most 100 bytes";
    if (name.front() == '.' || name.front() == '-' || name.front() == ' ')
        return "begin with a letter or a digit";
    const bool bad = std::any_of(name.begin(), name.end(), [](char letter) {
        return letter == '/' || letter == '\\' || (static_cast<unsigned char>(letter) < 0x20) || letter == 0x7f;
    });
    return bad ? "leave out slashes and control characters, since it names the output folder" : nullptr;
}

std::string read_name(JsonObject& object, const std::filesystem::path& file) {
    std::string fallback = file.stem().string();
    if (fault_of_name(fallback) != nullptr)
        fallback = "scene";
    std::string name =
        object.text({"name", "Names the output folder and is written over the pictures; no slash, no control character, does not "
                             "begin with a dot, a minus or a space. Default: the file's name."},
                    fallback, "file name");
    if (const char* fix = fault_of_name(name)) {
        object.reject("name", message("is ", quote_json(json(name)), ": ", fix, "."));
        return fallback;
    }
    return name;
}

/// A value that is the name of a path or something else: the path's index where it is a name.
std::optional<std::size_t> path_index(JsonObject& object, const char* key, const json& value,
                                      std::span<const std::string> names) {
    const auto& word = value.get_ref<const std::string&>();
    const auto found = std::find(names.begin(), names.end(), word);
    if (found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    object.reject(key, message("is ", quote_json(value), ", which is not in $.paths", suggestion(word, names),
                               ": add it there or name another."));
    return std::nullopt;
}

void read_follow(JsonObject& object, Scene& scene, std::span<const std::string> names) {
    const json* const value = object.find(
        {"follow",
         "What the box follows: the name of a path, or a fixed point [m]. Default: nothing; the box stays at air.centre."},
        "name or vector", k_place_rule);
    if (value == nullptr)
        return;
    if (value->is_string()) {
        if (const auto index = path_index(object, "follow", *value, names))
            scene.follow = *index;
    } else if (value->is_array()) {
        if (const auto point = JsonObject::check_vector(*value, "$.follow", k_place_rule, object.log()))
            scene.follow = *point;
    } else {
        object.reject("follow", message("is ", quote_json(*value), ": give the name of a path, or a point [x, y, z]."));
    }
    const Config& air = scene.air;
    const glm::bvec3 open(!air.boundaries.has_solid(0) && air.boundaries.has_open(0),
                          !air.boundaries.has_solid(1) && air.boundaries.has_open(1),
                          !air.boundaries.has_solid(2) && air.boundaries.has_open(2));
    const glm::bvec3 axes = air.follow_axes.value_or(open);
    if (!axes.x && !axes.y && !axes.z)
        object.reject("follow",
                      "is given, but no axis of the box follows: open both boundaries of an axis, or give air.centre instead.");
}

void read_floor(JsonObject& object, Scene& scene, std::span<const std::string> names) {
    const json* const value = object.find(
        {"floor",
         "Height of the ground [m], which the low y side of the box is put at, to whole cells: a number, or the name of a path "
         "whose height it takes. A box with rows of its own stays until the path is below it, or above half of its equal rows. "
         "Only "
         "with a wall at air.boundaries.y_low; then the default is 0."},
        "number or name", k_place_rule);
    if (value == nullptr)
        return;
    if (value->is_string()) {
        if (const auto index = path_index(object, "floor", *value, names))
            scene.floor = *index;
    } else if (value->is_number()) {
        scene.floor = JsonObject::check_number(*value, "$.floor", k_place_rule, object.log()).value_or(0.0);
    } else {
        object.reject("floor", message("is ", quote_json(*value),
                                       ": give a height in metres, or the name of a path whose height it takes."));
    }
    if (!scene.has_floor())
        object.reject("floor",
                      "is given, but the box has none: set air.boundaries.y_low to \"free_slip\" or \"no_slip\", or remove it.");
}

void read_times(JsonObject& object, Scene& scene) {
    const std::size_t faults_before = object.log().faults();
    scene.duration =
        object.number({"duration", "Time from the first frame to the last; at most 100,000 frames and 10,000,000 steps."},
                      scene.duration, Range::above(0.0, 1e6, "s"));
    scene.tick_hz = object.number(
        {"tick_hz", "Steps of the solver a second, at least: between frames it makes equal steps, none longer than 1 / tick_hz."},
        scene.tick_hz, {1.0, 10'000.0, "Hz"});
    scene.frames_per_second = object.number(
        {"frames_per_second", "Frames that are kept a second. Frame i is the air at exactly i / frames_per_second; frame 0 "
                              "is the air before the first step."},
        scene.frames_per_second, {0.001, 10'000.0, "1/s"});
    if (object.log().faults() != faults_before)
        return;
    if (scene.frame_count() > k_max_frames)
        object.reject("duration", message("is ", Figure{scene.duration}, " s, ", scene.frame_count(), " frames: give at most ",
                                          k_max_frames, " frames, by a shorter duration or fewer frames_per_second."));
    else if (const auto steps = scene.frame_times().step_of_frame(scene.frame_count() - 1); steps > k_max_ticks)
        object.reject("duration", message("is ", Figure{scene.duration}, " s, ", steps, " steps: give at most ", k_max_ticks,
                                          " steps, by a shorter duration or a lower tick_hz."));
}

void read_outputs(JsonObject& object, Scene& scene) {
    read_object(object.object({"pictures", "How frames are drawn."}), scene.pictures);

    JsonObject vdb = object.object({"vdb", "How VDB files are written."});
    read_settings(vdb, scene.vdb, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(member)>, std::string>) {
            member = vdb.text({row.name, row.meaning}, member, "file name");
            if (const char* fix = fault_of_name(member); fix != nullptr)
                vdb.reject(row.name, message("is ", quote_json(json(member)),
                                             ": leave out slashes and control characters, 1 to 100 bytes."));
            return true;
        } else {
            return false;
        }
    });
    if (scene.vdb.grids.density && scene.smoke.empty())
        vdb.reject("grids", "asks for density, and no smoke makes any: add $.smoke, or remove it.");
    vdb.not_both("margin", "box");
    vdb.finish();
}

Result<Scene> read_whole(std::string_view text, const std::filesystem::path& file, detail::InputBudget& budget,
                         std::vector<KnownKey>* known, const FileReaders& readers) {
    const auto document = parse_json(text, file.string());
    if (!document)
        return document.failure();
    auto scene = read_scene_json(*document, file, budget, known, readers.heights);
    if (!scene || !document->contains("picture"))
        return scene;
    std::vector<std::string> names;
    for (const ScenePath& path : scene->paths)
        names.push_back(path.name);
    ReadLog log(file.string(), budget);
    log.heights = readers.heights;
    const PictureAir picture =
        read_picture_air(JsonObject((*document)["picture"], "$.picture", "$.picture", log), names, file.parent_path());
    if (log.faults() == 0)
        add_picture_air(*scene, picture, log, readers.meshes);
    std::ranges::move(log.take_warnings(), std::back_inserter(scene->warnings));
    return log.faults() == 0 ? std::move(scene) : log.error();
}

} // namespace

Result<Scene> read_scene(const std::filesystem::path& file, const FileReaders& readers) {
    detail::InputBudget budget;
    const auto text = read_text_file(file, {.max_bytes = k_max_scene_bytes}, budget);
    return text ? read_whole(*text, file, budget, nullptr, readers) : text.failure();
}

Result<Scene> read_scene_text(std::string_view text, const std::filesystem::path& file, std::vector<KnownKey>* known) {
    detail::InputBudget budget;
    return read_whole(text, file, budget, known, {});
}

Result<Scene> read_scene_json(const json& document, const std::filesystem::path& file, detail::InputBudget& budget,
                              std::vector<KnownKey>* known, HeightPictureReader heights) {
    ReadLog log(file.string(), budget, known);
    log.heights = heights;
    JsonObject object(document, "$", "$", log);

    Scene scene;
    scene.file = file;
    // Editors find the schema by this key; it means nothing to a run.
    (void)object.text({"$schema", "Where an editor finds the schema. Means nothing to a run."}, "");
    scene.name = read_name(object, file);
    scene.description = object.text({"description", "What the scene shows, for people."}, "");
    read_times(object, scene);
    const ReadAir read = read_air(object.object({"air", "The box of cells and how the air in it moves."}), file.parent_path());
    scene.air = read.config;
    scene.outer = read.outer;
    scene.paths = read_paths(object, file.parent_path());
    std::vector<std::string> names;
    for (const ScenePath& path : scene.paths)
        names.push_back(path.name);
    read_follow(object, scene, names);
    read_floor(object, scene, names);
    scene.motors = read_motors(object, names);
    scene.obstacles = read_obstacles(object, names, file.parent_path());
    scene.drag = read_drag(object);
    scene.smoke = read_smoke(object, names);
    read_outputs(object, scene);
    // What it does to the air is read by itself (picture_air.h).
    (void)object.object(
        {"picture",
         "What a renderer adds: plants, light, a camera. Of it a run takes what changes the air: walkers, bodies and hills."});
    object.finish();
    std::ranges::move(log.take_warnings(), std::back_inserter(scene.warnings));

    if (log.faults() > 0)
        return log.error();
    // A box that follows nothing is fixed, and needs no blend zone.
    if (std::holds_alternative<std::monostate>(scene.follow) && !scene.air.follow_axes)
        scene.air.follow_axes = glm::bvec3(false);
    if (!read.has_centre)
        scene.air.centre = scene.followed_point(0.0);
    if (scene.has_floor())
        scene.air.floor = scene.floor_height(0.0);
    return scene;
}

} // namespace windrow::scene
