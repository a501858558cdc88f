// A scene: the air, what moves in it and acts on it, and what is kept of a run. What a scene file says, in memory.
#pragma once

#include "fluid/drag_deposit.h"
#include "fluid/motors.h"
#include "fluid/obstacles.h"
#include "fluid/wind.h"
#include "scene/carried.h"
#include "scene/frame_times.h"
#include "scene/motion_path.h"
#include "scene/stand_source.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace windrow {
namespace scene {
enum class VdbPrecision : std::uint8_t { full, half };
enum class VdbUp : std::uint8_t { y, z };
enum class VdbFormat : std::uint8_t { openvdb, nanovdb };
enum class FlowMarks : std::uint8_t { arrows, streamlines };
} // namespace scene
template <>
inline constexpr std::array<const char*, 2> k_words<scene::VdbPrecision>{"full", "half"};
template <>
inline constexpr std::array<const char*, 2> k_words<scene::VdbUp>{"y", "z"};
template <>
inline constexpr std::array<const char*, 2> k_words<scene::VdbFormat>{"openvdb", "nanovdb"};
template <>
inline constexpr std::array<const char*, 2> k_words<scene::FlowMarks>{"arrows", "streamlines"};
} // namespace windrow

namespace windrow::scene {

/// A wind around the box of a scene, or around the level inside it: of its own cells and ticks, otherwise as that.
struct SceneLevel {
    glm::ivec3 cells{48, 16, 48};
    float cell_size = 2.0f;
    std::optional<Rows> rows{};
    float blend_width = 2.0f;
    Ticks ticks{.hz = 10.0};

    static constexpr auto settings() {
        return std::tuple{
            Setting("cells", &SceneLevel::cells, Box::k_cells_range,
                    "Cells along x, y, z. The box must hold the box inside it, also where that follows. Three times as wide is "
                    "good."),
            Setting("cell_size", &SceneLevel::cell_size, Box::k_cell_size_range,
                    "Edge of a cell. Two to three times that of the level inside: what comes in should be five of these wide. "
                    "Motors and obstacles that are not wider than a cell are not in this level."),
            Setting("rows", &SceneLevel::rows, "Rows of cells of unequal thickness, as air.rows. Default none."),
            Setting("blend_width", &SceneLevel::blend_width, {.min = 0.0, .max = 64.0, .unit = "cells", .zero = "none"},
                    "Width over which its wind fades to the one around it, as air.blend_width."),
            Setting("ticks", &SceneLevel::ticks,
                    "Its own ticks: a third of the rate inside is good. Its wind is read up to a tick late."),
        };
    }
};

/// A motor and when it acts.
struct SceneMotor {
    std::string name;
    /// As it stands when it begins to act. Where it has a path, the path says where.
    Motor motor;
    std::optional<std::size_t> path; ///< index in Scene::paths
    double from = 0.0;               ///< [s] acts in ticks whose middle is in [from, until)
    double until = std::numeric_limits<double>::infinity();
};

/// An obstacle and when it is there.
struct SceneObstacle {
    std::string name = "obstacle";
    /// As it stands when it comes. Where it has a path, the path says where; the same for how it is turned.
    Obstacle obstacle;
    std::optional<std::size_t> path;      ///< index in Scene::paths
    std::optional<std::size_t> turn_path; ///< the same; its x, y, z are the angles of orientation_of
    glm::dvec3 rpm{0.0};                  ///< [1/min] turns about its own axes, from `obstacle.orientation` at 0 s
    glm::dvec3 pivot{0.0};                ///< [m] along its own axes: its point that the position is that of
    double from = 0.0;                    ///< [s] in the air in ticks whose middle is in [from, until)
    double until = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool moves() const { return path || turn_path || rpm != glm::dvec3(0.0); }
};

/// Orientation from yaw, pitch and roll [degrees]: first rolled about its own z axis, then pitched about x, then yawed about y, up.
[[nodiscard]] glm::quat orientation_of(glm::dvec3 turn_deg);
/// The angles of an orientation.
[[nodiscard]] glm::dvec3 turn_of(const glm::quat& orientation);

struct ScenePath {
    std::string name;
    MotionPath path;
};

struct PicturesSetting {
    double slice_height = 1.0;
    bool above_ground = false;
    double slice_z = 0.0;
    float speed_scale = 10.0f;
    int width = 1600;
    FlowMarks flow = FlowMarks::arrows;

