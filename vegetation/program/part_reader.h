// Reads the parts of a picture by their settings, and what they name of the scene around them: paths and files.
#pragma once

#include "fluid/files/input_budget.h"
#include "scene/setting_reader.h"
#include "vegetation/program/picture_scene.h"

#include <filesystem>
#include <span>
#include <string>

namespace windrow::vegetation::program {

using windrow::scene::JsonObject, windrow::scene::Key;

struct Surroundings {
    std::span<const std::string> paths;  ///< names of the scene's
    const std::filesystem::path& folder; ///< of its files
    glm::vec2 extent{0.0f};              ///< [m] of the ground, once that is read
};

/// Parts that need more than their settings. Each reads the whole of its object.
void read_part(JsonObject object, CameraSource& camera, Surroundings& around);
void read_part(JsonObject object, GroundSource& ground, Surroundings& around);
void read_part(JsonObject object, MaskSource& mask, Surroundings& around);
void read_part(JsonObject object, GrassSource& layer, Surroundings& around);
void read_part(JsonObject object, StandSource& stand, Surroundings& around);
void read_part(JsonObject object, Walker& walker, Surroundings& around);
void read_part(JsonObject object, Fan& fan, Surroundings& around);
void read_part(JsonObject object, MeshSource& mesh, Surroundings& around);
void read_part(JsonObject object, BodySkeleton& skeleton, Surroundings& around);
void read_part(JsonObject object, BodyCoat& coat, Surroundings& around);
void read_part(JsonObject object, windrow::ShellSettings& layers, Surroundings& around);
void read_part(JsonObject object, fur::CoatMaps& maps, Surroundings& around);

/// A stalk whose length is its owner's.
void read_stalk(JsonObject object, windrow::Drag& stalk);
/// The name of a file in the folder, and its place; nothing where absent or rejected.
std::optional<std::filesystem::path> read_file(JsonObject& object, const Key& key, std::string& name, const Surroundings& around);
/// A mask, or heights of 0 to 1, from a PGM in the scene's folder, which takes its part of `budget`.
[[nodiscard]] windrow::Result<grass::PlacementMask> read_pgm(const std::filesystem::path& file, const Surroundings& around,
                                                             glm::vec2 extent, windrow::detail::InputBudget& budget);

/// All settings of a part; false from `special`, as read_settings has it, leaves one to the readers above.
template <class Part, class Special>
void read_parts(JsonObject& object, Part& part, Surroundings& around, const Special& special) {
    const auto read_one = [&](JsonObject one, auto& value) {
        if constexpr (requires { read_part(one, value, around); }) {
            read_part(std::move(one), value, around);
        } else {
            read_parts(one, value, around, [](const auto&, const auto&) { return false; });
            one.finish();
        }
    };
    read_settings(object, part, [&](const auto& row, auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        const Key key{row.name, row.meaning};
        if (special(row, member))
            return true;
        if constexpr (std::same_as<Member, std::optional<std::size_t>>)
            member = object.name(key, around.paths, "paths");
        else if constexpr (windrow::detail::k_is_list<Member>)
            read_items(object, key, row.range, [&](JsonObject item) { read_one(std::move(item), member.emplace_back()); });
        else if constexpr (windrow::detail::k_is_variant<Member>)
            read_kind(object.object(key), member, read_one);
        else if constexpr (HasSettings<Member>) {
            if (*row.name == '\0')
                return false;
            read_one(object.object(key), member);
        } else
            return false;
        return true;
    });
}
template <class Part>
void read_parts(JsonObject& object, Part& part, Surroundings& around) {
    read_parts(object, part, around, [](const auto&, const auto&) { return false; });
}

} // namespace windrow::vegetation::program
