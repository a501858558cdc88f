#include "cli/bench/vulkan/device_json.h"

#include "cli/table.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace windrow::cli {
namespace {

using Json = nlohmann::ordered_json;

// To the nanosecond: no device's clock tells more.
double rounded(double us) {
    return std::round(us * 1e3) / 1e3;
}

Json spread(const DeviceSpread& us) {
    return {{"mean", rounded(us.mean)},
            {"min", rounded(us.min)},
            {"median", rounded(us.median)},
            {"p99", rounded(us.p99)},
            {"samples", us.samples}};
}

Json entry(const DeviceGridResult& grid, const std::string& name, const DeviceStepResult& step) {
    const double cells = static_cast<double>(grid.cells.x) * grid.cells.y * grid.cells.z;
    return {{"grid", name},
            {"scheme", step.name},
            {"backend", "vulkan"},
            {"step_us", spread(step.us)},
            {"dispatches", step.dispatches},
            {"barriers", step.barriers},
            {"vs_stencil", step.vs_stencil},
            {"vs_copy16", step.vs_copy},
            {"cells_per_s", 1e6 * cells / step.us.median},
            {"samples", step.us.samples}};
}

} // namespace

Json device_bench(const DeviceBenchResult& result) {
    Json json = {{"device", result.device},      {"software", result.software}, {"driver", result.driver},
                 {"vulkan", result.api_version}, {"host", result.cpu},          {"compiler", result.compiler},
                 {"commit", result.commit},      {"entries", Json::array()},    {"references", Json::array()},
                 {"passes", Json::array()}};
    for (const DeviceGridResult& grid : result.grids) {
        const std::string name = grid_name(grid.cells);
        for (const DeviceStepResult& step : grid.steps)
            json["entries"].push_back(entry(grid, name, step));
        Json& first = json["entries"][json["entries"].size() - grid.steps.size()];
        first["bytes_moved"] = grid.pass_bytes;
        first["bytes_read_back"] = grid.read_back_bytes;
        first["memory_bytes"] = grid.memory_bytes;
        first["parity"] = grid.parity; // what is not finite becomes null
        first["parity_steps"] = grid.parity_steps;
        first["steps"] = grid.all_steps;
        json["references"].push_back(
            {{"grid", name}, {"stencil_us", spread(grid.stencil_us)}, {"copy16_us", spread(grid.copy_us)}});
        for (const DevicePassResult& pass : grid.passes)
            json["passes"].push_back({{"grid", name},
                                      {"pass", pass.name},
                                      {"us", spread(pass.us)},
                                      {"dispatches", pass.dispatches},
                                      {"dispatches_ran", pass.dispatches_ran},
                                      {"bytes_moved", pass.bytes}});
        json["passes"].push_back({{"grid", name}, {"pass", "between"}, {"us", spread(grid.between_us)}});
    }
    return json;
}

std::string device_bench_json(const DeviceBenchResult& result) {
    // A device's name may hold any byte.
    return device_bench(result).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace windrow::cli
