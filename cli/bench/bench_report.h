// What `windrow bench` tells: a table a grid, a table of volumes.
#pragma once

#include "cli/bench/bench_result.h"
#include "cli/console.h"

namespace windrow::cli {

void report_machine(const BenchResult& result, const Console& console);
void report_grid(const GridResult& grid, const Console& console);
/// A line each; the first brings the head of the table.
void report_volumes(const VolumesResult& volumes, bool first, const Console& console);

} // namespace windrow::cli
