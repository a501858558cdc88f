#include "scene/scene_parts.h"
#include "scene/setting_reader.h"
#include "scene/shape_files.h"

namespace windrow::scene {

void read_side(JsonObject& boundaries, const Key& key, Boundary& side) {
    const auto given = boundaries.value().find(key.name);
    const bool is_object = given != boundaries.value().end() && given->is_object();
    // Both forms of a boundary are known keys, whichever the file uses.
    if (is_object || !boundaries.value().contains(key.name))
        read_object(boundaries.object(key), side);
    if (!is_object)
        read_value(boundaries, key, side.kind, {});
}

namespace {

constexpr int k_most_levels = 2; // around the box: each is an object in the one inside it

void read_level(JsonObject& inside, std::vector<SceneLevel>& levels, int most) {
    const bool given = inside.value().contains("outer");
    JsonObject outer = inside.object(
        {"outer",
         "A wind around the box, larger and coarser, in place of the ambient wind: what stands and blows outside of the box "
         "comes in. The mean wind, its profile and gusts, the boundaries, the ground and all settings that it has not are "
         "those of air. It runs on the CPU, also where the box inside it is on a device. Default none."});
    SceneLevel level;
    const std::size_t faults_before = outer.log().faults();
    read_settings(outer, level, [](const auto&, const auto&) { return false; });
    if (given) {
        levels.push_back(level);
        if (outer.log().faults() == faults_before)
            check_read(outer, level);
    }
    if (most > 1)
        read_level(outer, levels, most - 1);
    outer.finish();
}

} // namespace

ReadAir read_air(JsonObject air, const std::filesystem::path& folder) {
    const std::size_t faults_before = air.log().faults();
    ReadAir read;
    ShapeFiles files(folder);
    read_settings(air, read.config, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(member)>, glm::dvec3>) {
            // Without a centre the box begins at what it follows.
            const auto centre = air.optional_vector({row.name, row.meaning}, k_place_rule);
            read.has_centre = centre.has_value();
            member = centre.value_or(member);
            return true;
        } else if constexpr (std::same_as<std::remove_cvref_t<decltype(member)>, double>) {
            return true; // $.floor: a height, or a path
        } else if constexpr (requires { read_optional(air, Key{""}, member, files); }) {
            read_optional(air, {row.name, row.meaning}, member, files);
            return true;
        } else {
            return false;
        }
    });
    read_level(air, read.outer, k_most_levels);
    air.finish();
    if (air.log().faults() == faults_before)
        check_read(air, read.config);
    return read;
}

} // namespace windrow::scene
