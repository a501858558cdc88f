// `windrow bench`: what it is asked for, the figures that it finds.
#pragma once

#include "cli/backend.h"
#include "cli/bench/contest.h"
#include "cli/console.h"
#include "cli/timings.h"
#include "fluid/simd.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace windrow::cli {

inline constexpr glm::ivec3 k_bench_grids[] = {{32, 16, 32}, {64, 32, 64}, {128, 64, 128}};
/// The window of one player, as Config has it by default.
inline constexpr glm::ivec3 k_volume_cells{32, 16, 32};
/// Most volumes at once; memory ends earlier.
inline constexpr int k_max_volumes = 65536;
/// [s] A grid, or a number of volumes, is measured at least so long by default.
inline constexpr double k_bench_seconds = 5.0;

struct BenchRequest {
    std::vector<glm::ivec3> grids; ///< none: only volumes are measured
    std::vector<int> volumes;
    bool obstacles = false; ///< the grids are measured with obstacles instead of beside other methods
    BackendRequest backend{};
    int threads = 0; ///< 0: one a core
    Simd simd = Simd::best;
    double seconds = k_bench_seconds;
    std::optional<std::filesystem::path> json;
};

struct SchemeResult {
    const char* name;
    Spread step_ms{};
    std::array<Spread, k_stage_count> stages_ms{}; ///< in the order of StageTimes
    int loops = 0;                                 ///< parallel loops a step, and so barriers
    double bytes_per_cell = 0.0;                   ///< held
    double vs_copy16 = 0.0, vs_stam40 = 0.0;       ///< time of a step over that of a copy, of Stam's step
    float largest_cfl = 0.0f;
    int max_substeps = 0;
    bool slept = false;
};

struct SolverResult {
    Spread ms{};
    double residual = 0.0; ///< relative_residual
};

struct GridResult {
    glm::ivec3 cells{0};
    std::size_t rounds = 0;
    std::vector<SchemeResult> schemes{};
    Spread copy16_ms{}, stam40_ms{};
    SolverResult jacobi40{}, direct{};
    double jacobi40_gradient_error = 0.0; ///< against the direct solve
    double direct_vs_jacobi40 = 0.0;
    /// FFTW's solve runs on one thread, and so does the direct solve that it is compared with.
    std::optional<SolverResult> direct_one_thread{}, fftw{};
    double direct_vs_fftw = 0.0;
    std::optional<SolverResult> vdb{};
    std::string left_out{}; ///< why a method is missing, a sentence each
};

struct VolumesResult {
    int volumes = 0;
    Spread round_ms{}; ///< one step of all volumes
    double volumes_per_s = 0.0, volumes_per_s_core = 0.0;
    std::size_t bytes_per_volume = 0;
};

/// A wind with obstacles, beside the same wind without.
struct ObstacleScene {
    const char* name;
    int obstacles = 0;
    double surface = 0.0; ///< fraction of the cells that have a closed face, for bodies along the cells
    Spread step_ms{};
    double stages_over_step = 0.0; ///< median of the time at obstacles over that of the step, by the step's own clocks
    double over_empty = 0.0;       ///< time of a step over that without obstacles
    int solves = 0;                ///< most that a step took
};

struct ObstaclesResult {
    glm::ivec3 cells{0};
    std::size_t rounds = 0;
    std::vector<ObstacleScene> scenes{};
    double second_solve = 0.0; ///< what it adds to a step of the town, over that step
    /// A box that follows a walk through the town: each step has the least of its runs.
    struct Walk {
        double slowest_over_median = 0.0, median_ms = 0.0;
    };
    Walk walk{}, walk_in_rows{}; ///< in equal rows and in uneven ones
};

struct BenchResult {
    std::string device, compiler, commit, simd;
    int threads = 1;
    std::vector<GridResult> grids;
    std::vector<VolumesResult> volumes;
    std::vector<ObstaclesResult> obstacles{};
};

/// Adds the command; where it is chosen, `chosen` runs it.
void add_bench(CLI::App& app, std::function<int()>& chosen, const Console& console);

/// Returns the exit code. `stop_signal` is asked between turns; anything but 0 ends the measurement there, and no file is made.
[[nodiscard]] int run_bench(const BenchRequest& request, const Console& console, const std::function<int()>& stop_signal);

void report_machine(const BenchResult& result, const Console& console);
void report_grid(const GridResult& grid, const Console& console);
void report_obstacles(const ObstaclesResult& obstacles, const Console& console);
/// A line each; the first brings the head of the table.
void report_volumes(const VolumesResult& volumes, bool first, const Console& console);

/// Times in ms as {min, median, p99, samples}; ratios of times; an absent method has no key.
[[nodiscard]] std::string bench_json(const BenchResult& result);

} // namespace windrow::cli
