// The flags of `windrow bench`.
#pragma once

#include "cli/backend/backend_flags.h"
#include "cli/bench/bench_request.h"
#include "cli/console.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace windrow::cli {

struct BenchFlags {
    std::vector<std::string> grids, volumes;
    BackendFlags backend;
    std::string threads, simd, seconds, json;
};

void add_bench(CLI::App& app, BenchFlags& flags);
/// Nothing after a complaint.
[[nodiscard]] std::optional<BenchRequest> read_bench(const BenchFlags& flags, const CLI::App& bench, const Console& console);

} // namespace windrow::cli
