#include "cli/bench/bench_command.h"

#include "cli/bench/grid_bench.h"
#if WINDROW_WITH_VULKAN
#include "cli/bench/vulkan/device_bench.h"
#endif
#include "cli/flags.h"
#include "cli/info_command.h"
#include "cli/output_file.h"
#include "fluid/box.h"
#include "fluid/core/message.h"
#include "fluid/thread_pool.h"
#include "scene/number_text.h"

#include <iterator>
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

int complain(const std::string& sentence, const Console& console) {
    console.complain(sentence);
    return k_exit_wrong_use;
}

/// Three whole numbers with an x between them.
glm::ivec3 read_grid(const std::string& text) {
    glm::ivec3 cells(0);
    std::string_view rest = text;
    bool good = true;
    for (int axis = 0; axis < 3 && good; ++axis) {
        const std::size_t end = axis < 2 ? rest.find('x') : rest.size();
        const auto number = scene::parse_whole_number(rest.substr(0, end));
        good = end != std::string_view::npos && number && *number >= 1 && *number <= k_max_axis_cells;
        cells[axis] = good ? static_cast<int>(*number) : 0;
        if (good && axis < 2)
            rest.remove_prefix(end + 1);
    }
    if (!good)
        reject("--grid is ", text.empty() ? "empty" : text, ": give three whole numbers such as 64x32x64, each from 1 to ",
               k_max_axis_cells, ".");
    if (const std::size_t count = Box{.cells = cells}.cell_count(); count > k_max_cells)
        reject("--grid is ", text, ", ", count, " cells: give at most ", k_max_cells, " cells.");
    return cells;
}

} // namespace

void add_bench(CLI::App& app, std::function<int()>& chosen, const Console& console) {
    CLI::App* const bench = app.add_subcommand("bench", "Measure the step and its parts beside other methods, in turns");
    const auto request = std::make_shared<BenchRequest>();
    Flags flags(*bench);
    flags.values("--grid", "NxNxN", "Cells along x, y, z; default 32x16x32 64x32x64 128x64x128",
                 [request](const std::string& text) { request->grids.push_back(read_grid(text)); });
    flags.backend(request->backend);
    flags.threads(request->threads);
    flags.simd(request->simd, "all methods of ours run on them");
    flags.values("--volumes", "N", "Windows of 32x16x32 stepped at once; without --grid, these alone",
                 [request](const std::string& text) {
                     request->volumes.push_back(static_cast<int>(read_count(text, "--volumes", k_max_volumes)));
                 });
    bench->add_flag("--obstacles", request->obstacles,
                    "Measure the grids with obstacles instead: a cube, a town, a second solve, obstacles outside, a walk");
    flags.seconds(request->seconds, "Time a grid, default 5; longer where 100 samples of a step take it, on a GPU 1000");
    flags.file("--json", request->json, "File for all figures; written atomically");
    bench->callback([bench, request, &chosen, &console] {
        check_backend(*bench, request->backend);
        if (request->backend.kind == cases::BackendKind::vulkan && !request->volumes.empty())
            reject("--volumes is given with --backend vulkan, which measures grids: drop one of them.");
        if (request->grids.empty() && request->volumes.empty())
            request->grids.assign(std::begin(k_bench_grids), std::end(k_bench_grids));
        chosen = interruptible<BenchRequest>(run_bench, request, console);
    });
}

int run_bench(const BenchRequest& request, const Console& console, const std::function<int()>& stop_signal) {
#if WINDROW_WITH_VULKAN
    if (request.backend.kind == cases::BackendKind::vulkan && !request.obstacles)
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
                                 " cores: the threads wait for each other, which distorts the ratios."));
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
    cases::Backend backend;
    if (const auto fault = open_backend(request.backend, backend))
        return complain_of(fault, console);
    if (!backend.is_cpu())
        result.device = backend.device_words();
    report_machine(result, console);
    for (const glm::ivec3 cells : request.grids) {
        if (request.obstacles) {
            auto scenes = measure_obstacles(cells, request, backend, threads, pool->parallel_for(), stopped);
            if (!scenes)
                return complain(scenes.error(), console);
            if (!*scenes)
                return k_exit_signal + stop_signal();
            report_obstacles(**scenes, console);
            result.obstacles.push_back(std::move(**scenes));
            continue;
        }
        auto grid = measure_grid(cells, request, threads, pool->parallel_for(), stopped);
        if (!grid)
            return complain(grid.error(), console);
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
            return complain(volumes.error(), console);
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
