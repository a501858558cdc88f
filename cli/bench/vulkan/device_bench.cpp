#include "cli/bench/vulkan/device_bench.h"

#include "cli/backend/open_device.h"
#include "cli/bench/vulkan/device_grid.h"
#include "cli/bench/vulkan/device_json.h"
#include "cli/bench/vulkan/device_report.h"
#include "cli/build_facts.h"
#include "cli/exit_code.h"
#include "cli/machine.h"
#include "cli/output_file.h"
#include "fluid/thread_pool.h"

#include <memory>
#include <utility>

namespace windrow::cli {
int measure_device(vulkan::OwnDevice& own, const BenchRequest& request, const Console& console,
                   const std::function<int()>& stop_signal, DeviceBenchResult& result) {
    const vulkan::DeviceFacts& facts = own.facts();
    result = {.device = facts.name,
              .driver = facts.driver,
              .api_version = facts.api_version,
              .cpu = device_name(),
              .compiler = compiler_name(),
              .commit = commit_name(),
              .software = facts.software};
    report_device(result, console);
    const auto pool = make_pool(request.threads, console);
    const std::function<bool()> stopped = [&] { return stop_signal() != 0; };
    for (const glm::ivec3 cells : request.grids) {
        auto grid = measure_device_grid(
            own, {.cells = cells, .seconds = request.seconds, .simd = request.simd, .parallel_for = pool->parallel_for()},
            stopped);
        if (!grid) {
            console.complain(grid.error());
            return k_exit_machine;
        }
        if (!*grid)
            return k_exit_signal + stop_signal();
        report_device_grid(**grid, facts.software, console);
        result.grids.push_back(std::move(**grid));
    }
    return k_exit_well;
}

int run_device_bench(const BenchRequest& request, const Console& console, const std::function<int()>& stop_signal) {
    const auto file = request.json ? std::make_unique<OutputFile>(*request.json, "--json") : nullptr;
    if (file)
        if (const auto fault = file->fault())
            return complain_of(fault, console);
    std::unique_ptr<vulkan::OwnDevice> device;
    if (const Fault fault = open_device({.device = request.backend.device}, device))
        return complain_of(fault, console);
    DeviceBenchResult result;
    if (const int code = measure_device(*device, request, console, stop_signal, result); code != k_exit_well)
        return code;
    if (file) {
        file->write(device_bench_json(result));
        if (const auto fault = file->publish())
            return complain_of(fault, console);
        console.out << "\nIn " << request.json->string() << ": all figures.\n";
    }
    return k_exit_well;
}

} // namespace windrow::cli