    static constexpr auto settings() {
        return std::tuple{
            Setting("slice_height", &PicturesSetting::slice_height, {-MotionPath::k_farthest, MotionPath::k_farthest, "m"},
                    "Height of the horizontal slice above the floor, or above the followed point in a box without a floor."),
            Setting("above_ground", &PicturesSetting::above_ground,
                    "Whether the horizontal slice follows the ground, slice_height above it, with lines of equal height; without "
                    "one, it is above the box's low face."),
            Setting("slice_z", &PicturesSetting::slice_z, {-MotionPath::k_farthest, MotionPath::k_farthest, "m"},
                    "Place of the upright slice along z from the followed point, or from the box's centre."),
            Setting("speed_scale", &PicturesSetting::speed_scale, {0.001, 1e4, "m/s"},
                    "Speed at the top of the colour bar, the same for all frames."),
            Setting("width", &PicturesSetting::width, {640.0, 8000.0, "pixels"},
                    "Width of a picture; the height follows from the box's shape. An odd one loses a pixel."),
            Setting(
                "flow", &PicturesSetting::flow,
                "Marks of the flow on both slices. arrows: the velocity on a lattice that is fixed to the world. streamlines: "
                "lines along it, evenly spaced, that end at bodies."),
        };
    }
};

/// Grids of a VDB file beside the velocity.
struct VdbGrids {
    bool speed = false;
    bool vorticity = false;
    bool divergence = false;
    bool pressure = false;
    bool density = false;

    static constexpr auto settings() {
        return std::tuple{
            Setting("speed", &VdbGrids::speed, "Speed [m/s], a scalar that volume shaders draw."),
            Setting("vorticity", &VdbGrids::vorticity, "Curl of the velocity [1/s], a vector."),
            Setting("divergence", &VdbGrids::divergence,
                    "Divergence of the solver's cells [1/s], as its projection sees it: what that leaves, and volume sources."),
            Setting("pressure", &VdbGrids::pressure,
                    "Pressure over the density of air [m^2/s^2], relative to that outside of the box. On the CPU alone."),
            Setting("density", &VdbGrids::density, "Density of smoke, 0 to 1, that the wind carries; needs smoke."),
        };
    }
    [[nodiscard]] bool any() const { return speed || vorticity || divergence || pressure || density; }
};

/// Box of the world that VDB files cover.
struct VdbBox {
    glm::dvec3 centre{0.0};
    glm::vec3 size{32.0f, 16.0f, 32.0f};

    static constexpr auto settings() {
        return std::tuple{
            Setting("centre", &VdbBox::centre, k_world_range, "Its middle."),
            Setting("size", &VdbBox::size, Range{.min = 0.0, .max = 1e6, .unit = "m", .above_min = true}, "Its edges."),
        };
    }
};

/// What windrow::vdb::Options and FilmSettings take; kept apart so that scenes are read, and checked, without OpenVDB too.
struct VdbSetting {
    std::string name = "vel";
    bool three_scalars = false;
    VdbPrecision precision = VdbPrecision::full;
    VdbUp up = VdbUp::y;
    VdbFormat format = VdbFormat::openvdb;
    VdbGrids grids{};
    double margin = 0.0;
    std::optional<VdbBox> box{};
    float voxel_size = 0.0f;

    /// Whether a file holds more than the cells of the air.
    [[nodiscard]] bool holds_more() const { return box || margin > 0.0 || voxel_size > 0.0f || grids.any(); }

