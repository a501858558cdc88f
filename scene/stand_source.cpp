#include "scene/stand_source.h"

#include "scene/setting_reader.h"

#include <utility>

namespace windrow::scene {

void read_stand(JsonObject object, StandSource& stand) {
    const std::size_t faults_before = object.log().faults();
    read_settings(object, stand, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<decltype(member), std::string&>) {
            std::vector<std::string> kinds;
            for (const TreeCrown& crown : k_tree_crowns)
                kinds.emplace_back(crown.kind);
            const std::size_t chosen = object.word_index({row.name, row.meaning}, member, kinds);
            if (chosen < kinds.size())
                member = kinds[chosen];
        }
        return std::same_as<decltype(member), std::string&>;
    });
    object.finish();
    if (object.log().faults() == faults_before)
        check_read(object, stand);
}

std::vector<TreePlace> places_of(const StandSource& stand, const GroundSource& ground) {
    const auto height = [&](double x, double z) { return ground.height(x, z); };
    std::vector<TreePlace> places;
    for (const StandPlace& place : stand.places)
        places.push_back(
            {.base = {place.at.x, height(place.at.x, place.at.y), place.at.y}, .size = place.size, .yaw_deg = place.yaw_deg});
    if (const auto scattered = scatter(stand.scatter, height))
        places.insert(places.end(), scattered->begin(), scattered->end());
    return places;
}

std::vector<DragDeposit> drag_of(const StandSource& stand, const GroundSource& ground) {
    std::vector<DragDeposit> deposits;
    for (const TreeCrown& crown : k_tree_crowns)
        if (crown.kind == stand.kind)
            for (const TreePlace& place : places_of(stand, ground))
                deposits.emplace_back(drag_of(crown, place));
    return deposits;
}

} // namespace windrow::scene
