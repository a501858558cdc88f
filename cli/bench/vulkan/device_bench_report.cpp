#include "cli/bench/vulkan/device_bench.h"
#include "cli/table.h"
#include "fluid/core/message.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;

constexpr TableFormat k_table;

std::string us(double value) {
    return to_fixed(value, 1);
}
std::string mebibytes(std::uint64_t bytes) {
    return to_fixed(static_cast<double>(bytes) / (1 << 20), 2);
}
// What a pass reaches, by the bytes that it moves where all its fields hold something; at most, that is.
std::string gigabytes_a_second(std::uint64_t bytes, double microseconds) {
    return bytes == 0 || microseconds <= 0.0 ? "-" : to_fixed(static_cast<double>(bytes) / microseconds * 1e-3, 1);
}

std::string times(std::string_view name, const DeviceSpread& spread) {
    return k_table.line(name, {us(spread.mean), us(spread.median), us(spread.p99), us(spread.min), message(spread.samples)});
}

std::string steps(const DeviceGridResult& grid) {
    std::string text = k_table.line(
        "whole step", {"mean us", "median us", "99 % us", "min us", "samples", "dispatches", "barriers", "/ stencil", "/ copy"});
    for (const DeviceStepResult& step : grid.steps) {
        text += k_table.line(step.name, {us(step.us.mean), us(step.us.median), us(step.us.p99), us(step.us.min),
                                         message(step.us.samples), message(step.dispatches), message(step.barriers),
                                         to_fixed(step.vs_stencil, 1), to_fixed(step.vs_copy, 1)});
        text += times("  its read-back", step.read_back_us);
    }
    return text + times("plain stencil", grid.stencil_us) + times("plain copy", grid.copy_us);
}

std::string passes(const DeviceGridResult& grid) {
    std::string text = k_table.line("passes, one sub-step", {"mean us", "median us", "99 % us", "min us", "samples", "dispatches",
                                                             "of them ran", "MiB moved", "GB/s"});
    for (const DevicePassResult& pass : grid.passes)
        text += k_table.line(message("  ", pass.name),
                             {us(pass.us.mean), us(pass.us.median), us(pass.us.p99), us(pass.us.min), message(pass.us.samples),
                              message(pass.dispatches), message(pass.dispatches_ran), mebibytes(pass.bytes),
                              gigabytes_a_second(pass.bytes, pass.us.median)});
    return text + times("  between them", grid.between_us) + times("  whole, with clock", grid.timed_us) +
           times("  read-back", grid.read_back_us);
}

// --- JSON -------------------------------------------------------------------------------------------------------------

using Json = nlohmann::ordered_json;

// To the nanosecond: no device's clock resolves less.
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
            {"read_back_us", spread(step.read_back_us)},
            {"dispatches", step.dispatches},
            {"barriers", step.barriers},
            {"vs_stencil", step.vs_stencil},
            {"vs_copy16", step.vs_copy},
            {"cells_per_s", 1e6 * cells / step.us.median},
            {"samples", step.us.samples}};
}

} // namespace

void report_device(const DeviceBenchResult& result, const Console& console) {
    console.out << result.device << (result.software ? " (software device: its times say nothing about a GPU)" : "")
                << "; driver " << result.driver << "; Vulkan " << result.api_version << "\n"
                << "host " << result.cpu << "; " << result.compiler << "; commit " << result.commit << "\n";
    console.out.flush();
}

void report_device_grid(const DeviceGridResult& grid, bool software, const Console& console) {
    const glm::ivec3 cells = grid.cells;
    console.out << "\n"
                << message(cells.x, " x ", cells.y, " x ", cells.z, ": recordings in turns, ", grid.rounds,
                           " rounds after a warm-up; ratios are medians over the rounds")
                << "\n"
                << steps(grid) << passes(grid) << "  moved by a step: " << mebibytes(grid.pass_bytes)
                << " MiB by its passes, each field of cells that a pass binds once for reading and once for writing; "
                << mebibytes(grid.read_back_bytes) << " MiB by the read-back; device memory " << mebibytes(grid.memory_bytes)
                << " MiB\n"
                << message("  against the CPU after ", grid.all_steps, " steps, ", grid.parity_steps,
                           " since the flow was laid in again: ")
                << to_scientific(grid.parity, 1) << " of the largest velocity\n";
    if (grid.max_substeps > 1 || grid.slept)
        console.warn(grid.slept ? "the air slept, so that its times are those of another step."
                                : "steps were cut into sub-steps, so that their times are those of another step.");
    if (grid.rounds < k_device_samples)
        console.warn(message(grid.rounds, " samples are fewer than the ", k_device_samples, " that a 99 % quantile needs",
                             software ? ": a software device gives what fits --seconds." : "."));
    console.out.flush();
}

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
