// One grid: the step beside a copy and beside Stam's step, the direct solve beside Jacobi, FFTW and OpenVDB.
#pragma once

#include "cli/bench/bench_request.h"
#include "cli/bench/bench_result.h"
#include "fluid/parallel.h"
#include "fluid/result.h"

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

namespace windrow::cli {

/// Memory of all methods together. [bytes]
[[nodiscard]] std::uint64_t grid_bench_bytes(glm::ivec3 cells);

/// Nothing inside where `stopped` said so.
[[nodiscard]] Result<std::optional<GridResult>> measure_grid(glm::ivec3 cells, const BenchRequest& request, int threads,
                                                             const ParallelFor& parallel_for,
                                                             const std::function<bool()>& stopped);

} // namespace windrow::cli
