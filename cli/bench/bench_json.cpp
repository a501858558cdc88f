#include "cli/bench/bench_json.h"

#include "cli/table.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace windrow::cli {
namespace {

using Json = nlohmann::ordered_json;

// To the nanosecond: the clock tells no more.
double rounded(double ms) {
    return std::round(ms * 1e6) / 1e6;
}

Json spread(const Spread& ms) {
    return {{"min", rounded(ms.min)}, {"median", rounded(ms.median)}, {"p99", rounded(ms.p99)}, {"samples", ms.samples}};
}

Json entry(const GridResult& grid, const SchemeResult& scheme) {
    Json stages;
    for (std::size_t n = 0; n < scheme.stages_ms.size(); ++n)
        stages[k_stages[n].name] = spread(scheme.stages_ms[n]);
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
    // A device's name may hold any byte.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace windrow::cli
