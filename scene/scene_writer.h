// Writes a wind as a scene file: its settings, motors, obstacles and drag as they are now, from time 0 on.
//
//     auto text = windrow::scene::write_scene(wind, {.duration = 10.0});
//     if (text) { ... }                        // `windrow run` plays it, and read_scene_text reads it
//
// What `windrow run` makes of it is the wind that was created with these settings and never stepped, to the bit: not the air of
// this moment, which Wind::save keeps. Bodies that are turned are so to rounding, since files have angles, and so are directions of
// motors that no unit vector of floats has. With winds around the wind, their boxes may stand one of their cells elsewhere.
#pragma once

#include "fluid/result.h"
#include "fluid/wind_control.h"

#include <filesystem>
#include <string>

namespace windrow::scene {

struct WrittenScene {
    double duration = 10.0;          ///< [s] above 0
    double tick_hz = 60.0;           ///< steps a second at least
    double frames_per_second = 10.0; ///< of what a run keeps
};

/// JSON. Rejects what a scene file cannot hold or names by a file of its own: wakes, which have a path; meshes, voxel grids, grounds and
/// maps of roughness. The winds around the wind are written as `air.outer`. A scene has one config for all, with boxes and ticks of their own, one
/// point that all are around, and puts motors, obstacles and drag into all levels: rejects outer winds that are otherwise. What is in
/// the wind alone and wider than a cell of an outer wind is played in that too.
/// `file` begins the sentences about values that a scene may not have.
[[nodiscard]] Result<std::string> write_scene(const WindControl& wind, const WrittenScene& times,
                                              const std::filesystem::path& file = "scene");

} // namespace windrow::scene
