#include "cli/bench/vulkan/device_grid.h"

#include "cli/bench/jets.h"
#include "cli/bench/vulkan/plain_passes.h"
#include "cli/bench/vulkan/wind_recordings.h"
#include "cli/bench/wind_contestant.h"

#include <memory>
#include <utility>

namespace windrow::cli {

Result<std::optional<DeviceGridResult>> measure_device_grid(vulkan::OwnDevice& own, const DeviceGridRequest& request,
                                                            const std::function<bool()>& stopped) {
    const std::vector<glm::vec4> flow = jets(bench_box(request.cells));
    const Config usual = bench_config(request.cells, Scheme::second_order, request.simd, request.parallel_for);
    Config single = usual; // the flow's CFL number asks for one sub-step: here no other may be chosen
    single.max_substeps = 1;

    auto lent = vulkan::Device::create(own.host());
    if (!lent)
        return Error{lent.error()};
    auto contest = DeviceContest::create(own, **lent);
    if (!contest)
        return Error{contest.error()};
    auto plain = PlainPasses::create(**lent, request.cells);
    if (!plain)
        return Error{plain.error()};
    if (auto filled = own.run([&](VkCommandBuffer commands) { plain->fill(commands); }); !filled)
        return Error{filled.error()};

    struct Own {
        const char* name;
        std::unique_ptr<WindRecordings> wind;
        std::size_t number = 0;
    };
    std::vector<Own> winds;
    Result<void> made;
    const auto add = [&](const char* name, const Config& config, bool timestamps) {
        auto wind = vulkan::Wind::create(own.host(), config, {.frames_in_flight = 2, .timestamps = timestamps});
        if (!wind) {
            made = Error{wind.error()};
            return;
        }
        winds.push_back({name, std::make_unique<WindRecordings>(*std::move(wind), flow)});
        winds.back().number = contest->add(winds.back().wind->contestant());
    };
    add("second_order", usual, false);
    add("one_substep", single, false);
    add("passes", usual, true);
    if (!made)
        return Error{made.error()};
    const auto stencil_commands = [&](VkCommandBuffer commands) { plain->stencil(commands); };
    const std::size_t stencil = contest->add({.warm = stencil_commands, .run = stencil_commands});
    const auto copy_commands = [&](VkCommandBuffer commands) { plain->copy(commands); };
    const std::size_t copy = contest->add({.warm = copy_commands, .run = copy_commands});

    const auto held = contest->hold(request.seconds, stopped);
    if (!held)
        return Error{held.error()};
    if (*held == DeviceContest::End::stopped)
        return std::optional<DeviceGridResult>();

    DeviceGridResult result{.cells = request.cells, .rounds = contest->rounds()};
    for (std::size_t n = 0; n < 2; ++n) {
        const Own& one = winds[n];
        DeviceStepResult step = one.wind->result(one.name);
        step.us = contest->microseconds(one.number);
        step.vs_stencil = contest->ratio(one.number, stencil);
        step.vs_copy = contest->ratio(one.number, copy);
        result.steps.push_back(step);
    }
    result.stencil_us = contest->microseconds(stencil);
    result.copy_us = contest->microseconds(copy);
    winds[2].wind->add_passes(result);
    WindRecordings& first = *winds[0].wind;
    result.memory_bytes = first.wind().memory_bytes();
    result.most_substeps = first.most_substeps();
    result.slept = first.slept();

    auto cpu = windrow::Wind::create(usual);
    if (!cpu)
        return Error{cpu.error()};
    if (auto compared = first.compare(own, *cpu, result); !compared)
        return Error{compared.error()};
    return std::optional(std::move(result));
}

} // namespace windrow::cli
