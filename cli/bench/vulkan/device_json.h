// The figures of `windrow bench --backend vulkan` as JSON: entries beside those of the CPU's, of the same names.
#pragma once

#include "cli/bench/vulkan/device_result.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace windrow::cli {

[[nodiscard]] nlohmann::ordered_json device_bench(const DeviceBenchResult& result);
/// The same as the text of a file.
[[nodiscard]] std::string device_bench_json(const DeviceBenchResult& result);

} // namespace windrow::cli
