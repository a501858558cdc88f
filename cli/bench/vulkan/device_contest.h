// Recordings timed on a device's own clock in one interleaved run: what the device and the machine do meanwhile meets all alike.
//
// A round gives each contestant one turn; the order rotates from round to round and turns about. A turn is one submission: a
// recording that is not timed, which brings memory into caches and the clocks of a device up, and right behind it the one that
// is. A ratio is the median over the rounds of the ratio of two turns.
#pragma once

#include "fluid/vulkan/own_device.h"
#include "fluid/vulkan/timestamps.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace windrow::cli {

/// Samples of a figure that a real device gives in any case.
inline constexpr std::size_t k_device_samples = 1000;

/// What the samples of one figure say; the quantiles are nearest ranks.
struct DeviceSpread {
    double mean = 0.0, min = 0.0, median = 0.0, p99 = 0.0;
    std::size_t samples = 0;
};
[[nodiscard]] DeviceSpread device_spread(const std::vector<float>& values);

struct DeviceContestant {
    std::function<void(VkCommandBuffer)> warm; ///< not timed
    std::function<void(VkCommandBuffer)> run;  ///< timed
    std::function<void()> note = [] {};        ///< after a turn that counts; its commands are done
};

class DeviceContest {
  public:
    /// Both outlive the contest.
    [[nodiscard]] static Result<DeviceContest> create(vulkan::OwnDevice& own, vulkan::Device& device);
    /// Returns the contestant's number.
    std::size_t add(DeviceContestant contestant);

    enum class End { whole, stopped };
    /// A round that does not count, then rounds for `seconds`; a GPU goes on until it has k_device_samples, a software device
    /// ends where it has them. At least one round. The error is the device's.
    [[nodiscard]] Result<End> hold(double seconds, const std::function<bool()>& stopped);

    [[nodiscard]] DeviceSpread microseconds(std::size_t contestant) const;
    [[nodiscard]] double ratio(std::size_t a, std::size_t b) const;
    [[nodiscard]] std::size_t rounds() const { return rounds_; }

  private:
    struct DeviceEntry {
        DeviceContestant contestant;
        std::vector<float> us{};
    };
    /// False where it was stopped in its midst.
    Result<bool> round(std::size_t number, bool counts, const std::function<bool()>& stopped);
    Result<void> turn(DeviceEntry& entry, bool counts);

    vulkan::OwnDevice* own_ = nullptr;
    vulkan::Timestamps timestamps_;
    std::vector<DeviceEntry> entries_;
    std::size_t rounds_ = 0;
};

} // namespace windrow::cli
