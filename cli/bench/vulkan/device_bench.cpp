#include "cli/bench/vulkan/device_bench.h"

#include "cases/jets.h"
#include "cli/bench/vulkan/plain_passes.h"
#include "cli/bench/vulkan/wind_recordings.h"
#include "cli/bench/wind_contestant.h"
#include "cli/info_command.h"
#include "cli/output_file.h"
#include "fluid/thread_pool.h"

#include <memory>
#include <utility>

namespace windrow::cli {

using namespace cases;
namespace {

constexpr double k_warm_fraction = 0.2; // of the time that is measured: a second of the default

} // namespace

Result<std::optional<DeviceGridResult>> measure_device_grid(vulkan::OwnDevice& own, const DeviceGridRequest& request,
                                                            const std::function<bool()>& stopped) {
    const std::vector<glm::vec4> flow = jets(bench_box(request.cells));
    const Config usual = bench_config(request.cells, Scheme::second_order, request.simd, request.parallel_for);
    Config single = usual; // the flow's CFL number asks for one sub-step: here no other may be chosen
    single.max_substeps = 1;

    auto lent = vulkan::Device::create(own.host());
    if (!lent)
        return lent.failure();
    auto contest = DeviceContest::create(own, **lent);
    if (!contest)
        return contest.failure();
    auto plain = PlainPasses::create(**lent, request.cells);
    if (!plain)
        return plain.failure();
    if (auto filled = own.run([&](VkCommandBuffer commands) { plain->fill(commands); }); !filled)
        return filled.failure();

    struct Own {
        const char* name;
        std::unique_ptr<WindRecordings> wind;
        std::size_t number = 0;
    };
    std::vector<Own> winds;
    Result<void> made;
    const auto add = [&](const char* name, const Config& config, vulkan::Settings settings) {
        settings.frames_in_flight = 2;
        auto wind = vulkan::Wind::create(own.host(), config, settings);
        if (!wind) {
            made = wind.failure();
            return;
        }
        winds.push_back({name, std::make_unique<WindRecordings>(*std::move(wind), RecordingPlan{.flow = flow})});
        winds.back().number = contest->add(winds.back().wind->contestant());
    };
    add("second_order", usual, {.queries = vulkan::ReadBack::cells}); // compared with the CPU
    add("one_substep", single, {});
    add("passes", single, {.timestamps = true}); // empty sub-steps would be in its sums
    if (!made)
        return made.failure();
    const auto add_plain = [&](void (PlainPasses::*pass)(VkCommandBuffer)) {
        PlainPasses* const passes = &*plain;
        return contest->add({.warm = [=](VkCommandBuffer commands) { (passes->*pass)(commands); },
                             .run = [=](VkCommandBuffer commands, const auto&) { (passes->*pass)(commands); }});
    };
    const std::size_t stencil = add_plain(&PlainPasses::stencil), copy = add_plain(&PlainPasses::copy);

    const auto held = contest->hold(
        {.seconds = request.seconds, .warm_seconds = k_warm_fraction * request.seconds, .least_samples = k_device_samples},
        stopped);
    if (!held)
        return held.failure();
    if (*held == DeviceContest::End::stopped)
        return std::optional<DeviceGridResult>();

    DeviceGridResult result{.cells = request.cells, .rounds = contest->rounds()};
    for (std::size_t n = 0; n < 2; ++n) {
        const Own& one = winds[n];
        DeviceStepResult step = one.wind->result(one.name);
        step.us = contest->microseconds(one.number);
        step.read_back_us = contest->microseconds(one.number, 1);
        step.vs_stencil = contest->ratio(one.number, stencil);
        step.vs_copy = contest->ratio(one.number, copy);
        result.steps.push_back(step);
    }
    result.stencil_us = contest->microseconds(stencil);
    result.copy_us = contest->microseconds(copy);
    winds[2].wind->add_passes(result);
    WindRecordings& first = *winds[0].wind;
    result.memory_bytes = winds[1].wind->wind().memory_bytes(); // of a wind that reads back its report alone
    result.max_substeps = first.max_substeps();
    result.slept = first.slept();

    auto cpu = windrow::Wind::create(usual);
    if (!cpu)
        return cpu.failure();
    if (auto compared = first.compare(own, *cpu, result); !compared)
        return compared.failure();
    return std::optional(std::move(result));
}

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
