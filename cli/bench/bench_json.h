// The figures of `windrow bench` as JSON, to be kept for a machine and compared between versions.
#pragma once

#include "cli/bench/bench_result.h"

#include <string>

namespace windrow::cli {

/// Times in ms as {min, median, p99, samples}; ratios of times; an absent method has no key.
[[nodiscard]] std::string bench_json(const BenchResult& result);

} // namespace windrow::cli
