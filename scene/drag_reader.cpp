#include "fluid/core/message.h"
#include "scene/scene_parts.h"
#include "scene/setting_reader.h"

namespace windrow::scene {

std::vector<DragDeposit> read_drag(JsonObject& scene) {
    constexpr std::size_t k_most = 65536;
    std::vector<DragDeposit> deposits;
    const auto items = scene.array({"drag", "What slows the air without being a body: plants, hedges, fences, nets."}, k_most);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::size_t faults_before = scene.log().faults();
        const std::string path = detail::message(scene.path(), ".drag[", i, "]");
        DragDeposit& deposit = deposits.emplace_back();
        read_kind(JsonObject(items[i], path, "$.drag[]", scene.log()), deposit,
                  [](JsonObject kind, auto& alternative) { read_object(std::move(kind), alternative); });
        if (scene.log().faults() == faults_before)
            std::visit(
                [&](const auto& kind) {
                    JsonObject object(items[i], path + "." + kind.k_name, "$.drag[]", scene.log());
                    check_read(object, kind);
                },
                deposit);
    }
    return deposits;
}

} // namespace windrow::scene
