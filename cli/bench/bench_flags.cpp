#include "cli/bench/bench_flags.h"

#include "cli/flags.h"
#include "cli/run_command.h"
#include "fluid/box.h"
#include "fluid/message.h"
#include "scene/number_text.h"

#include <CLI/CLI.hpp>
#include <iterator>
#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;

/// Three whole numbers with an x between them.
std::optional<glm::ivec3> read_grid(const std::string& text, const Console& console) {
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
    if (!good) {
        console.complain(message("--grid is ", text.empty() ? "empty" : text,
                                 ": give three whole numbers such as 64x32x64, each from 1 to ", k_max_axis_cells, "."));
        return std::nullopt;
    }
    if (const std::size_t count = Box{.cells = cells}.cell_count(); count > k_max_cells) {
        console.complain(message("--grid is ", text, ", ", count, " cells: give at most ", k_max_cells, " cells."));
        return std::nullopt;
    }
    return cells;
}

} // namespace

void add_bench(CLI::App& app, BenchFlags& flags) {
    CLI::App* const bench = app.add_subcommand("bench", "Measure the step and its parts beside other methods, in turns");
    bench->add_option("--grid", flags.grids, "Cells along x, y, z; default 32x16x32 64x32x64 128x64x128")->type_name("NxNxN");
    add_backend(*bench, flags.backend);
    bench->add_option("--threads", flags.threads, "Threads; default one a core")->type_name("N");
    bench->add_option("--simd", flags.simd, "Instructions: best, baseline, avx2 or avx512; all methods of ours run on them")
        ->type_name("LEVEL");
    bench->add_option("--volumes", flags.volumes, "Windows of 32x16x32 stepped at once; without --grid, these alone")
        ->type_name("N");
    bench
        ->add_option("--seconds", flags.seconds,
                     "Time a grid, default 5; longer where 100 samples of a step take it, on a GPU 1000")
        ->type_name("S");
    bench->add_option("--json", flags.json, "File for all figures; written whole or not at all")->type_name("FILE");
}

std::optional<BenchRequest> read_bench(const BenchFlags& flags, const CLI::App& bench, const Console& console) {
    BenchRequest request;
    const auto backend = read_backend(flags.backend, bench, console);
    if (!backend)
        return std::nullopt;
    request.backend = *backend;
    if (backend->kind == BackendKind::vulkan && !flags.volumes.empty()) {
        console.complain("--volumes is given with --backend vulkan, which measures grids: drop one of them.");
        return std::nullopt;
    }
    for (const std::string& text : flags.grids) {
        const auto cells = read_grid(text, console);
        if (!cells)
            return std::nullopt;
        request.grids.push_back(*cells);
    }
    for (const std::string& text : flags.volumes) {
        const auto count = read_count(text, "--volumes", k_most_volumes, console);
        if (!count)
            return std::nullopt;
        request.volumes.push_back(static_cast<int>(*count));
    }
    if (request.grids.empty() && request.volumes.empty())
        request.grids.assign(std::begin(k_bench_grids), std::end(k_bench_grids));
    if (bench.count("--threads") > 0) {
        const auto threads = read_count(flags.threads, "--threads", k_most_threads, console);
        if (!threads)
            return std::nullopt;
        request.threads = static_cast<int>(*threads);
    }
    if (bench.count("--simd") > 0) {
        const auto level = read_simd(flags.simd, console);
        if (!level)
            return std::nullopt;
        request.simd = *level;
    }
    if (bench.count("--seconds") > 0) {
        const auto seconds = read_seconds(flags.seconds, console);
        if (!seconds)
            return std::nullopt;
        request.seconds = *seconds;
    }
    if (bench.count("--json") > 0) {
        if (flags.json.empty()) {
            console.complain("--json is empty: name a file.");
            return std::nullopt;
        }
        request.json = flags.json;
    }
    return request;
}

} // namespace windrow::cli
