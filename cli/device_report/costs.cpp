// What a device charges for each command, and how fast it copies by the size of what it copies.
#include "cli/device_report/copy_rounds.h"
#include "cli/device_report/report_section.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace windrow::cli {
namespace {

using detail::message;
using Commands = std::function<void(VkCommandBuffer)>;

constexpr int k_repeats = 64; // of a command in a recording: one alone is below a clock's resolution
constexpr double k_warm_fraction = 0.3;

DeviceContestant contestant(Commands commands) {
    return {.warm = commands, .run = [commands](VkCommandBuffer buffer, const auto&) { commands(buffer); }};
}

// Each command in a row of k_repeats, in turns.
Result<void> measure_commands(SectionRun& run, vulkan::Device& device, double seconds) {
    constexpr VkDeviceSize k_piece = 4096;
    auto made = CopyRounds::create(device, 2 * k_repeats * k_piece);
    if (!made)
        return made.failure();
    const CopyRounds& pass = *made;
    if (auto filled = run.own.run([&](VkCommandBuffer commands) { pass.fill(commands); }); !filled)
        return filled;
    auto contest = DeviceContest::create(run.own, device);
    if (!contest)
        return contest.failure();
    using Once = std::function<void(VkCommandBuffer, int n)>;
    struct Command {
        const char* what;
        Once once;
    };
    const auto launch = [&](VkCommandBuffer commands, int) { pass.launch(commands); };
    const auto nothing = [&](VkCommandBuffer commands, int) { pass.launch_nothing(commands); };
    const auto barrier = [&](VkCommandBuffer commands, int) { pass.barrier(commands); };
    // Each to a place of its own: none waits for another.
    const auto copy = [&](VkCommandBuffer commands, int n) {
        pass.transfer(commands, static_cast<VkDeviceSize>(n) * k_piece, k_piece);
    };
    const auto with_barrier = [barrier](const Once& once) {
        return [=](VkCommandBuffer commands, int n) {
            once(commands, n);
            barrier(commands, n);
        };
    };
    const Command all[] = {{"launch of one work group", launch},
                           {"launch and barrier", with_barrier(launch)},
                           {"barrier alone", barrier},
                           {"empty indirect dispatch", nothing},
                           {"empty indirect dispatch and barrier", with_barrier(nothing)},
                           {"copy of 4 KiB", copy},
                           {"copy of 4 KiB and barrier", with_barrier(copy)}};
    for (const Command& command : all)
        contest->add(contestant([&pass, once = command.once](VkCommandBuffer commands) {
            pass.bind(commands);
            for (int n = 0; n < k_repeats; ++n)
                once(commands, n);
            pass.barrier(commands);
        }));
    const std::size_t empty = contest->add(contestant([](VkCommandBuffer) {}));
    const auto held =
        contest->hold({.seconds = seconds, .warm_seconds = k_warm_fraction * seconds}, [&] { return run.clock.stopped(); });
    if (!held)
        return held.failure();
    if (*held == DeviceContest::End::stopped)
        return {};
    ReportJson& rows = run.json["commands"];
    for (std::size_t n = 0; n < std::size(all); ++n)
        rows.push_back({{"command", all[n].what}, {"us", spread_json(contest->microseconds(n), 1.0 / k_repeats)}});
    rows.push_back({{"command", "nothing: the two timestamps"}, {"us", spread_json(contest->microseconds(empty))}});
    return {};
}

// By the host's clock: an empty command buffer, from before its recording until the host knows that it is done.
Result<void> measure_submission(SectionRun& run, double seconds) {
    std::vector<float> us;
    const auto begin = std::chrono::steady_clock::now();
    const auto past = [](auto start) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
    while (past(begin) < (1.0 + k_warm_fraction) * seconds || us.empty()) {
        const auto start = std::chrono::steady_clock::now();
        if (auto ran = run.own.run([](VkCommandBuffer) {}); !ran)
            return ran;
        if (past(begin) >= k_warm_fraction * seconds)
            us.push_back(static_cast<float>(1e6 * past(start)));
    }
    run.json["commands"].push_back({{"command", "submit and wait, host's clock"}, {"us", spread_json(device_spread(us))}});
    return {};
}

// By the size of both buffers together: small ones stay in caches.
Result<void> measure_bandwidth(SectionRun& run, vulkan::Device& device, double seconds_each) {
    const bool software = run.own.facts().software;
    const VkDeviceSize least = software ? VkDeviceSize{4} << 20 : VkDeviceSize{256} << 20; // [bytes] read by a sample
    for (VkDeviceSize bytes = 64 << 10; bytes <= VkDeviceSize{256} << 20; bytes *= 4) {
        const std::string name = message(bytes >> 10, " KiB");
        if (run.clock.over()) {
            run.leave_out(message("bandwidth at ", name, " and above: the time is up."));
            run.leave_out_row("bandwidth", {{"footprint_KiB", bytes >> 10}}, "time");
            return {};
        }
        auto made = CopyRounds::create(device, bytes);
        if (!made) {
            run.leave_out(message("bandwidth at ", name, ": ", made.error()));
            continue;
        }
        if (auto filled = run.own.run([&](VkCommandBuffer commands) { made->fill(commands); }); !filled)
            return filled;
        auto contest = DeviceContest::create(run.own, device);
        if (!contest)
            return contest.failure();
        const VkDeviceSize moved = std::max(least, bytes / 2);
        const CopyRounds& pass = *made;
        contest->add(contestant([&pass, moved](VkCommandBuffer commands) {
            pass.bind(commands);
            pass.copy(commands, moved);
            pass.barrier(commands);
        }));
        const auto held = contest->hold({.seconds = seconds_each, .warm_seconds = k_warm_fraction * seconds_each},
                                        [&] { return run.clock.stopped(); });
        if (!held)
            return held.failure();
        if (*held == DeviceContest::End::stopped)
            return {};
        const DeviceSpread us = contest->microseconds(0);
        const double both_ways = 2.0 * static_cast<double>(CopyRounds::copied(moved));
        run.json["bandwidth"].push_back({{"footprint_KiB", bytes >> 10},
                                         {"GB_per_s", four_digits(1e-3 * both_ways / std::max(us.median, 1e-3))},
                                         {"us", spread_json(us)}});
    }
    return {};
}

} // namespace

Result<void> report_costs(SectionRun& run) {
    auto device = vulkan::Device::create(run.own.host());
    if (!device)
        return device.failure();
    const double seconds = run.clock.budget();
    if (auto measured = measure_commands(run, **device, 0.25 * seconds); !measured)
        return measured;
    if (run.clock.stopped())
        return {};
    if (auto measured = measure_submission(run, 0.05 * seconds); !measured)
        return measured;
    return measure_bandwidth(run, **device, 0.05 * seconds);
}

} // namespace windrow::cli
