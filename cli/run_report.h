// What a run tells at its end: what it cost, what it met, what lies where.
#pragma once

#include "cli/console.h"
#include "cli/frame_writer.h"
#include "cli/playback.h"
#include "cli/timings.h"
#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace windrow::cli {

struct RunReport {
    const scene::Scene& scene;
    const Playback& playback; ///< at its end
    const std::filesystem::path& folder;
    const FrameWriter& writer;
    const Timings& timings;
    double air_seconds = 0.0;  ///< simulated
    double wall_seconds = 0.0; ///< passed on the clock, pictures and files included
    int threads = 1;
    const std::string& device; ///< empty: the CPU
    std::int64_t frames_done = 0;
    double step_hz = 0.0; ///< steps a second between frames
    bool csv = false, probes = false, forces = false;
};

void report_run(const RunReport& report, const Console& console);

} // namespace windrow::cli
