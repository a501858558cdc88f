// Bodies that stand or move in a scene and wear coats of shells: what the file says of them, in memory.
//
//     for (const Body& body : scene.picture.bodies)
//         const windrow::Pose pose = pose_of(scene, body, time);
#pragma once

#include "coupling/cascade.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/fur/beast.h"
#include "vegetation/fur/coat_settings.h"
#include "vegetation/fur/horse_skeleton.h"
#include "vegetation/fur/shapes.h"
#include "vegetation/fur/skeleton.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace windrow::vegetation::program {

struct PictureScene;

/// A mesh beside the scene: OBJ, glTF, GLB or 3DS. It is read when the scene is drawn, not when the scene is read.
struct MeshSource {
    std::string name{};             ///< of the file
    fur::MeshLoad load{};           ///< but for the turn
    float yaw_deg = 0.0f;           ///< turn about y, -360 to 360
    int most_triangles = 4'000'000; ///< files with more are simplified, 4 to 4,000,000
};

using BodyMesh = std::variant<MeshSource, fur::Sheet, fur::GlobeSphere, fur::CubeSphere, fur::Wing, fur::Beast>;

/// Where it is, or from where its path counts.
struct BodyPlace {
    glm::dvec3 position{0.0};  ///< [m] of the mesh's origin
    float yaw_deg = 0.0f;      ///< about the vertical, -360 to 360
    float pitch_deg = 0.0f;    ///< about its own x, then, -360 to 360
    float roll_deg = 0.0f;     ///< about its own z, then, -360 to 360
    float scale = 1.0f;        ///< 0.001 to 1000
    bool above_ground = false; ///< its height counts from the ground below
};

/// To and fro, by a sine.
struct Sway {
    glm::dvec3 by{0.0};    ///< [m] farthest from the middle
    double turn_deg = 0.0; ///< farthest turn about the vertical, 0 to 360
    double nod_deg = 0.0;  ///< farthest turn about its own x, 0 to 360
    double hz = 0.5;       ///< 0 to 100
    double phase = 0.0;    ///< [turns] 0 to 1
};

/// Jumps on a parabola, one after another, with a rest between.
struct Hop {
    double height = 0.0; ///< [m] 0 to 100; 0: none
    double hz = 1.0;     ///< jumps a second, above 0 to 100
    double rest = 0.3;   ///< share of the time on the ground, 0 to 0.95
};

struct BodyMotion {
    std::optional<std::size_t> path{}; ///< index in Scene::paths; the place counts from it
    bool faces = true;                 ///< its +x looks along the path
    double spin_hz = 0.0;              ///< turns a second about the vertical, -100 to 100
    Sway sway{};
    Hop hop{};
};

enum class SkeletonKind : std::uint8_t { none, beast, horse, own };

struct BodySkeleton {
    SkeletonKind kind = SkeletonKind::none;
    double pace = 1.0;              ///< how fast it moves: 1 as made, 0 stands in its first pose; 0 to 10
    double phase = 0.0;             ///< [s] by which it is ahead, 0 to 1000
    std::vector<fur::Bone> bones{}; ///< of kind `own`
};

/// Which fields of the coat the scene names. Those that it does not are the mesh's: its material's fur line.
struct FurSaid {
    bool shells = false, length = false, thickness = false, density = false;
};

struct BodyCoat {
    std::string material{}; ///< part of the mesh that wears it; empty: the whole mesh
    fur::CoatSettings settings{};
    FurSaid said{};
};

struct Body {
    std::string name = "body";
    BodyMesh mesh = fur::CubeSphere{};
    BodyPlace place{};
    BodyMotion motion{};
    BodySkeleton skeleton{};
    std::vector<BodyCoat> coats{};
};

/// Where it is at a time [s].
[[nodiscard]] windrow::Pose pose_of(const PictureScene& scene, const Body& body, double time);

/// The coat that a part wears: the fur line of its material where the scene does not say otherwise. The line's height is already
/// scaled with the mesh.
[[nodiscard]] fur::CoatSettings settings_of(const BodyCoat& coat, const std::optional<fur::FurLine>& fur);

} // namespace windrow::vegetation::program
