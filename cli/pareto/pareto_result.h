// The figures that `windrow pareto` finds.
#pragma once

#include "cli/pareto/front.h"
#include "cli/pareto/pareto_method.h"

#include <optional>
#include <string>
#include <vector>

namespace windrow::cli {

/// One method on one grid at one step, with one number of threads.
struct ParetoRow {
    Method method{};
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
    std::string name, title;
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
    BackendKind backend = BackendKind::cpu;
    int threads = 1; ///< most; fronts are of these; on a device the threads of Stam's step
    std::vector<FlowResult> flows;
};

[[nodiscard]] inline std::vector<CostError> points_of(const std::vector<ParetoRow>& rows) {
    std::vector<CostError> points;
    for (const ParetoRow& row : rows)
        points.push_back({row.ms_per_second, row.error});
    return points;
}

} // namespace windrow::cli
