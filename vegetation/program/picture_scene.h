// What a scene file says of the picture, in memory: one file has the air, for `windrow run`, and below its key `picture` the eye,
// the light, the ground and the plants, for a renderer.
//
//     auto meadow = program::read_picture_scene("meadow.json");
//     if (!meadow)
//         return std::fprintf(stderr, "%s\n", meadow.error().c_str()), 2;       // every fault, a line each
//     windrow::scene::SceneAir air(meadow->air);                                 // the air, as `windrow run` plays it
//     const render::Camera eye = program::camera_at(*meadow, time);
//
// Every key with its unit, default and range: examples/scenes/scene.schema.json, which a test holds to the reader.
#pragma once

#include "coupling/ground_config.h"
#include "fluid/files/input_budget.h"
#include "scene/ground_source.h"
#include "scene/scene.h"
#include "scene/stand_source.h"
#include "scene/walker.h"
#include "vegetation/grass/grass_settings.h"
#include "vegetation/grass/mask_patterns.h"
#include "vegetation/grass/placement_mask.h"
#include "vegetation/program/body.h"
#include "vegetation/render/grass_layer.h"
#include "vegetation/render/obstacle_solid.h"
#include "vegetation/render/renderer.h"
#include "vegetation/render/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace windrow::vegetation::program {

using windrow::scene::GroundSource, windrow::scene::StandSource, windrow::scene::Walker;

struct CameraSource {
    render::Camera lens{};
    std::optional<std::size_t> path{};
    std::optional<std::size_t> target_path{};
    bool above_ground = false;
    float shutter_deg = 0.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("", &CameraSource::lens, "Lens of the camera."),
            Setting("shutter_deg", &CameraSource::shutter_deg, render::k_shutter_range, render::k_shutter_meaning),
            Setting("path", &CameraSource::path, "Name of the path that it moves along instead of its position."),
            Setting("target_path", &CameraSource::target_path, "Name of the path that the target moves along instead."),
            Setting("above_ground", &CameraSource::above_ground,
                    "Whether heights of position and target, or of their paths, count from the ground below each."),
        };
    }
};

struct Stroke {
    bool erases = false;
    grass::Brush brush{};
};

/// Where a layer grows: a picture or an even alpha, less bare patches and a path, then strokes in their order.
struct MaskSource {
    std::string file{};
    glm::ivec2 corners{257};
    float even = 1.0f;
    grass::BarePatches bare{};
    grass::FootPath path{};
    std::vector<Stroke> strokes{};
    std::optional<grass::PlacementMask> mask{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("file", &MaskSource::file,
                    "Binary PGM of 8 or 16 bits in the scene's folder, named relative to it, stretched over the ground. Default: "
                    "an even alpha."),
            Setting("corners", &MaskSource::corners, {2.0, 4097.0}, "Samples along x and z, without a file."),
            Setting("even", &MaskSource::even, k_fraction_range, "Alpha before the rest, without a file."),
            Setting("", &MaskSource::bare, "With the layer's seed."),
            Setting("path", &MaskSource::path, "A path on which it does not grow, winding along z."),
            Setting("strokes", &MaskSource::strokes, "Brushes upon it, in their order.", k_not_stored),
            Setting("mask", &MaskSource::mask, "The resulting mask. Always there in a scene that was read.", k_not_stored),
        };
    }
};

struct GrassSource {
    std::string name = "grass";
    std::string plant = "grass";
    render::GrassLayerSettings drawn{};
    MaskSource mask{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("name", &GrassSource::name, "For people."),
            Setting("class", &GrassSource::plant,
                    "The class of plant that length and stalk begin with: a function of coupling/plant_classes.h."),
            Setting("", &GrassSource::drawn, "With the class's stalk, and what the file changes of it."),
            Setting("mask", &GrassSource::mask,
                    "Placement of the layer: alpha 0 is no blade, between 0 and 1 blades are as much smaller."),
        };
    }
};

/// A fan that is drawn; what it blows is a motor of the scene's.
struct Fan {
    glm::dvec3 position{0.0};
    glm::dvec3 direction{1.0, 0.0, 0.0};
    double radius = 0.8;
    double turns_hz = 3.0;

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &Fan::position, render::k_place_range, "Position of the hub; its foot is on the ground below."),
            Setting("direction", &Fan::direction, {-1e9, 1e9}, "Direction of its wind; needs a horizontal component."),
            Setting("radius", &Fan::radius, {0.05, 50.0, "m"}, "Of its blades."),
            Setting("turns_hz", &Fan::turns_hz, {0.0, 100.0, "Hz"}, "Turns a second."),
        };
    }
};

struct Picture {
    glm::ivec2 size{640, 360};
    std::optional<double> frames_per_second{};
    double warm_up = 2.0;
    CameraSource camera{};
    render::Quality quality{};
    render::Sun sun{};
    render::Fog fog{};
    render::Clouds clouds{};
    GroundSource ground{};
    std::vector<GrassSource> grass{};
    std::vector<StandSource> trees{};
    std::vector<Walker> walkers{};
    std::vector<Fan> fans{};
    std::optional<windrow::GroundConfig> ground_memory{};
    std::vector<Body> bodies{};
    std::vector<render::ObstacleLook> obstacles{};
    std::vector<fur::Lamp> lamps{};
    windrow::Sampling sampling{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("size", &Picture::size, {16.0, 8192.0, "px"}, "Width and height."),
            Setting("frames_per_second", &Picture::frames_per_second, {0.001, 1e4, "1/s"}, "Pictures. Default: the scene's."),
            Setting("warm_up", &Picture::warm_up, {0.0, 3600.0, "s"},
                    "Of wind before the first picture, so that gusts have come in."),
            Setting("camera", &Picture::camera, "The eye."),
            Setting("quality", &Picture::quality, "What is worked out once for several points of the picture."),
            Setting("sun", &Picture::sun, "The sun and the air that it shines through."),
            Setting("fog", &Picture::fog, "Fog that hides distant objects."),
            Setting("clouds", &Picture::clouds, "A level sheet of clouds that drifts and shades the ground."),
            Setting("ground", &Picture::ground, "The ground. Default: level, 100 m x 100 m about the origin."),
            Setting("grass", &Picture::grass, {0.0, 16.0},
                    "Layers of blades. The ground has the look of the first, where that grows; elsewhere it is bare."),
            Setting("trees", &Picture::trees, {0.0, 256.0}, "Stands of trees."),
            Setting("walkers", &Picture::walkers, {0.0, 256.0}, "Walkers that press the grass down; needs ground_memory."),
            Setting("fans", &Picture::fans, {0.0, 64.0}, "Fans that are drawn; what they blow is a motor of $.motors."),
            Setting("ground_memory", &Picture::ground_memory,
                    "A ground that remembers walkers and wind. Default: none; {} for its defaults."),
            Setting("bodies", &Picture::bodies, {0.0, 64.0},
                    "Standing or moving bodies with coats of shells: fur, feathers, grass, spikes, clouds."),
            Setting("obstacles", &Picture::obstacles, {0.0, 256.0},
                    "Colours and windows of the obstacles of $.obstacles, by their names; without them plaster and timber."),
            Setting("lamps", &Picture::lamps, {0.0, fur::k_max_lamps},
                    "Points of light beside the sun, which shine on coats and cast no shadow."),
            Setting("sampling", &Picture::sampling, "Sampling of the wind by plants."),
        };
    }
};

struct PictureScene {
    windrow::scene::Scene air;
    Picture picture;
    /// What is left for meshes and maps, which are read when bodies are furred.
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
