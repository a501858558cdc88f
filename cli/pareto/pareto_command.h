// `windrow pareto`: the least error that can be had for the time.
#pragma once

#include "cases/pareto_method.h"
#include "cli/backend.h"
#include "cli/console.h"
#include "fluid/parallel.h"
#include "fluid/result.h"
#include "fluid/simd.h"
#include "scene/part.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace windrow::cli {

struct ParetoRequest {
    std::vector<cases::ParetoFlow> flows{};
    std::vector<double> cfls{};
    bool one_thread_too = true; ///< times with one thread beside those with all
    double seconds = 1.0;       ///< [s] a grid is timed at least so long, up to ten times as long where samples are few
    BackendRequest backend{};
    int threads = 0; ///< 0: one a core
    Simd simd = Simd::best;
    std::filesystem::path out;
    scene::Part part{};                        ///< of the flows, which are that part's already
    std::vector<std::filesystem::path> join{}; ///< folders of parts; no flow is run
};

// --- The front of those that nothing beats: of a set of points, those than which no other is at once no dearer and no worse, and
// better in one of the two. Based on: Kung, Luccio & Preparata 1975, Journal of the ACM 22 (the maxima of a set of vectors: sort by one figure, sweep the
// other).
struct CostError {
    double cost = 0.0;
    double error = 0.0;
};

/// True where `a` is no dearer and no worse than `b`, and better in one.
[[nodiscard]] bool beats(const CostError& a, const CostError& b);

/// The points on the front, by rising cost; equal points are all on it or none. What is not finite is on no front.
[[nodiscard]] std::vector<std::size_t> front_of(std::span<const CostError> points);

/// Of those that beat a point the one with the least error, the cheapest of these; nothing where the point is on the front.
[[nodiscard]] std::optional<std::size_t> beaten_by(std::span<const CostError> points, std::size_t point);

// --- Figures -----------------------------------------------------------------------------------------------------------

/// One method on one grid at one step, with one number of threads.
struct ParetoRow {
    cases::Method method{};
    glm::ivec3 cells{0};
    double cfl = 0.0;
    double error = 0.0;            ///< |u - truth| / |truth - mean wind| at the end; not finite where the run broke
    std::optional<double> order{}; ///< of the error, from the next coarser grid to this one; none on the coarsest
    double step_ms = 0.0;          ///< of a step: vs_stam40 times the least of Stam's
    double vs_stam40 = 0.0;        ///< median over the turns of the time of a step over that of Stam's
    int threads = 1;
    double ms_per_second = 0.0; ///< [ms/s] step_ms * steps / flow time
};

struct FlowResult {
    std::string name;
    std::vector<ParetoRow> rows;

    /// The rows with `threads` threads.
    [[nodiscard]] std::vector<ParetoRow> rows_with(int threads) const {
        std::vector<ParetoRow> chosen;
        for (const ParetoRow& row : rows)
            if (row.threads == threads)
                chosen.push_back(row);
        return chosen;
    }
};

struct ParetoResult {
    std::string device; ///< what runs the methods: the processor, or a Vulkan device
    std::string simd;
    cases::BackendKind backend = cases::BackendKind::cpu;
    int threads = 1; ///< most; fronts are of these; on a device the threads of Stam's step
    std::vector<FlowResult> flows;
};

[[nodiscard]] inline std::vector<CostError> points_of(const std::vector<ParetoRow>& rows) {
    std::vector<CostError> points;
    for (const ParetoRow& row : rows)
        points.push_back({row.ms_per_second, row.error});
    return points;
}

/// Adds the command; where it is chosen, `chosen` runs it.
void add_pareto(CLI::App& app, std::function<int()>& chosen, const Console& console);

/// Returns the exit code: 1 where the default method broke on a flow. `stop_signal` is asked between runs and turns; anything but
/// 0 ends it there, and no file is made.
[[nodiscard]] int run_pareto(const ParetoRequest& request, const Console& console, const std::function<int()>& stop_signal);

void report_pareto_start(const ParetoResult& result, const Console& console);
/// `threads`: those of the front.
void report_front(const FlowResult& flow, int threads, const Console& console);

/// A row a method, grid, step, flow and number of threads:
///
///     backend, scheme, advection, pressure   the method
///     grid, cfl, case                        cells along x, y, z; cells that the fastest air crosses in a step; the flow
///     error                                  |u - truth| / |truth - mean wind| at the flow's end; inf or nan where the run broke
///     order                                  of the error, from the next coarser grid to this one; empty on the coarsest
///     cost_vs_stam40                         time of a step over that of Stam's with 40 Jacobi sweeps, median of neighbouring turns
///     step_ms                                cost_vs_stam40 times the least time of Stam's step on that grid
///     threads
///     ms_per_second                          time for a second of the flow: step_ms * steps / flow time
///     machine                                what ran the methods, and its SIMD level; quoted
[[nodiscard]] std::string pareto_csv(const ParetoResult& result);

/// Makes pareto.csv of those in the folders of all parts, each flow from one of them. Returns the exit code.
[[nodiscard]] int join_pareto(const ParetoRequest& request, const Console& console);

/// Memory that the flow's largest grid takes. [bytes]
[[nodiscard]] std::uint64_t flow_run_bytes(const cases::ParetoFlow& flow);

/// Tells a line a grid. `threads` is the most; nothing inside where `stopped` said so.
[[nodiscard]] Result<std::optional<FlowResult>> run_flow(const cases::ParetoFlow& flow, const ParetoRequest& request, int threads,
                                                         const ParallelFor& parallel_for, const cases::Backend& backend,
                                                         const Console& console, const std::function<bool()>& stopped);

} // namespace windrow::cli
