#include "cli/bench/vulkan/device_contest.h"

#include "cli/timings.h"
#include "gpu/device.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <utility>

namespace windrow::cli {

DeviceSpread device_spread(const std::vector<float>& values) {
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return {.mean = values.empty() ? 0.0 : sum / static_cast<double>(values.size()),
            .min = quantile(values, 0.0),
            .median = quantile(values, 0.5),
            .p99 = quantile(values, 0.99),
            .samples = values.size()};
}

Result<DeviceContest> DeviceContest::create(vulkan::OwnDevice& own, vulkan::Device& device) {
    auto timestamps = vulkan::Timestamps::create(device, 1 + k_device_intervals);
    if (!timestamps)
        return timestamps.failure();
    DeviceContest contest;
    contest.own_ = &own;
    contest.timestamps_ = *std::move(timestamps);
    return contest;
}

std::size_t DeviceContest::add(DeviceContestant contestant) {
    entries_.push_back({.contestant = std::move(contestant)});
    return entries_.size() - 1;
}

Result<void> DeviceContest::turn(DeviceEntry& entry, bool counts) {
    std::uint32_t marks = 0;
    const auto mark = [&](VkCommandBuffer commands) {
        if (marks <= k_device_intervals)
            timestamps_.write(commands, marks++);
    };
    const auto ran = own_->run([&](VkCommandBuffer commands) {
        timestamps_.reset(commands);
        entry.contestant.warm(commands);
        mark(commands);
        entry.contestant.run(commands, [&](VkCommandBuffer where) {
            if (marks < k_device_intervals)
                mark(where);
        });
        while (marks <= k_device_intervals)
            mark(commands);
    });
    if (!ran)
        return ran;
    std::uint64_t moments[1 + k_device_intervals] = {};
    if (!timestamps_.read(moments))
        return Error{"the device's timestamps were not available after its work: update its driver."};
    if (!counts)
        return {};
    for (std::size_t n = 0; n < k_device_intervals; ++n)
        entry.us[n].push_back(static_cast<float>(timestamps_.microseconds(moments[n], moments[n + 1])));
    entry.contestant.note();
    return {};
}

Result<bool> DeviceContest::round(std::size_t number, bool counts, const std::function<bool()>& stopped) {
    const std::size_t count = entries_.size();
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t place = number % 2 == 0 ? n : count - 1 - n;
        if (stopped())
            return false;
        if (auto done = turn(entries_[(place + number / 2) % count], counts); !done)
            return done.failure();
    }
    return true;
}

Result<DeviceContest::End> DeviceContest::hold(const ContestTimes& times, const std::function<bool()>& stopped) {
    const bool software = own_->facts().software;
    const auto now = [] { return std::chrono::steady_clock::now(); };
    const auto past = [&](auto start) { return std::chrono::duration<double>(now() - start).count(); };
    const auto warm_start = now();
    for (std::size_t n = 0; n == 0 || past(warm_start) < times.warm_seconds; ++n)
        if (auto whole = round(n, false, stopped); !whole || !*whole)
            return whole ? Result<End>(End::stopped) : whole.failure();
    const auto start = now();
    for (rounds_ = 0;; ++rounds_) {
        const bool time_is_up = past(start) >= times.seconds;
        if (rounds_ > 0 && (software ? time_is_up || rounds_ >= k_device_samples : time_is_up && rounds_ >= times.least_samples))
            return End::whole;
        if (auto whole = round(rounds_, true, stopped); !whole || !*whole)
            return whole ? Result<End>(End::stopped) : whole.failure();
    }
}

DeviceSpread DeviceContest::microseconds(std::size_t contestant, std::size_t interval) const {
    return device_spread(entries_[contestant].us[interval]);
}

double DeviceContest::ratio(std::size_t a, std::size_t b) const {
    std::vector<float> ratios;
    for (std::size_t n = 0; n < rounds_; ++n)
        ratios.push_back(entries_[a].us[0][n] /
                         std::max(entries_[b].us[0][n], 1e-3f)); // no clock resolves less than a nanosecond
    return quantile(std::move(ratios), 0.5);
}

} // namespace windrow::cli
