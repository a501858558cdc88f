// Tutorial: a sequence of .vdb files, for Blender, Houdini or a renderer.
//
//     export_vdb FOLDER          writes FOLDER/fan_0001.vdb .. FOLDER/fan_0010.vdb
//
// 1. Make a wind: here a light breeze of 2 m/s with a fan that blows up and downwind, 32 x 16 x 32 cells of 1 m.
// 2. Describe the sequence once: where the files go, how they are named, which axis points up.
// 3. After each step hand the wind to `Sequence::write`. It tells a full disk from a folder that cannot be written.
//
// In Blender: Add > Volume > Import OpenVDB, select all ten files, and set the volume's Velocity Unit to Second (docs/vdb.md).

#include <filesystem>
#include <iostream>
#include <system_error>
#include <windrow/fluid/vdb/vdb_export.h>
#include <windrow/fluid/wind.h>

namespace {

constexpr double k_frames_a_second = 24.0;

// A disk that is full is another trouble than a folder that cannot be written, for a script that calls this one.
int exit_code(windrow::vdb::Problem problem) {
    using windrow::vdb::Problem;
    return problem == Problem::disk_full || problem == Problem::out_of_memory ? 3 : 2;
}

} // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::cerr << "usage: export_vdb FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder = arguments[1];
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        std::cerr << folder.string() << ": " << error.message() << ": name a folder that you may make.\n";
        return 2;
    }

    // 1. The wind.
    auto wind = windrow::Wind::create({.ambient = {2.0f, 0.0f, 0.0f}});
    if (!wind) {
        std::cerr << wind.error() << '\n';
        return 2;
    }
    const auto fan = wind->motors().add(windrow::DirectionalMotor{.position = {-8.0, -2.0, 0.0},
                                                                  .direction = {1.0f, 0.5f, 0.0f},
                                                                  .region = windrow::Sphere{.radius = 3.0f},
                                                                  .law = windrow::Drive{.speed = 8.0f}});
    if (!fan) {
        std::cerr << fan.error() << '\n';
        return 2;
    }

    // 2. The sequence: Blender's axis points up, and half the bits are plenty for a picture.
    const windrow::vdb::Sequence sequence{.folder = folder,
                                          .prefix = "fan_",
                                          .options = {.precision = windrow::vdb::Precision::half, .up = windrow::vdb::UpAxis::z}};

    // 3. The frames.
    for (int frame = 1; frame <= 10; ++frame) {
        wind->step(1.0 / k_frames_a_second);
        const auto written = sequence.write(windrow::vdb::grid_of(*wind), frame, frame / k_frames_a_second);
        if (!written) {
            std::cerr << written.error() << '\n';
            return exit_code(written.problem());
        }
        std::cout << sequence.path(frame).string() << '\n';
    }
}
