// The figures of `windrow pareto` as CSV: a row a method, grid, step, flow and number of threads.
//
//   backend, scheme, advection, pressure   the method
//   grid, cfl, case                        cells along x, y, z; cells that the fastest air crosses in a step; the flow
//   error                                  |u - truth| / |truth - mean wind| at the flow's end; inf or nan where the run broke
//   order                                  of the error, from the next coarser grid to this one; empty on the coarsest
//   cost_vs_stam40                         time of a step over that of Stam's with 40 Jacobi sweeps, median of neighbouring turns
//   step_ms                                cost_vs_stam40 times the least time of Stam's step on that grid
//   threads
//   ms_per_second                          time for a second of the flow: step_ms * steps / flow time
//   machine                                what ran the methods, and its SIMD level; quoted
#pragma once

#include "cli/pareto/pareto_result.h"

#include <string>

namespace windrow::cli {

[[nodiscard]] std::string pareto_csv(const ParetoResult& result);

} // namespace windrow::cli
