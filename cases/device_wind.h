// A wind on a device for a command, which asks what a step did before it asks for the next: submits, and waits. An engine does
// neither (fluid/vulkan/wind.h).
#pragma once

#include "cases/backend_wind.h"
#include "fluid/vulkan/wind.h"

#include <memory>

namespace windrow::cases {

class DeviceWind final : public BackendWind {
  public:
    /// `backend` has a device.
    [[nodiscard]] static Result<std::unique_ptr<BackendWind>>
    create(const Config& config, const Backend& backend, BackendClock clock, const std::shared_ptr<const Wind>& outer = {});

    /// times_ms.total is the time from the recording to the end on the device; the stages are by the device's clock, 0 without.
    Diagnostics step(double dt) override { return run(dt); }
    /// Fetches what was changed since the last step.
    [[nodiscard]] WindReader& reader() const override;

  private:
    DeviceWind(const Backend& backend, std::unique_ptr<vulkan::Wind> wind)
        : BackendWind(*wind), backend_(backend), wind_(std::move(wind)) {}

    /// Runs a step, or with a dt of 0 what was asked for alone, and takes the read-back.
    Diagnostics run(double dt) const;
    [[nodiscard]] bool failed() const override { return !backend_.fault().empty(); }

    Backend backend_; // before the wind: keeps its device
    std::unique_ptr<vulkan::Wind> wind_;
    mutable bool read_ = false; ///< cells have come back
};

} // namespace windrow::cases
