// What a scene file says of the picture, in memory: one file has the air, for `windrow run`, and below its key `picture` the eye,
// the light, the ground and the plants, for a renderer.
//
//     auto meadow = program::read_picture_scene("meadow.json");
//     if (!meadow)
//         return std::fprintf(stderr, "%s\n", meadow.error().c_str()), 2;       // every fault, a line each
//     windrow::scene::SceneMotion motion(meadow->air);                           // what moves in the air
//     const render::Camera eye = program::camera_at(*meadow, time);
//
// Every key with its unit, default and range: examples/scenes/scene.schema.json, which a test holds to the reader.
#pragma once

#include "coupling/ground_config.h"
#include "fluid/input_budget.h"
#include "scene/scene.h"
#include "vegetation/fur/lamps.h"
#include "vegetation/grass/grass_settings.h"
#include "vegetation/grass/height_map.h"
#include "vegetation/grass/mask_patterns.h"
#include "vegetation/grass/placement_mask.h"
#include "vegetation/program/body.h"
#include "vegetation/render/grass_layer.h"
#include "vegetation/render/scene.h"
#include "vegetation/trees/stand_settings.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace windrow::vegetation::program {

struct CameraSource {
    /// Where it stands, what it looks at and how. A path says where instead, if it has one.
    render::Camera lens{};
    std::optional<std::size_t> path{};        ///< that the position moves on: index in Scene::paths
    std::optional<std::size_t> target_path{}; ///< that the target moves on
    /// Heights of position and target, or of their paths, count from the ground below each. Default: from 0.
    bool above_ground = false;
};

/// Rolling ground by chance: the place noise of shaders/numerics in three octaves.
struct Hills {
    double height = 0.0;    ///< [m] from the lowest possible place to the highest, 0 (none) to 1e4
    double length = 80.0;   ///< [m] of the largest octave's cells, about half of what lies between two tops; 1 to 1e5
    std::uint32_t seed = 0; ///< others for another number; of 64 kinds

    /// [m] At a place from the ground's corner, 0 to `height`.
    [[nodiscard]] float at(glm::vec2 place) const;
};

struct Ground {
    std::string file{};                   ///< PGM of heights beside the scene; empty: level at `low`
    Hills hills{};                        ///< upon either
    double low = 0.0;                     ///< [m] height that black stands for
    double high = 100.0;                  ///< [m] and white; above low
    glm::dvec3 corner{-50.0, 0.0, -50.0}; ///< [m] place of the first sample; y is added to all heights
    glm::dvec2 extent{100.0};             ///< [m] along x and z, 0.01 to 1e5; a file's pixels must come out square
    /// What they make: heights above corner.y. Always there in a scene that was read.
    std::optional<grass::HeightMap> heights{};

    /// [m] In the world, on the triangles that are drawn; beyond the rim that of the rim.
    [[nodiscard]] double height(double x, double z) const;
};

struct Stroke {
    bool erases = false;
    grass::Brush brush{};
};

/// Where a layer grows: a picture or an even alpha, less bare patches and a path, then strokes in their order.
struct MaskSource {
    std::string file{};        ///< PGM of alpha beside the scene, stretched over the ground; empty: even
    glm::ivec2 corners{257};   ///< samples along x and z without a file, 2 to 4097
    float even = 1.0f;         ///< alpha before the rest, without a file
    grass::BarePatches bare{}; ///< with the layer's seed
    grass::FootPath path{};
    std::vector<Stroke> strokes{};
    /// What they make. Always there in a scene that was read.
    std::optional<grass::PlacementMask> mask{};
};

struct GrassLayer {
    std::string name = "grass";
    std::string plant = "grass";     ///< the class that stiffness and length begin with: a function of coupling/plant_classes.h
    grass::GrassSettings settings{}; ///< with the class's stalk, and what the file changes of it
    render::PlantLook look{};
    int most_blades = render::GrassLayerSettings{}.most_blades; ///< as there
    int shadows = render::GrassLayerSettings{}.shadows;
    MaskSource mask{};
};

/// A time at which a walker's feet leave the ground, as a jump does: on a parabola.
struct Jump {
    double from = 0.0, until = 0.0; ///< [s]
    float height = 1.0f;            ///< [m] of the feet in its middle, 0 to 100
};

/// Who presses the grass down.
struct Walker {
    std::size_t path = 0; ///< index in Scene::paths; x and z count
    float radius = windrow::GroundWalker{}.radius;
    float weight = windrow::GroundWalker{}.weight;
    std::vector<Jump> airborne{};
    bool figure = true; ///< someone in a cloak is drawn there

    /// [m] Height of the feet above the ground.
    [[nodiscard]] float feet(double time) const;
};

/// A fan that is drawn; what it blows is a motor of the scene's.
struct Fan {
    glm::dvec3 position{0.0};            ///< [m] of its hub; its foot stands on the ground below
    glm::dvec3 direction{1.0, 0.0, 0.0}; ///< where it blows
    double radius = 0.8;                 ///< [m] 0.05 to 50
    double turns_hz = 3.0;               ///< turns a second, 0 to 100
};

/// A tree at a place of its own; it stands on the ground there.
struct StandPlace {
    glm::dvec2 at{0.0};   ///< [m] x and z
    float size = 1.0f;    ///< factor on all its lengths, 0.05 to 10
    float yaw_deg = 0.0f; ///< turn about the vertical, -360 to 360
};

/// Trees of one kind (vegetation/trees/stand_settings.h).
struct TreeStand {
    std::string kind = "oak"; ///< of trees::preset_names
    std::uint32_t seed = 1;   ///< another number, other trees of the kind
    int variants = 2;         ///< different trees, 1 to 8: places take them in turn
    bool springs = true;      ///< trunks, limbs and twigs swing
    std::vector<StandPlace> places{};
    trees::TreeScatter scatter{}; ///< and more by chance
};

struct Picture {
    glm::ivec2 size{640, 360};                 ///< [px] 16 to 8192
    std::optional<double> frames_per_second{}; ///< default: the scene's
    double settle = 2.0;                       ///< [s] of wind before the first picture, so that gusts have come in; 0 to 3600
    CameraSource camera{};
    render::Sun sun{};
    render::Fog fog{};
    render::Clouds clouds{};
    Ground ground{};
    std::vector<GrassLayer> grass{}; ///< the ground has the look of the first, where that grows; elsewhere it is bare
    std::vector<TreeStand> trees{};
    std::vector<Walker> walkers{};
    std::vector<Fan> fans{};
    std::optional<windrow::GroundConfig> ground_memory{}; ///< none: walkers and wind leave no trace
    std::vector<Body> bodies{};                           ///< things in coats of shells
    std::vector<fur::Lamp> lamps{};                       ///< that shine on them
    windrow::Sampling sampling{};
};

struct PictureScene {
    windrow::scene::Scene air;
    Picture picture;
    /// What is left for meshes and maps, which are read when bodies are dressed.
    windrow::detail::InputBudget inputs{};

    /// Pictures a second.
    [[nodiscard]] double frames_per_second() const { return picture.frames_per_second.value_or(air.frames_per_second); }
    /// Pictures from the first, at time 0, to the last.
    [[nodiscard]] std::int64_t frame_count() const;
};

/// The camera at a time [s].
[[nodiscard]] render::Camera camera_at(const PictureScene& scene, double time);
/// A walker in a step from `start` to `end` [s].
[[nodiscard]] windrow::GroundWalker walker_at(const PictureScene& scene, const Walker& walker, double start, double end);

} // namespace windrow::vegetation::program
