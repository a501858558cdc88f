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
    air.finish();
    if (air.log().faults() == faults_before)
        check_read(air, read.config);
    return read;
}

} // namespace windrow::scene
