// Recordings timed on a device's own clock in one interleaved run: what the device and the machine do meanwhile meets all alike.
//
// A round gives each contestant one turn; the order rotates from round to round and turns about. A turn is one submission: a
// recording that is not timed, which brings memory into caches and the clocks of a device up, and right behind it the one that
// is. A timed recording may be divided into intervals, so that a read-back has one of its own. Rounds of the warm-up do not count.
// A ratio is the median over the rounds of the ratio of two turns.
#pragma once

#include "fluid/vulkan/own_device.h"
#include "gpu/timestamps.h"

#include <array>
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
    /// Ends an interval of the timed recording, and begins the next.
    using Mark = std::function<void(VkCommandBuffer)>;
    std::function<void(VkCommandBuffer)> warm;                  ///< not timed
    std::function<void(VkCommandBuffer, const Mark& mark)> run; ///< timed; marks beyond k_device_intervals - 1 are ignored
    std::function<void()> note = [] {};                         ///< after a turn that counts; its commands are done
};

/// Most intervals of a timed recording.
inline constexpr std::size_t k_device_intervals = 2;

/// How long a contest lasts.
struct ContestTimes {
    double seconds = 5.0;      ///< of rounds that count, at least one
    double warm_seconds = 0.0; ///< before them, at least one round: pipelines are compiled, clocks come up
    /// Samples that a GPU goes on for. A software device takes what fits, and ends where it has k_device_samples.
    std::size_t least_samples = 0;
};

class DeviceContest {
  public:
    /// Both outlive the contest.
    [[nodiscard]] static Result<DeviceContest> create(vulkan::OwnDevice& own, vulkan::Device& device);
    /// Returns the contestant's number.
    std::size_t add(DeviceContestant contestant);

    enum class End { whole, stopped };
    /// The error is the device's.
    [[nodiscard]] Result<End> hold(const ContestTimes& times, const std::function<bool()>& stopped);

    /// Of an interval of the timed recording; an interval that no mark began took 0.
    [[nodiscard]] DeviceSpread microseconds(std::size_t contestant, std::size_t interval = 0) const;
    /// Of the first interval.
    [[nodiscard]] double ratio(std::size_t a, std::size_t b) const;
    [[nodiscard]] std::size_t rounds() const { return rounds_; }

  private:
    struct DeviceEntry {
        DeviceContestant contestant;
        std::array<std::vector<float>, k_device_intervals> us{};
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
