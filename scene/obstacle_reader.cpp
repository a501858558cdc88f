#include "fluid/message.h"
#include "scene/scene_parts.h"
#include "scene/setting_reader.h"

namespace windrow::scene {
namespace {

SceneObstacle read_obstacle(const nlohmann::json& value, const std::string& path, std::span<const std::string> path_names,
                            ReadLog& log) {
    const std::size_t faults_before = log.faults();
    JsonObject object(value, path, "$.obstacles[]", log);
    SceneObstacle result;
    result.name = object.text({"name", "Written beside the obstacle in pictures."}, "obstacle");
    read_times(object, "obstacle", result.from, result.until);
    read_settings(object, result.obstacle, [&](const auto&, auto& member) {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(member)>, glm::quat>) {
            read_value(object,
                       Key{"turn_deg", "Yaw, pitch and roll: rolled about its own z axis, then pitched about x, then yawed about "
                                       "y, which points up. Default: not turned."},
                       member, {});
            return true;
        } else {
            return false;
        }
    });
    result.path = object.name({"path", "Name of the path that the position moves along."}, path_names, "paths");
    result.turn_path =
        object.name({"turn_path", "Name of a path whose x, y, z are yaw, pitch and roll in degrees: a door that opens, a train "
                                  "that turns."},
                    path_names, "paths");
    object.not_both("position", "path");
    object.not_both("turn_deg", "turn_path");
    object.finish();
    if (log.faults() == faults_before)
        check_read(object, result.obstacle);
    return result;
}

} // namespace

std::vector<SceneObstacle> read_obstacles(JsonObject& scene, std::span<const std::string> path_names) {
    std::vector<SceneObstacle> obstacles;
    const auto items =
        scene.array({"obstacles", "Bodies and buildings that the air flows around, on the CPU alone."}, Obstacles::k_capacity);
    for (std::size_t n = 0; n < items.size(); ++n)
        obstacles.push_back(
            read_obstacle(items[n], detail::message(scene.path(), ".obstacles[", n, "]"), path_names, scene.log()));
    return obstacles;
}

} // namespace windrow::scene
