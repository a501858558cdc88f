#include "vegetation/program/skeleton_reader.h"

#include "vegetation/program/body_fields.h"
#include "vegetation/program/field_reader.h"
#include "vegetation/program/field_writer.h"

namespace windrow::vegetation::program {
namespace {

constexpr std::size_t k_most_swings = 4;

/// `before`: the bones that may be its parent.
fur::Bone read_bone(JsonObject object, const std::vector<fur::Bone>& before) {
    fur::Bone bone;
    bone.name = object.text({"name", "For others to name as their parent."}, "");
    const std::string parent = object.text({"parent", "Name of a bone before it. Default: none."}, "");
    for (std::size_t n = 0; n < before.size(); ++n)
        if (before[n].name == parent)
            bone.parent = static_cast<int>(n);
    if (bone.parent < 0 && !parent.empty())
        object.refuse("parent", "is \"" + parent + "\", and no bone before it has that name: list parents first.");
    FieldReader fields(object);
    list_fields(fields, bone);
    each(object, {"swings", "Turns to and fro about its head, the first applied last."}, k_most_swings, [&](JsonObject item) {
        fur::Swing swing;
        read_part(std::move(item), swing);
        bone.swings.push_back(swing);
    });
    object.finish();
    return bone;
}

} // namespace

BodySkeleton read_skeleton(JsonObject object) {
    BodySkeleton skeleton;
    const std::size_t faults_before = object.log().faults();
    FieldReader fields(object);
    list_fields(fields, skeleton);
    each(object, {"bones", "The scene's own, parents first."}, fur::k_most_bones,
         [&](JsonObject item) { skeleton.bones.push_back(read_bone(std::move(item), skeleton.bones)); });
    object.finish();
    if (object.log().faults() != faults_before)
        return skeleton;
    const bool own = skeleton.kind == SkeletonKind::own;
    if (own && skeleton.bones.empty())
        object.refuse("bones", "has none, and \"kind\" is \"own\": list them, parents first, or name another kind.");
    else if (!own && !skeleton.bones.empty())
        object.refuse("bones", "is given beside a \"kind\" that has its own: give \"own\", or remove them.");
    return skeleton;
}

json write_skeleton(const BodySkeleton& skeleton) {
    json object = write_part(skeleton);
    object["bones"] = json::array();
    for (const fur::Bone& bone : skeleton.bones) {
        json one = write_part(bone);
        one["name"] = bone.name;
        if (bone.parent >= 0)
            one["parent"] = skeleton.bones[static_cast<std::size_t>(bone.parent)].name;
        one["swings"] = json::array();
        for (const fur::Swing& swing : bone.swings)
            one["swings"].push_back(write_part(swing));
        object["bones"].push_back(std::move(one));
    }
    return object;
}

} // namespace windrow::vegetation::program
