// Bodies that stand or move in a scene and wear coats of shells: what the file says of them, in memory.
//
//     for (const Body& body : scene.picture.bodies)
//         const windrow::Pose pose = pose_of(scene, body, time);
#pragma once

#include "coupling/cascade.h"
#include "scene/body_motion.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/fur/beast.h"
#include "vegetation/fur/coat_settings.h"
#include "vegetation/fur/horse_skeleton.h"
#include "vegetation/fur/shapes.h"
#include "vegetation/fur/skeleton.h"
#include "vegetation/render/scene.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace windrow::vegetation::program {

using windrow::scene::BodyMotion, windrow::scene::BodyPlace;

struct PictureScene;

/// A mesh beside the scene: OBJ, glTF or GLB. It is read when the scene is drawn, not when the scene is read.
struct MeshSource {
    static constexpr const char* k_name = "file";
    static constexpr const char* k_meaning =
        "A mesh beside the scene: OBJ with its mtl, glTF or GLB. It is read when the scene is drawn. A coat whose material "
        "has a fur line in the mtl has its shells, length, thickness and density where the scene names none.";
    std::string name{};
    fur::MeshLoad load{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("name", &MeshSource::name, "Relative to the scene's folder, and in it."),
            Setting("", &MeshSource::load, "Options of the reader."),
        };
    }
};

using BodyMesh = std::variant<MeshSource, fur::Sheet, fur::GlobeSphere, fur::CubeSphere, fur::Wing, fur::Beast>;

enum class SkeletonKind : std::uint8_t { none, beast, horse, own };

struct BodySkeleton {
    SkeletonKind kind = SkeletonKind::none;
    fur::BeastGait gait = fur::BeastGait::walk;
    double pace = 1.0;
    double phase = 0.0;
    std::vector<fur::Bone> bones{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("kind", &BodySkeleton::kind, "Whose: none, those of the beast or of the horse, or the scene's own."),
            Setting("gait", &BodySkeleton::gait, "Of the beast; 0.8 strides a second at a pace of 1."),
            Setting("pace", &BodySkeleton::pace, {0.0, 10.0}, "Speed factor of the motion: 1 as made, 0 keeps the first pose."),
            Setting("phase", &BodySkeleton::phase, {0.0, 1e3, "s"}, "By which the motion is ahead."),
            Setting("bones", &BodySkeleton::bones, {0.0, fur::k_max_bones}, "The scene's own, parents first."),
        };
    }
};

/// Which fields of the coat the scene names. Those that it does not are the mesh's: its material's fur line.
struct FurSaid {
    bool shells = false, length = false, thickness = false, density = false;
};

struct BodyCoat {
    std::string material{};
    fur::CoatSettings coat{};
    FurSaid said{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("material", &BodyCoat::material, "Part of the mesh that wears it. Default: all of it."),
            Setting("", &BodyCoat::coat, "The coat."),
            Setting("said", &BodyCoat::said, "What of a fur line the scene says.", k_not_stored),
        };
    }
};

struct Body {
    std::string name = "body";
    BodyMesh mesh = fur::CubeSphere{};
    BodyPlace place{};
    BodyMotion motion{};
    BodySkeleton skeleton{};
    std::vector<BodyCoat> coats{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("name", &Body::name, "For sentences."),
            Setting("mesh", &Body::mesh, "Mesh of the body. Default: a cube_sphere."),
            Setting("place", &Body::place, "Its place, or the origin of its path."),
            Setting("motion", &Body::motion, "Motion of the body."),
            Setting("skeleton", &Body::skeleton, "Bones that move the mesh."),
            Setting("coats", &Body::coats, {0.0, 16.0}, "Its coats. A body without a coat is invisible."),
        };
    }
};

/// Where it is at a time [s].
[[nodiscard]] windrow::Pose pose_of(const PictureScene& scene, const Body& body, double time);

/// The coat that a part wears: the fur line of its material where the scene does not say otherwise. The line's height is already
/// scaled with the mesh.
[[nodiscard]] fur::CoatSettings settings_of(const BodyCoat& coat, const std::optional<fur::FurLine>& fur);

} // namespace windrow::vegetation::program

template <>
inline constexpr std::array<const char*, 4> windrow::k_words<windrow::vegetation::program::SkeletonKind>{"none", "beast", "horse",
                                                                                                         "own"};
