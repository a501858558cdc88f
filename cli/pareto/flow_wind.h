// A wind that runs a flow of `windrow pareto` by one of its methods, raw: nothing on top of the method.
#pragma once

#include "cli/backend/command_wind.h"
#include "cli/pareto/pareto_flow.h"
#include "cli/pareto/pareto_method.h"

#include <memory>

namespace windrow::cli {

/// `method` solves directly: a wind knows no other.
[[nodiscard]] Result<std::unique_ptr<CommandWind>> flow_wind(const ParetoFlow& flow, glm::ivec3 cells, const Method& method,
                                                             Simd simd, const ParallelFor& parallel_for, const Backend& backend);

} // namespace windrow::cli
