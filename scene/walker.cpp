#include "scene/walker.h"

#include "scene/number_text.h"
#include "scene/setting_reader.h"

#include <algorithm>

namespace windrow::scene {
namespace {

void read_jump(JsonObject object, Jump& jump) {
    const std::size_t faults_before = object.log().faults();
    read_settings(object, jump, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<decltype(member), double&>)
            member = object.required_number({row.name, row.meaning}, row.range);
        return std::same_as<decltype(member), double&>;
    });
    object.finish();
    if (!(jump.from < jump.until) && object.log().faults() == faults_before)
        object.reject("until",
                      "is " + figure(jump.until) + " s, not after \"from\", " + figure(jump.from) + " s: give a later time.");
}

} // namespace

float Walker::foot_height(double time) const {
    double highest = 0.0;
    for (const Jump& jump : airborne) {
        const double share = std::clamp((time - jump.from) / (jump.until - jump.from), 0.0, 1.0);
        highest = std::max(highest, 4.0 * static_cast<double>(jump.height) * share * (1.0 - share));
    }
    return static_cast<float>(highest);
}

void read_walker(JsonObject object, Walker& walker, std::span<const std::string> path_names) {
    read_settings(object, walker, [&](const auto& row, auto& member) {
        const Key key{row.name, row.meaning};
        if constexpr (std::same_as<decltype(member), std::size_t&>) {
            member = object.name(key, path_names, "paths", true).value_or(0);
            return true;
        } else if constexpr (std::same_as<decltype(member), std::vector<Jump>&>) {
            read_items(object, key, row.range, [&](JsonObject item) { read_jump(std::move(item), member.emplace_back()); });
            return true;
        } else {
            return false;
        }
    });
    object.finish();
}

} // namespace windrow::scene
