#include "vegetation/program/walker_reader.h"

#include "scene/number_text.h"
#include "vegetation/program/field_reader.h"
#include "vegetation/program/picture_fields.h"

namespace windrow::vegetation::program {
namespace {

using windrow::scene::figure;

constexpr std::size_t k_most_walkers = 256; // GroundConfig::most_walkers
constexpr std::size_t k_most_jumps = 1024;

Jump read_jump(JsonObject object) {
    constexpr Range k_time_rule{.least = -1e9, .most = 1e9, .unit = "s"};
    Jump jump;
    const std::size_t faults_before = object.log().faults();
    jump.from = object.required_number({"from", "[s]"}, k_time_rule);
    jump.until = object.required_number({"until", "Later than from."}, k_time_rule);
    jump.height = object.real({"height", "Of the feet in its middle."}, jump.height, {.least = 0.0, .most = 100.0, .unit = "m"});
    object.finish();
    if (!(jump.from < jump.until) && object.log().faults() == faults_before)
        object.refuse("until",
                      "is " + figure(jump.until) + " s, not after \"from\", " + figure(jump.from) + " s: give a later time.");
    return jump;
}

Walker read_walker(JsonObject object, std::span<const std::string> path_names) {
    Walker walker;
    walker.path =
        object.name({"path", "Name of the path that it walks on; x and z count."}, path_names, "paths", true).value_or(0);
    FieldReader fields(object);
    list_fields(fields, walker);
    walker.figure = object.boolean({"figure", "Whether someone in a cloak is drawn there."}, walker.figure);
    const auto items =
        object.array({"airborne", "Times at which its feet leave the ground, on a parabola as a jump does."}, k_most_jumps);
    for (std::size_t i = 0; i < items.size(); ++i)
        walker.airborne.push_back(read_jump(JsonObject(items[i], object.path() + ".airborne[" + std::to_string(i) + "]",
                                                       object.pattern() + ".airborne[]", object.log())));
    object.finish();
    return walker;
}

} // namespace

std::vector<Walker> read_walkers(JsonObject& picture, std::span<const std::string> path_names) {
    std::vector<Walker> walkers;
    const auto items = picture.array({"walkers", "Who presses the grass down; needs ground_memory."}, k_most_walkers);
    for (std::size_t i = 0; i < items.size(); ++i)
        walkers.push_back(read_walker(JsonObject(items[i], picture.path() + ".walkers[" + std::to_string(i) + "]",
                                                 picture.pattern() + ".walkers[]", picture.log()),
                                      path_names));
    // A press that nothing remembers would not be seen at all.
    if (!items.empty() && !picture.value().contains("ground_memory"))
        picture.refuse("walkers", "is given, but no ground remembers them: add \"ground_memory\": {}, or remove it.");
    return walkers;
}

std::optional<windrow::GroundConfig> read_ground_memory(JsonObject& picture) {
    JsonObject object =
        picture.object({"ground_memory", "A ground that remembers walkers and wind. Default: none; {} for its defaults."});
    windrow::GroundConfig config;
    const std::size_t faults_before = object.log().faults();
    FieldReader fields(object);
    list_fields(fields, config);
    read_part(object.object({"spring", "How the plants swing. Default: grass."}), config.spring);
    object.finish();
    if (!picture.value().contains("ground_memory"))
        return std::nullopt;
    if (object.log().faults() == faults_before)
        note_refusals(windrow::validate(config), "GroundConfig::", object);
    return config;
}

} // namespace windrow::vegetation::program
