// What `windrow bench` measures on the CPU: a grid, a grid with obstacles, and many windows at once.
//
// A grid: the step beside a copy and beside Stam's step, the direct solve beside Jacobi, FFTW and OpenVDB. Windows: as a server
// with as many players steps them, each volume by one thread, the volumes spread over the threads: one loop a step instead of one
// for each pass.
#pragma once

#include "cli/bench/bench_command.h"
#include "fluid/parallel.h"
#include "fluid/result.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace windrow::cli {

/// Memory of all methods together. [bytes]
[[nodiscard]] std::uint64_t grid_bench_bytes(glm::ivec3 cells);

/// Nothing inside where `stopped` said so.
[[nodiscard]] Result<std::optional<GridResult>> measure_grid(glm::ivec3 cells, const BenchRequest& request, int threads,
                                                             const ParallelFor& parallel_for,
                                                             const std::function<bool()>& stopped);

/// Obstacles: one cube; a town with 3 % of the cells at a surface, with one solve and with two; 10,000 obstacles outside of the box.
[[nodiscard]] Result<std::optional<ObstaclesResult>> measure_obstacles(glm::ivec3 cells, const BenchRequest& request,
                                                                       const cases::Backend& backend, int threads,
                                                                       const ParallelFor& parallel_for,
                                                                       const std::function<bool()>& stopped);

/// [bytes]
[[nodiscard]] std::uint64_t volume_bench_bytes(int volumes);

struct VolumesRequest {
    int volumes = 1;
    int threads = 1;
    Simd simd = Simd::best;
    double seconds = 1.0;
};

/// Nothing inside where `stopped` said so.
[[nodiscard]] Result<std::optional<VolumesResult>> measure_volumes(const VolumesRequest& request, const ParallelFor& parallel_for,
                                                                   const std::function<bool()>& stopped);

} // namespace windrow::cli
