#include "fluid/core/message.h"
#include "fluid/files/input_file.h"
#include "scene/json_document.h"
#include "scene/motion_path.h"
#include "scene/scene_parts.h"

#include <cmath>

namespace windrow::scene {
namespace {

using detail::message;
using nlohmann::json;

constexpr std::size_t k_max_paths = 4096;

MotionPath read_points(JsonObject& object) {
    std::vector<PathPoint> points;
    const auto items = object.array(
        {"points", "A time and a position each, [t, x, y, z] in s and m, each number at most 1e9 in size; times increase."},
        MotionPath::k_max_points, "points", {-MotionPath::k_farthest, MotionPath::k_farthest});
    const std::size_t faults_before = object.log().faults();
    for (std::size_t i = 0; i < items.size(); ++i) {
        const json& item = items[i];
        const std::string path = message(object.path(), ".points[", i, "]");
        if (!item.is_array() || item.size() != 4) {
            object.log().reject(path, message("is ", quote_json(item), ": give a time and a place, [t, x, y, z]."));
            continue;
        }
        double values[4] = {};
        for (std::size_t k = 0; k < 4; ++k) {
            const Range rule{.min = -MotionPath::k_farthest, .max = MotionPath::k_farthest, .unit = k == 0 ? "s" : "m"};
            values[k] = JsonObject::check_number(item[k], message(path, "[", k, "]"), rule, object.log()).value_or(0.0);
        }
        if (!points.empty() && !(values[0] > points.back().time) && object.log().faults() == faults_before)
            object.log().reject(path, message("has t = ", values[0], " s after ", points.back().time,
                                              " s: times must increase from point to point."));
        points.push_back({.time = values[0], .position = {values[1], values[2], values[3]}});
    }
    if (points.empty() && object.log().faults() == faults_before && object.value()["points"].is_array())
        object.reject("points", "is empty: give at least one point, [t, x, y, z].");
    return MotionPath(std::move(points));
}

MotionPath read_table(JsonObject& object, const std::filesystem::path& folder) {
    const auto file =
        file_beside(object,
                    {"file", "A table t,x,y,z with a point a line, in the scene's folder and named relative to it. A "
                             "line of the columns' names, lines that begin with # and empty lines are skipped."},
                    folder);
    if (!file)
        return {};
    auto path = read_path_csv(*file, folder, object.log().budget());
    if (!path) {
        object.log().reject_as_is(path.error());
        return {};
    }
    return std::move(*path);
}

} // namespace

std::optional<std::filesystem::path> file_beside(JsonObject& object, const Key& key, const std::filesystem::path& folder) {
    const std::string name = object.text(key, "", "file");
    const auto value = object.value().find(key.name);
    if (value == object.value().end() || !value->is_string())
        return std::nullopt;
    if (detail::is_name_inside(name))
        return folder / std::filesystem::path(name).lexically_normal();
    object.reject(key, detail::message("is ", quote_json(*value),
                                       ": name a file in the scene's folder, relative to it, so that the folder can be copied "
                                       "as a whole."));
    return std::nullopt;
}

std::vector<ScenePath> read_paths(JsonObject& scene, const std::filesystem::path& folder) {
    std::vector<ScenePath> paths;
    JsonObject list = scene.object(
        {"paths", "Paths by name, for follow, floor, motors and obstacles: straight lines between points. Before the first "
                  "point it waits there, after the last it stays there."});
    if (list.value().size() > k_max_paths) {
        list.reject(message("holds ", list.value().size(), " paths: give at most ", k_max_paths, "."));
        return paths;
    }
    for (const auto& [name, value] : list.value().items()) {
        JsonObject object(value, join_json_path(list.path(), name), list.pattern() + ".*", scene.log());
        ScenePath path{.name = name, .path = {}};
        switch (object.one_of({"points", "file"})) {
        case 0:
            path.path = read_points(object);
            break;
        case 1:
            path.path = read_table(object, folder);
            break;
        default:
            break;
        }
        object.finish();
        paths.push_back(std::move(path));
    }
    return paths;
}

} // namespace windrow::scene
