// `windrow run`: plays a scene, keeps what was asked for, and tells what it cost.
#pragma once

#include "cli/backend.h"
#include "cli/console.h"
#include "cli/film_request.h"
#include "cli/probes.h"
#include "fluid/field_files.h"
#include "fluid/simd.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace windrow::cli {

struct RunRequest {
    std::filesystem::path scene;
    FilmRequest film{};
    std::optional<std::filesystem::path> out; ///< default: out/<scene name>
    bool vdb = false;
    bool images = false;
    bool csv = false;
    std::vector<FieldFormat> fields{}; ///< a file a frame of each
    ProbeRequest probes{};
    BackendRequest backend{};
    std::int64_t snapshot_every = 0; ///< frames; 0: none
    bool resume = false;
    std::string words{}; ///< the flags as they were given, which a snapshot keeps
    int threads = 0;     ///< 0: one a core
    Simd simd = Simd::best;
};

/// Adds the command; where it is chosen, `chosen` runs it.
void add_run(CLI::App& app, std::function<int()>& chosen, const Console& console);

/// Returns the exit code. `stop_signal` is asked after every frame; anything but 0 ends the run there, with whole files.
[[nodiscard]] int run_scene(const RunRequest& request, const Console& console, const std::function<int()>& stop_signal);

} // namespace windrow::cli
