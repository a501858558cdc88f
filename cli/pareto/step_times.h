// What a step of each method takes on one grid, beside the tuned step of Stam in the same run.
#pragma once

#include "cli/backend/backend.h"
#include "cli/pareto/pareto_flow.h"
#include "cli/pareto/pareto_method.h"
#include "fluid/parallel.h"

#include <functional>
#include <optional>
#include <vector>

namespace windrow::cli {

struct StepTime {
    double vs_stam40 = 0.0; ///< median of neighbouring turns
    double step_ms = 0.0;   ///< the same times the least of Stam's: what a busy machine adds meets neighbours alike and cancels
};

struct GridTimes {
    std::vector<StepTime> methods{}; ///< in the order of pareto_methods
    double stam_ms = 0.0;            ///< least
    /// On the CPU the library's own step over the composed one of the same method, which does the same. On a device the CPU's
    /// step over the device's. None where the CPU's own step is what is timed.
    std::optional<double> wind_vs_method{};
    std::size_t rounds = 0;
};

/// All methods step one field in turns, at CFL 1: without viscosity a step's time depends neither on what the field holds nor, by
/// more than a twentieth, on the CFL number from 0.5 to 4. Nothing inside where
/// `stopped` said so.
[[nodiscard]] Result<std::optional<GridTimes>> measure_steps(const ParetoFlow& flow, glm::ivec3 cells, double seconds, Simd simd,
                                                             const ParallelFor& parallel_for, const Backend& backend,
                                                             const std::function<bool()>& stopped);

} // namespace windrow::cli
