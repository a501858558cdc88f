#include "cli/bench/bench_report.h"

#include "cli/table.h"
#include "fluid/message.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;

constexpr TableFormat k_table;

std::string count(std::size_t number) {
    return message(number);
}
std::string times(std::string_view name, const Spread& ms) {
    return k_table.line(name, {to_fixed(ms.min, 3), to_fixed(ms.median, 3), to_fixed(ms.p99, 3), count(ms.samples)});
}
std::string solver(std::string_view name, const SolverResult& result) {
    return k_table.line(name, {to_fixed(result.ms.min, 3), to_fixed(result.ms.median, 3), to_fixed(result.ms.p99, 3),
                               count(result.ms.samples), to_scientific(result.residual, 1)});
}

std::string schemes(const GridResult& grid) {
    const double cells = static_cast<double>(grid.cells.x) * grid.cells.y * grid.cells.z;
    std::string text = k_table.line(
        "whole step", {"min ms", "median ms", "99 % ms", "samples", "Mcells/s", "bytes/cell", "barriers", "/ copy", "/ Stam"});
    for (const SchemeResult& scheme : grid.schemes) {
        const Spread& ms = scheme.step_ms;
        text += k_table.line(scheme.name, {to_fixed(ms.min, 3), to_fixed(ms.median, 3), to_fixed(ms.p99, 3), count(ms.samples),
                                           to_fixed(cells / ms.median / 1000.0, 1), to_fixed(scheme.bytes_per_cell, 0),
                                           message(scheme.loops), to_fixed(scheme.vs_copy16, 1), to_fixed(scheme.vs_stam40, 2)});
    }
    text += times("Stam, 40 sweeps", grid.stam40_ms);
    text += times("copy of 16 B a cell", grid.copy16_ms);
    return text;
}

std::string stages(const SchemeResult& scheme) {
    std::string text = k_table.line(message(scheme.name, ", stages"), {"min ms", "median ms", "99 % ms", "samples"});
    for (std::size_t n = 0; n < scheme.stages_ms.size(); ++n)
        text += times(message("  ", k_stages[n].name), scheme.stages_ms[n]);
    return text;
}

std::string pressure(const GridResult& grid) {
    std::string text = k_table.line("pressure alone", {"min ms", "median ms", "99 % ms", "samples", "residual"});
    text += solver("direct", grid.direct);
    text += solver("40 Jacobi sweeps", grid.jacobi40);
    if (grid.direct_one_thread)
        text += solver("direct, one thread", *grid.direct_one_thread);
    if (grid.fftw)
        text += solver("FFTW, one thread", *grid.fftw);
    if (grid.vdb)
        text += solver("OpenVDB", *grid.vdb);
    text += message("  direct / 40 Jacobi sweeps ", to_fixed(grid.direct_vs_jacobi40, 3), "; their error of dp/dx ",
                    to_fixed(grid.jacobi40_gradient_error, 2), "\n");
    if (grid.fftw)
        text += message("  direct / FFTW ", to_fixed(grid.direct_vs_fftw, 3), ", both on one thread\n");
    return text;
}

void warn_of_flow(const GridResult& grid, const Console& console) {
    for (const SchemeResult& scheme : grid.schemes) {
        if (scheme.most_substeps > 1 || scheme.slept)
            console.warn(message(scheme.name, scheme.slept ? ": the air slept" : ": steps were cut into sub-steps",
                                 ", so that its times are those of another step."));
    }
    const std::size_t samples = std::min_element(grid.schemes.begin(), grid.schemes.end(), [](const auto& a, const auto& b) {
                                    return a.step_ms.samples < b.step_ms.samples;
                                })->step_ms.samples;
    if (samples < k_enough_samples)
        console.warn(message(samples, " samples are few for a 99 % quantile: give more --seconds."));
}

} // namespace

void report_machine(const BenchResult& result, const Console& console) {
    console.out << result.device << "; " << result.compiler << "; commit " << result.commit << "; "
                << message(result.threads, result.threads == 1 ? " thread" : " threads", " (", result.simd, ")") << "\n";
    console.out.flush();
}

void report_grid(const GridResult& grid, const Console& console) {
    const glm::ivec3 cells = grid.cells;
    float cfl = 0.0f;
    for (const SchemeResult& scheme : grid.schemes)
        cfl = std::max(cfl, scheme.largest_cfl);
    console.out << "\n"
                << message(cells.x, " x ", cells.y, " x ", cells.z, ": methods in turns, ", grid.rounds,
                           " rounds; ratios are medians over the rounds; largest CFL ", to_fixed(cfl, 2))
                << "\n"
                << schemes(grid);
    for (const SchemeResult& scheme : grid.schemes)
        console.out << stages(scheme);
    console.out << pressure(grid);
    if (!grid.left_out.empty())
        console.out << "  left out: " << grid.left_out.substr(0, grid.left_out.size() - 1) << "\n";
    warn_of_flow(grid, console);
    console.out.flush();
}

void report_volumes(const VolumesResult& volumes, bool first, const Console& console) {
    if (first)
        console.out << "\nWindows of 32 x 16 x 32, each stepped by one thread\n"
                    << k_table.line("volumes at once",
                                    {"min ms", "median ms", "99 % ms", "samples", "volumes/s", "a core", "MiB each"});
    const Spread& ms = volumes.round_ms;
    console.out << k_table.line(message(volumes.volumes),
                                {to_fixed(ms.min, 3), to_fixed(ms.median, 3), to_fixed(ms.p99, 3), count(ms.samples),
                                 to_fixed(volumes.volumes_per_s, 0), to_fixed(volumes.volumes_per_s_core, 0),
                                 to_fixed(static_cast<double>(volumes.bytes_per_volume) / (1 << 20), 2)});
    console.out.flush();
}

} // namespace windrow::cli
