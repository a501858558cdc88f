// Bodies that stand or move in a scene, their skeletons and their coats.
#include "scene/scene_parts.h"
#include "vegetation/program/part_reader.h"

namespace windrow::vegetation::program {
namespace {

/// `before`: the bones that may be its parent.
void read_bone(JsonObject object, fur::Bone& bone, std::span<const fur::Bone> before) {
    read_settings(object, bone, [](const auto&, const auto&) { return false; });
    const std::string parent = object.text({"parent", "Name of a bone before it. Default: none."}, "");
    for (std::size_t n = 0; n < before.size(); ++n)
        if (before[n].name == parent)
            bone.parent = static_cast<int>(n);
    if (bone.parent < 0 && !parent.empty())
        object.reject("parent", "is \"" + parent + "\", and no bone before it has that name: list parents first.");
    object.finish();
}

} // namespace

std::optional<std::filesystem::path> read_file(JsonObject& object, const Key& key, std::string& name,
                                               const Surroundings& around) {
    auto file = windrow::scene::file_beside(object, key, around.folder);
    if (file)
        name = object.value()[key.name].get<std::string>();
    return file;
}

void read_part(JsonObject object, MeshSource& mesh, Surroundings& around) {
    read_parts(object, mesh, around, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<decltype(member), std::string&>)
            if (!read_file(object, {row.name, row.meaning}, member, around) && !object.value().contains(row.name))
                object.reject(row.name, "is missing: name a mesh in the scene's folder, OBJ, glTF or GLB.");
        return std::same_as<decltype(member), std::string&>;
    });
    object.finish();
}

void read_part(JsonObject object, BodySkeleton& skeleton, Surroundings& around) {
    const std::size_t faults_before = object.log().faults();
    read_parts(object, skeleton, around, [&](const auto& row, auto& member) {
        if constexpr (windrow::detail::k_is_list<std::remove_cvref_t<decltype(member)>>) {
            read_items(object, {row.name, row.meaning}, row.range, [&](JsonObject item) {
                fur::Bone bone;
                read_bone(std::move(item), bone, member);
                member.push_back(std::move(bone));
            });
            return true;
        }
        return false;
    });
    object.finish();
    if (object.log().faults() != faults_before)
        return;
    const bool own = skeleton.kind == SkeletonKind::own;
    if (own && skeleton.bones.empty())
        object.reject("bones", "has none, and \"kind\" is \"own\": list them, parents first, or name another kind.");
    else if (!own && !skeleton.bones.empty())
        object.reject("bones", "is given beside a \"kind\" that has its own: give \"own\", or remove them.");
}

void read_part(JsonObject object, windrow::ShellSettings& layers, Surroundings& around) {
    read_parts(object, layers, around, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<decltype(member), windrow::Drag&>)
            read_stalk(object.object({row.name, row.meaning}), member);
        return std::same_as<decltype(member), windrow::Drag&>;
    });
    object.finish();
}

void read_part(JsonObject object, fur::CoatMaps& maps, Surroundings& around) {
    read_parts(object, maps, around, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<decltype(member), std::string&>)
            read_file(object, {row.name, row.meaning}, member, around);
        return std::same_as<decltype(member), std::string&>;
    });
    object.finish();
}

void read_part(JsonObject object, BodyCoat& coat, Surroundings& around) {
    const auto said = [&](const char* part, const char* key) {
        const auto found = object.value().find(part);
        return found != object.value().end() && found->is_object() && found->contains(key);
    };
    coat.said = {.shells = said("layers", "shells"),
                 .length = said("layers", "length"),
                 .thickness = said("strands", "thickness"),
                 .density = said("strands", "density")};
    const std::size_t faults_before = object.log().faults();
    read_parts(object, coat, around);
    object.finish();
    if (object.log().faults() == faults_before)
        check_read(object, coat);
}

} // namespace windrow::vegetation::program
