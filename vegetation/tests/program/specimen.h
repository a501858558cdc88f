// A picture whose every key says something else than its default, and the files that it names.
#pragma once

#include "vegetation/program/picture_reader.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace windrow::vegetation::program::test {

/// A folder of its own for a test's files, gone with the test.
class Folder {
  public:
    Folder() : path_(std::filesystem::path(testing::TempDir()) / ("windrow_" + name())) {
        std::filesystem::create_directories(path_);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const char* file) const { return path_ / file; }

    void write(const char* file, const std::string& bytes) const { std::ofstream(path_ / file, std::ios::binary) << bytes; }
    /// A PGM of 16 bits, row by row.
    void write_pgm(const char* file, int width, int height, const std::function<int(int, int)>& level) const {
        std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n65535\n";
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column) {
                bytes.push_back(static_cast<char>(level(column, row) >> 8));
                bytes.push_back(static_cast<char>(level(column, row) & 255));
            }
        write(file, bytes);
    }

  private:
    static std::string name() {
        const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
        return std::string(test->test_suite_name()) + "_" + test->name() + "_" + std::to_string(::getpid());
    }
    std::filesystem::path path_;
};

/// With the files that k_sample_values names: 9 x 5 heights that rise along x, and a mask.
inline void write_sample_files(const Folder& folder) {
    folder.write_pgm("hills.pgm", 9, 5, [](int column, int) { return column * 65535 / 8; });
    folder.write_pgm("paths.pgm", 4, 4, [](int, int row) { return row < 2 ? 65535 : 0; });
}

