#include "cli/pareto/pareto_flags.h"

#include "cli/flags.h"
#include "cli/run_command.h"

#include <CLI/CLI.hpp>

namespace windrow::cli {

void add_pareto(CLI::App& app, ParetoFlags& flags) {
    CLI::App* const pareto = app.add_subcommand("pareto", "Find the least error for the time: methods, grids, steps; table, CSV");
    pareto->add_flag("--quick", flags.quick, "Fewer flows, grids and steps: a minute on two cores instead of eight");
    pareto->add_option("--out", flags.out, "Folder for pareto.csv, which ./dev plots draws; default out/pareto")
        ->type_name("DIR");
    add_backend(*pareto, flags.backend);
    pareto->add_option("--threads", flags.threads, "Most threads; default one a core; errors do not depend on it")
        ->type_name("N");
    pareto->add_option("--simd", flags.simd, "Instructions: best, baseline, avx2 or avx512; all methods run on them")
        ->type_name("LEVEL");
}

std::optional<ParetoRequest> read_pareto(const ParetoFlags& flags, const CLI::App& pareto, const Console& console) {
    ParetoRequest request{.flows = pareto_flows(flags.quick), .out = std::filesystem::path("out") / "pareto"};
    const auto backend = read_backend(flags.backend, pareto, console);
    if (!backend)
        return std::nullopt;
    request.backend = *backend;
    if (flags.quick) {
        request.cfls = {1.0, 2.0};
        request.one_thread_too = false;
        request.seconds = 0.4;
    } else {
        request.cfls = {0.5, 1.0, 2.0, 4.0};
        request.seconds = 1.5;
    }
    if (pareto.count("--threads") > 0) {
        const auto threads = read_count(flags.threads, "--threads", k_most_threads, console);
        if (!threads)
            return std::nullopt;
        request.threads = static_cast<int>(*threads);
    }
    if (pareto.count("--simd") > 0) {
        const auto level = read_simd(flags.simd, console);
        if (!level)
            return std::nullopt;
        request.simd = *level;
    }
    if (pareto.count("--out") > 0) {
        if (flags.out.empty()) {
            console.complain("--out is empty: name a folder.");
            return std::nullopt;
        }
        request.out = flags.out;
    }
    return request;
}

} // namespace windrow::cli
