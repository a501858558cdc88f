#include "fluid/core/message.h"
#include "scene/scene_parts.h"
#include "scene/setting_reader.h"

namespace windrow::scene {

std::vector<SceneSmoke> read_smoke(JsonObject& scene, std::span<const std::string> path_names) {
    constexpr std::size_t k_most = 1024;
    std::vector<SceneSmoke> sources;
    const auto items =
        scene.array({"smoke", "Sources of smoke for VDB files: the wind carries it, and it does not act on the wind."}, k_most);
    for (std::size_t i = 0; i < items.size(); ++i) {
        JsonObject object(items[i], detail::message(scene.path(), ".smoke[", i, "]"), "$.smoke[]", scene.log());
        SceneSmoke source;
        source.position = object.vector({"position", "Its centre."}, source.position, k_place_rule);
        object.not_both("position", "path");
        source.path = object.name({"path", "Name of the path that its centre moves along."}, path_names, "paths");
        source.radius =
            object.real({"radius", "Density is 1 within it, and less within a cell beyond it."}, source.radius, k_size_range);
        read_times(object, "smoke", source.from, source.until);
        object.finish();
        sources.push_back(source);
    }
    return sources;
}

} // namespace windrow::scene