/// Two layers, so that a mask's file and its own keys both stand; two walkers, for the same reason; a body of each kind of mesh.
inline constexpr const char* k_sample_values = R"({
    "duration": 5,
    "paths": {"eye": {"points": [[0, 1, 1.5, 2], [4, 5, 1.5, 2]]}, "sight": {"points": [[0, 1, 1, -20]]}},
    "obstacles": [{"name": "house"}],
    "picture": {
        "size": [320, 200],
        "frames_per_second": 24.5,
        "warm_up": 3.25,
        "quality": {"sky_pixels": 3, "cloud_texels": 256, "cloud_noise_texels": 640, "ground_texels": 768, "light_bytes": 4},
        "camera": {"path": "eye", "target_path": "sight", "above_ground": true, "shutter_deg": 172.5, "view_deg": 52.5, "near": 0.2, "far": 900, "exposure": 0.72},
        "sun": {"elevation_deg": 31.5, "azimuth_deg": -120, "irradiance": 8.5, "haze": 0.1, "radius_deg": 0.3},
        "fog": {"density": 0.002, "fall": 0.03, "base": 12.5},
        "clouds": {"cover": 0.4, "height": 950, "size": 600, "depth": 2.5, "drift": [5, -3]},
        "ground": {"heights": "hills.pgm", "low": 10, "high": 30, "corner": [100, 1, -200], "extent": [80, 40], "in_air": true,
                   "hills": {"height": 2, "length": 25, "seed": 3}},
        "grass": [
            {"name": "wheat", "class": "wheat", "length": 0.7, "length_spread": 0.2, "width": 0.008, "tip_width": 0.3, "taper": 1.5,
             "along_wind": 0.6, "stiffness_spread": 0.25, "rest_bend": 0.2, "rest_bend_spread": 0.15, "rest_curve": 0.8, "view_bend": 0.1, "twist": 0.2,
             "density": 7.5, "jitter": 0.9, "seed": 4294967295, "chunk_cells": 64, "split_distance": 20, "cut_distance": 80,
             "morph_from": 0.5, "fade_from": 0.7, "shadow_distance": 30, "min_width": 0.001, "max_chunks": 200, "far_vertices": 5, "thin_from": 12, "thin_power": 1.2, "thin_widen": 0.6, "max_blades": 65536, "shadows": 2, "springs": false, "spring": {"frequency_hz": 1.5, "damping": 0.3}, "clump_size": 0.5,
             "clump_height": 0.3, "clump_lean": 0.4, "clump_fan": 0.2, "patch_size": 5, "patch_height": 0.25,
             "stalk": {"width": 0.009, "rigidity": 0.05, "drag_coefficient": 1.2, "air_density": 1.1, "vogel_exponent": -0.5,
                       "vogel_speed": 6, "max_bend": 1.4},
             "look": {"root": [0.03, 0.04, 0.02], "tip": [0.2, 0.18, 0.05], "dry": [0.22, 0.2, 0.1], "through": [0.1, 0.09, 0.02],
                      "variation": 0.25, "root_light": 0.4, "gloss": 30, "against_light": 2, "even_from": 60, "wave": 0.7,
                      "second": [0.1, 0.12, 0.06], "dryness": 0.7, "fold": 0.4, "midrib": 0.3, "soften": 0.45, "self_shade": 1.7,
                      "head": [0.3, 0.2, 0.15], "head_from": 0.7, "head_width": 0.02, "soil": [0.1, 0.08, 0.05]},
             "mask": {"corners": [33, 17], "even": 0.5, "bare": 0.3, "bare_size": 6, "path": {"width": 1.5, "at": 60}, "strokes": [
                 {"paint": {"centre": [20, 10], "radius": 8, "strength": 0.75, "hardness": 0.25}},
                 {"erase": {"centre": [40, 20], "radius": 4.5, "strength": 0.9, "hardness": 0.6}}]}},
            {"name": "reeds", "class": "reed", "mask": {"file": "paths.pgm"}}
        ],
        "trees": [{"kind": "birch", "seed": 9, "variants": 3, "springs": false, "slows_air": false, "flutter": {"frequency_hz": 5, "most": 0.4, "onset": 2}, "places": [{"at": [1, 2], "size": 1.2, "yaw_deg": 30}],
                   "scatter": {"count": 5, "low": [-20, -30], "high": [40, 50], "apart": 3, "groves": 0.75, "grove_length": 30,
                               "size_spread": 0.125, "seed": 4, "clear": [{"centre": [3, 4], "radius": 6}]}}],
        "walkers": [
            {"path": "eye", "radius": 0.4, "weight": 0.8, "figure": false, "wake": false, "airborne": [{"from": 1.5, "until": 2, "height": 0.6}]},
            {"path": "sight"}
        ],
        "fans": [{"position": [2, 1.5, -3], "direction": [0.5, 0.25, -1], "radius": 0.6, "turns_hz": 2.5}],
        "bodies": [
            {"name": "wolf",
             "mesh": {"file": {"name": "wolf.obj", "up": "z", "size": 1.5, "size_of": "height", "yaw_deg": 90, "max_triangles": 4000}},
             "place": {"position": [1, 2, -3], "yaw_deg": 10, "pitch_deg": -5, "roll_deg": 15, "scale": 1.25, "above_ground": true},
             "motion": {"path": "eye", "faces": false, "spin_hz": 0.25, "sway": {"by": [0.5, 0.25, -1], "turn_deg": 20, "nod_deg": 8, "hz": 1.5, "phase": 0.25},
                        "hop": {"height": 0.4, "hz": 2, "rest": 0.5}, "wake": false},
             "skeleton": {"kind": "own", "gait": "gallop", "pace": 1.5, "phase": 2, "bones": [
                 {"name": "hip", "head": [0, 1, 0.5], "tail": [0, 1, -0.5], "radius": 0.3, "sway": [0, 0.05, 0], "sway_hz": 2.5, "sway_phase": 0.75,
                  "swings": [{"axis": [0, 1, 0], "rest": 0.1, "amplitude": 0.2, "hz": 2, "phase": 0.5, "second": 0.125, "second_phase": 1.5}]},
                 {"name": "tail", "parent": "hip", "head": [0, 1, -0.5], "tail": [0, 1, -1], "radius": 0.05, "sway": [0, 0, 0], "sway_hz": 1, "sway_phase": 0, "swings": []}]},
             "coats": [
                 {"material": "fur", "strands_on": "uv", "wriggle_hz": 0.75, "translated": true, "wind_at": "pixel", "wind_fraction": 0.8, "foot_push": 0.5, "avoids_body": false, "mirrored": true, "drifts": true, "bare": true,
                  "layers": {"shells": 24, "length": 0.06, "reaches_tip": false, "spacing": 1.5, "bias": 0.01, "push": 0.03, "push_exponent": 1.5, "droop": 0.01,
                             "droop_shape": 2, "sag": 0.4, "down": [0, -1, 0.5],
                             "strand": {"width": 0.0003, "rigidity": 2e-8, "drag_coefficient": 1.25, "air_density": 1.1, "vogel_exponent": -0.5, "vogel_speed": 6, "max_bend": 1.4}},
                  "strands": {"density": 200, "stretch": 2, "row_shift": 0.5, "seed": 7, "jitter": 0.75, "wriggle": 0.5, "phase": 0.25, "low": 0.25, "high": 0.875,
                              "profile": "centre", "thickness": 1.5, "cut_min": 0.25, "cut_max": 0.05, "cut_exponent": 2, "shape": "oval", "half_length": 0.5,
                              "lift": 0.5, "shaft": 0.1, "bow": 0.2, "bow_turns": 1.5, "tuft": 0.4, "tuft_size": 8},
                  "comb": {"along": [0, -1, -2], "bend": 0.75, "tousle": 0.5, "tousle_size": 0.1},
                  "spots": [{"from": [0, 1, 1], "to": [0, 1.25, 1], "radius": 0.1, "soft": 0.05, "length": 0.5, "colour": [1, 0.5, 0.25], "tint": 0.5, "glow": 4}],
                  "maps": {"length": "length.pgm", "colour": "colour.ppm", "noise_a": "a.pgm", "noise_b": "b.pgm", "influence_a": 0.5, "influence_b": 0.75,
                           "noise_tiles": 4, "projection": "side", "bald_below": 0.1},
                  "look": {"root": [0.1, 0.05, 0.02], "tip": [0.5, 0.4, 0.2], "second": [0.2, 0.3, 0.4], "skin": [0.3, 0.2, 0.1], "second_size": 0.5, "tip_power": 3,
                           "variation": 0.3, "occlusion": 1.5, "occlusion_bias": 0.25, "wrap": 0.5, "gloss": 0.2, "gloss_power": 50, "sheen": 0.4, "sheen_power": 60,
                           "through": 0.5, "strand_normals": 0.8, "square_normals": 0.5, "exact_normals": true, "cel_steps": 3},
                  "levels": {"min_shells": 6, "full_until": 8, "march": 2, "skip_empty": false, "outer_first": false, "depth_first": true, "one_draw_each": true,
                             "shadow_strands": false, "shadow_shells": 12},
                  "inertia": {"stages": 6, "lag": 0.5},
                  "cloud": {"cover": 0.25, "size": 30, "base": 0.5, "billow": 0.5, "soft": 0.25, "octaves": 3, "seed": 5, "fading": 20, "round_rim": false}}]},
            {"mesh": {"sheet": {"size": [2, 3], "columns": 4, "rows": 5, "wave": 0.125}}},
            {"mesh": {"globe_sphere": {"radius": 0.25, "sectors": 12, "stacks": 8}}},
            {"mesh": {"cube_sphere": {"radius": 0.75, "cells": 5}}},
            {"mesh": {"wing": {"span": 2, "chord": 0.5, "thickness": 0.05, "sweep": 0.5, "droop": 0.25, "feathers": 5, "columns": 24, "rows": 6, "left": true}}},
            {"mesh": {"beast": {"height": 3, "detail": 40}}}
        ],
        "obstacles": [{"name": "house", "colour": [0.5, 0.4, 0.3], "ends": [0.6, 0.5, 0.4], "hidden": true,
                       "windows": {"width": 0.8, "height": 1.1, "spacing": 2, "storey": 3, "sill": 1, "door": true, "glass": [0.1, 0.1, 0.2],
                                   "frame": [0.7, 0.6, 0.5]}}],
        "lamps": [{"position": [1, 2, 3], "colour": [20, 5, 2], "reach": 12}],
        "ground_memory": {"texels": 64, "texel_size": 0.5, "spring": {"frequency_hz": 2.5, "damping": 0.12}, "push": 1.2,
                          "trail_fraction": 0.6, "trail_time": 15, "trample_time": 0.9, "clearance": 0.5, "blend_width": 1.5,
                          "jump_speed": 90, "max_walkers": 16},
        "sampling": {"strength": 0.9, "limit": 50, "detail": 0.5, "detail_length": 0.6}
    }
})";

} // namespace windrow::vegetation::program::test
