#include "cli/bench/bench_command.h"

#include "cli/bench/bench_json.h"
#include "cli/bench/bench_report.h"
#include "cli/bench/grid_bench.h"
#include "cli/bench/volume_bench.h"
#if WINDROW_WITH_VULKAN
#include "cli/bench/vulkan/device_bench.h"
#endif
#include "cli/build_facts.h"
#include "cli/exit_code.h"
#include "cli/machine.h"
#include "cli/output_file.h"
#include "fluid/message.h"
#include "fluid/thread_pool.h"

#include <memory>
#include <string>
#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;

bool check_memory(std::string_view what, std::uint64_t needed, const char* fix, const Console& console) {
    const auto available = available_memory();
    if (!available || needed <= *available)
        return true;
    console.complain(
        message(what, ", which takes about ", needed >> 20, " MiB, and ", *available >> 20, " MiB are free: give ", fix, "."));
    return false;
}

bool check_memory(const BenchRequest& request, const Console& console) {
    for (const glm::ivec3 cells : request.grids)
        if (!check_memory(message("--grid is ", cells.x, "x", cells.y, "x", cells.z), grid_bench_bytes(cells), "fewer cells",
                          console))
            return false;
    for (const int volumes : request.volumes)
        if (!check_memory(message("--volumes is ", volumes), volume_bench_bytes(volumes), "fewer volumes", console))
            return false;
    return true;
}

int refuse(const std::string& sentence, const Console& console) {
    console.complain(sentence);
    return k_exit_wrong_use;
}

} // namespace

int run_bench(const BenchRequest& request, const Console& console, const std::function<int()>& stop_signal) {
#if WINDROW_WITH_VULKAN
    if (request.backend.kind == BackendKind::vulkan)
        return run_device_bench(request, console, stop_signal);
#endif
    if (!check_memory(request, console))
        return k_exit_machine;
    const auto file = request.json ? std::make_unique<OutputFile>(*request.json, "--json") : nullptr;
    if (file)
        if (const auto fault = file->fault())
            return complain_of(fault, console);

    if (request.threads > usable_cores())
        console.complain(message("--threads is ", request.threads, ", more than the ", usable_cores(),
                                 " cores: the threads wait for each other, and ratios tell of that."));
    const auto pool = make_pool(request.threads, console);
    const int threads = pool->size();
    const std::function<bool()> stopped = [&] { return stop_signal() != 0; };
    BenchResult result{.device = device_name(),
                       .compiler = compiler_name(),
                       .commit = commit_name(),
                       .simd = name_of(request.simd),
                       .threads = threads,
                       .grids = {},
                       .volumes = {}};
    report_machine(result, console);
    for (const glm::ivec3 cells : request.grids) {
        auto grid = measure_grid(cells, request, threads, pool->parallel_for(), stopped);
        if (!grid)
            return refuse(grid.error(), console);
        if (!*grid)
            return k_exit_signal + stop_signal();
        report_grid(**grid, console);
        result.grids.push_back(std::move(**grid));
    }
    for (const int count : request.volumes) {
        const auto volumes =
            measure_volumes({.volumes = count, .threads = threads, .simd = request.simd, .seconds = request.seconds},
                            pool->parallel_for(), stopped);
        if (!volumes)
            return refuse(volumes.error(), console);
        if (!*volumes)
            return k_exit_signal + stop_signal();
        report_volumes(**volumes, result.volumes.empty(), console);
        result.volumes.push_back(**volumes);
    }
    if (file) {
        file->write(bench_json(result));
        if (const auto fault = file->publish())
            return complain_of(fault, console);
        console.out << "\nIn " << request.json->string() << ": all figures.\n";
    }
    return k_exit_well;
}

} // namespace windrow::cli
