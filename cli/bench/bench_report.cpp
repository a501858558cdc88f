#include "cli/bench/bench_command.h"
#include "cli/table.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
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
        text += times(message("  ", StageTimes::rows()[n].name), scheme.stages_ms[n]);
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
        if (scheme.max_substeps > 1 || scheme.slept)
            console.warn(message(scheme.name, scheme.slept ? ": the air slept" : ": steps were cut into sub-steps",
                                 ", so that its times are those of another step."));
    }
    const std::size_t samples = std::min_element(grid.schemes.begin(), grid.schemes.end(), [](const auto& a, const auto& b) {
                                    return a.step_ms.samples < b.step_ms.samples;
                                })->step_ms.samples;
    if (samples < k_enough_samples)
        console.warn(message(samples, " samples are few for a 99 % quantile: give more --seconds."));
}

// --- JSON -------------------------------------------------------------------------------------------------------------

using Json = nlohmann::ordered_json;

// To the nanosecond, the resolution of the clock.
double rounded(double ms) {
    return std::round(ms * 1e6) / 1e6;
}

Json spread(const Spread& ms) {
    return {{"min", rounded(ms.min)}, {"median", rounded(ms.median)}, {"p99", rounded(ms.p99)}, {"samples", ms.samples}};
}

Json entry(const GridResult& grid, const SchemeResult& scheme) {
    Json stages;
    for (std::size_t n = 0; n < scheme.stages_ms.size(); ++n)
        stages[StageTimes::rows()[n].name] = spread(scheme.stages_ms[n]);
    const double cells = static_cast<double>(grid.cells.x) * grid.cells.y * grid.cells.z;
    return {{"grid", grid_name(grid.cells)},
            {"scheme", scheme.name},
            {"backend", "cpu"},
            {"step_ms", spread(scheme.step_ms)},
            {"stages_ms", stages},
            {"dispatches", scheme.loops},
            {"barriers", scheme.loops},
            {"vs_copy16", scheme.vs_copy16},
            {"vs_stam40", scheme.vs_stam40},
            {"cells_per_s", 1000.0 * cells / scheme.step_ms.median},
            {"bytes_per_cell", scheme.bytes_per_cell},
            {"largest_cfl", scheme.largest_cfl},
            {"samples", scheme.step_ms.samples}};
}

Json reference(const GridResult& grid) {
    Json json = {{"grid", grid_name(grid.cells)}, {"copy16_ms", spread(grid.copy16_ms)}, {"stam40_ms", spread(grid.stam40_ms)}};
    const auto add = [&](const std::string& name, const SolverResult& solver) {
        json[name + "_ms"] = spread(solver.ms);
        json[name + "_residual"] = solver.residual;
    };
    add("jacobi40", grid.jacobi40);
    json["jacobi40_gradient_error"] = grid.jacobi40_gradient_error;
    add("direct", grid.direct);
    json["direct_vs_jacobi40"] = grid.direct_vs_jacobi40;
    if (grid.direct_one_thread)
        add("direct_one_thread", *grid.direct_one_thread);
    if (grid.fftw) {
        add("fftw", *grid.fftw);
        json["direct_vs_fftw"] = grid.direct_vs_fftw;
    }
    if (grid.vdb)
        add("vdb", *grid.vdb);
    return json;
}

Json obstacles_entry(const ObstaclesResult& obstacles) {
    Json scenes = Json::array();
    for (const ObstacleScene& scene : obstacles.scenes)
        scenes.push_back({{"scene", scene.name},
                          {"obstacles", scene.obstacles},
                          {"surface", scene.surface},
                          {"solves", scene.solves},
                          {"step_ms", spread(scene.step_ms)},
                          {"stages_over_step", scene.stages_over_step},
                          {"over_empty", scene.over_empty}});
    return {{"grid", grid_name(obstacles.cells)},
            {"scenes", scenes},
            {"second_solve", obstacles.second_solve},
            {"walk_slowest_over_median", obstacles.walk.slowest_over_median},
            {"walk_median_ms", obstacles.walk.median_ms},
            {"walk_in_rows_slowest_over_median", obstacles.walk_in_rows.slowest_over_median},
            {"walk_in_rows_median_ms", obstacles.walk_in_rows.median_ms}};
}

Json volumes_entry(const VolumesResult& volumes) {
    return {{"volumes", volumes.volumes},
            {"grid", "32x16x32"},
            {"scheme", "second_order"},
            {"round_ms", spread(volumes.round_ms)},
            {"volumes_per_s", volumes.volumes_per_s},
            {"volumes_per_s_core", volumes.volumes_per_s_core},
            {"bytes_per_volume", volumes.bytes_per_volume}};
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

void report_obstacles(const ObstaclesResult& obstacles, const Console& console) {
    const glm::ivec3 cells = obstacles.cells;
    console.out << "\n"
                << message(cells.x, " x ", cells.y, " x ", cells.z, ": obstacles in turns, ", obstacles.rounds, " rounds") << "\n"
                << k_table.line("whole step", {"min ms", "median ms", "99 % ms", "samples", "obstacles", "surface %", "solves",
                                               "stages", "/ empty"});
    for (const ObstacleScene& scene : obstacles.scenes)
        console.out << k_table.line(
            scene.name, {to_fixed(scene.step_ms.min, 3), to_fixed(scene.step_ms.median, 3), to_fixed(scene.step_ms.p99, 3),
                         count(scene.step_ms.samples), message(scene.obstacles), to_fixed(100.0 * scene.surface, 2),
                         message(scene.solves), to_fixed(scene.stages_over_step, 4), to_fixed(scene.over_empty, 3)});
    console.out << message("  a second solve adds ", to_fixed(obstacles.second_solve, 3),
                           " of the step; a walk's slowest step / median ", to_fixed(obstacles.walk.slowest_over_median, 2),
                           ", median ", to_fixed(obstacles.walk.median_ms, 3), " ms; in uneven rows ",
                           to_fixed(obstacles.walk_in_rows.slowest_over_median, 2), ", ",
                           to_fixed(obstacles.walk_in_rows.median_ms, 3), " ms\n");
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

std::string bench_json(const BenchResult& result) {
    Json json = {{"device", result.device},     {"compiler", result.compiler}, {"commit", result.commit},
                 {"simd", result.simd},         {"threads", result.threads},   {"entries", Json::array()},
                 {"references", Json::array()}, {"volumes", Json::array()}};
    for (const GridResult& grid : result.grids) {
        for (const SchemeResult& scheme : grid.schemes)
            json["entries"].push_back(entry(grid, scheme));
        json["references"].push_back(reference(grid));
    }
    for (const VolumesResult& volumes : result.volumes)
        json["volumes"].push_back(volumes_entry(volumes));
    for (const ObstaclesResult& obstacles : result.obstacles)
        json["obstacles"].push_back(obstacles_entry(obstacles));
    // A device's name may hold any byte.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace windrow::cli
