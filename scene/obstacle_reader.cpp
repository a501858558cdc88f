#include "fluid/core/message.h"
#include "scene/scene_parts.h"
#include "scene/setting_reader.h"
#include "scene/shape_files.h"

namespace windrow::scene {
namespace {

SceneObstacle read_obstacle(const nlohmann::json& value, const std::string& path, std::span<const std::string> path_names,
                            ShapeFiles& files, ReadLog& log) {
    const std::size_t faults_before = log.faults();
    JsonObject object(value, path, "$.obstacles[]", log);
    SceneObstacle result;
    result.name = object.text({"name", "Written beside the obstacle in pictures where no other has it."}, result.name);
    read_times(object, "obstacle", result.from, result.until);
    read_settings(object, result.obstacle, [&](const auto& row, auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (std::same_as<Member, glm::quat>) {
            read_value(object,
                       Key{"turn_deg", "Yaw, pitch and roll: rolled about its own z axis, then pitched about x, then yawed about "
                                       "y, which points up. Default: not turned."},
                       member, {});
            return true;
        } else if constexpr (std::same_as<Member, Shape>) {
            read_kind(object.object({row.name, row.meaning}), member,
                      [&](JsonObject kind, auto& alternative) { read_with_files(std::move(kind), alternative, files); });
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
    read_value(object,
               Key{"rpm", "Revolutions a minute about its own axes x, y, z, from 0 s on: a wheel, a propeller. Beyond a sixth of "
                          "a turn a step it is reported; a vortex motor is the wind of a fast rotor."},
               result.rpm, Range{-1e6, 1e6, "1/min"});
    read_value(object,
               Key{"pivot",
                   "Point along its own axes from its middle that stands at the position and about which it turns: the hinge "
                   "of a door."},
               result.pivot, Range{-1e5, 1e5, "m"});
    object.not_both("position", "path");
    object.not_both("turn_deg", "turn_path");
    object.not_both("rpm", "turn_path");
    object.finish();
    if (log.faults() == faults_before)
        check_read(object, result.obstacle);
    return result;
}

} // namespace

std::vector<SceneObstacle> read_obstacles(JsonObject& scene, std::span<const std::string> path_names,
                                          const std::filesystem::path& folder) {
    std::vector<SceneObstacle> obstacles;
    ShapeFiles files(folder);
    const auto items = scene.array({"obstacles", "Bodies and buildings that the air flows around."}, Obstacles::k_capacity);
    for (std::size_t n = 0; n < items.size(); ++n)
        obstacles.push_back(
            read_obstacle(items[n], detail::message(scene.path(), ".obstacles[", n, "]"), path_names, files, scene.log()));
    return obstacles;
}

} // namespace windrow::scene
