#include "cli/bench/vulkan/device_contest.h"

#include "cli/timings.h"
#include "fluid/vulkan/device.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <utility>

namespace windrow::cli {
namespace {

constexpr std::size_t k_idle_rounds = 1; // pipelines are compiled and memory is touched in it

} // namespace

DeviceSpread device_spread(const std::vector<float>& values) {
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return {.mean = values.empty() ? 0.0 : sum / static_cast<double>(values.size()),
            .min = quantile(values, 0.0),
            .median = quantile(values, 0.5),
            .p99 = quantile(values, 0.99),
            .samples = values.size()};
}

Result<DeviceContest> DeviceContest::create(vulkan::OwnDevice& own, vulkan::Device& device) {
    auto timestamps = vulkan::Timestamps::create(device, 2);
    if (!timestamps)
        return Error{timestamps.error()};
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
    const auto ran = own_->run([&](VkCommandBuffer commands) {
        timestamps_.reset(commands);
        entry.contestant.warm(commands);
        timestamps_.write(commands, 0);
        entry.contestant.run(commands);
        timestamps_.write(commands, 1);
    });
    if (!ran)
        return ran;
    std::uint64_t moments[2] = {};
    if (!timestamps_.read(moments))
        return Error{"the device's timestamps were not available after its work: update its driver."};
    if (counts) {
        entry.us.push_back(static_cast<float>(timestamps_.microseconds(moments[0], moments[1])));
        entry.contestant.note();
    }
    return {};
}

Result<bool> DeviceContest::round(std::size_t number, bool counts, const std::function<bool()>& stopped) {
    const std::size_t count = entries_.size();
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t place = number % 2 == 0 ? n : count - 1 - n;
        if (stopped())
            return false;
        if (auto done = turn(entries_[(place + number / 2) % count], counts); !done)
            return Error{done.error()};
    }
    return true;
}

Result<DeviceContest::End> DeviceContest::hold(double seconds, const std::function<bool()>& stopped) {
    for (std::size_t n = 0; n < k_idle_rounds; ++n)
        if (auto whole = round(n, false, stopped); !whole || !*whole)
            return whole ? Result<End>(End::stopped) : Error{whole.error()};
    const bool software = own_->facts().software;
    const auto start = std::chrono::steady_clock::now();
    for (rounds_ = 0;; ++rounds_) {
        const double past = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const bool enough = rounds_ >= k_device_samples;
        if (rounds_ > 0 && (software ? past >= seconds || enough : past >= seconds && enough))
            return End::whole;
        if (auto whole = round(rounds_, true, stopped); !whole || !*whole)
            return whole ? Result<End>(End::stopped) : Error{whole.error()};
    }
}

DeviceSpread DeviceContest::microseconds(std::size_t contestant) const {
    return device_spread(entries_[contestant].us);
}

double DeviceContest::ratio(std::size_t a, std::size_t b) const {
    std::vector<float> ratios;
    for (std::size_t n = 0; n < rounds_; ++n)
        ratios.push_back(entries_[a].us[n] / std::max(entries_[b].us[n], 1e-3f)); // below a nanosecond no clock tells
    return quantile(std::move(ratios), 0.5);
}

} // namespace windrow::cli
