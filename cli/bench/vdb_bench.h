// OpenVDB's Poisson solver, which takes so long that it does not run among the others: the least of three runs.
#pragma once

#include "cli/bench/bench_result.h"
#include "fluid/box.h"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace windrow::cli {

/// Nothing where OpenVDB is missing or would take too long, which `left_out` then tells. `rhs` with h = 1.
[[nodiscard]] std::optional<SolverResult> measure_vdb(const Box& box, std::span<const float> rhs, int threads, double seconds,
                                                      const std::function<bool()>& stopped, std::string& left_out);

} // namespace windrow::cli