    static constexpr auto settings() {
        return std::tuple{
            Setting("name", &VdbSetting::name, "Name of the grid. Blender and Houdini expect vel."),
            Setting("three_scalars", &VdbSetting::three_scalars,
                    "Three grids name.x, name.y, name.z instead of one grid of vectors."),
            Setting("precision", &VdbSetting::precision, "full: 32 bits, the solver's values. half: 16 bits, half the disk."),
            Setting("up", &VdbSetting::up, "The axis that points up. y: as in the scene and in Houdini. z: as in Blender."),
            Setting("format", &VdbSetting::format, "openvdb: .vdb. nanovdb: .nvdb, 32 bits and not compressed."),
            Setting("grids", &VdbSetting::grids, "Grids beside the velocity. Default: none."),
            Setting("margin", &VdbSetting::margin, {0.0, 1e5, "m"},
                    "How far a file reaches beyond the box of air, on each side without a wall below. There it holds the ambient "
                    "wind at each point. With 0, and without box, voxel_size and grids, it holds the cells to the bit."),
            Setting("box", &VdbSetting::box,
                    "Box of the world that a file covers, wherever the box of air is. Default: by margin."),
            Setting("voxel_size", &VdbSetting::voxel_size, {.min = 0.0, .max = 1e6, .unit = "m", .zero = "that of the cells"},
                    "Edge of a voxel. Smaller ones follow a log profile near the ground, larger ones make a wide margin cheap."),
        };
    }
};

/// A source of smoke, which the wind carries and which does not act on it.
struct SceneSmoke {
    glm::dvec3 position{0.0};        ///< [m] where it has no path
    std::optional<std::size_t> path; ///< index in Scene::paths
    float radius = 1.0f;             ///< [m] density is 1 within it
    double from = 0.0;               ///< [s] at the ends of steps in [from, until)
    double until = std::numeric_limits<double>::infinity();
};

struct Scene {
    std::filesystem::path file; ///< where it was read, for sentences
    std::string name;
    std::string description;
    double duration = 10.0; ///< [s]
    double tick_hz = 60.0;  ///< steps a second at least, see FrameTimes
    double frames_per_second = 10.0;
    Config air; ///< `centre` follows `follow` unless the scene gives one
    /// Winds around it, from the nearest to the outermost; `air` has the ambient wind of all (scene_levels.h).
    std::vector<SceneLevel> outer;
    std::vector<ScenePath> paths;
    /// What the box follows: nothing, a point [m], or a path by its index.
    std::variant<std::monostate, glm::dvec3, std::size_t> follow;
    /// [m] Height of the ground, or a path by its index whose height it takes. Only with a wall at y_low.
    std::variant<double, std::size_t> floor = 0.0;
    std::vector<SceneMotor> motors;
    std::vector<SceneObstacle> obstacles;
    std::vector<DragDeposit> drag; ///< from the start on
    /// Trees of the picture that slow the air, from the start on (picture_air.h).
    std::vector<PlantedStand> planted;
    /// What the picture moves and what carries the air along (picture_air.h).
    std::vector<Carried> carried;
    std::vector<SceneSmoke> smoke;
    PicturesSetting pictures;
    VdbSetting vdb;
    /// What the reader could not use and what the air lacks therefore, a sentence each.
    std::vector<std::string> warnings;

    [[nodiscard]] bool has_floor() const { return air.boundaries.y_low.solid(); }
    /// [m] What the box follows at a time; the centre where it follows nothing.
    [[nodiscard]] glm::dvec3 followed_point(double time) const;
    /// [m] Height of the floor at a time.
    [[nodiscard]] double floor_height(double time) const;

    /// Frames of the whole scene: frame i is the air at i / frames_per_second; the first is at 0, before any step.
    [[nodiscard]] FrameTimes frame_times() const { return {0.0, frames_per_second, tick_hz}; }
    [[nodiscard]] std::int64_t frame_count() const { return frame_times().frames_until(duration); }
};

/// Most frames and steps of one run; more is an accident with a unit, and would fill any disk.
inline constexpr std::int64_t k_max_frames = 100'000;
inline constexpr std::int64_t k_max_ticks = 10'000'000;

} // namespace windrow::scene
