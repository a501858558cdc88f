#include "vegetation/program/fan_reader.h"

#include "vegetation/program/field_reader.h"
#include "vegetation/program/picture_fields.h"

#include <glm/geometric.hpp>

namespace windrow::vegetation::program {
namespace {

constexpr std::size_t k_most_fans = 64;

Fan read_fan(JsonObject object) {
    Fan fan;
    const std::size_t faults_before = object.log().faults();
    FieldReader fields(object);
    list_fields(fields, fan);
    object.finish();
    if (object.log().faults() == faults_before && !(glm::length(glm::dvec2(fan.direction.x, fan.direction.z)) > 1e-3))
        object.refuse("direction", "has no level part: give where it blows, as [1, 0, 0].");
    return fan;
}

} // namespace

std::vector<Fan> read_fans(JsonObject& picture) {
    std::vector<Fan> fans;
    const auto items = picture.array({"fans", "Fans that are drawn; what they blow is a motor of $.motors."}, k_most_fans);
    for (std::size_t i = 0; i < items.size(); ++i)
        fans.push_back(read_fan(JsonObject(items[i], picture.path() + ".fans[" + std::to_string(i) + "]",
                                           picture.pattern() + ".fans[]", picture.log())));
    return fans;
}

} // namespace windrow::vegetation::program
