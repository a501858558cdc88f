// A wind on a device for a command, which asks what a step did before it asks for the next: submits, and waits. An engine does
// neither (fluid/vulkan/wind.h).
#pragma once

#include "cases/backend_wind.h"
#include "fluid/vulkan/wind.h"

#include <new>
#include <utility>
#include <vector>

namespace windrow::cases {

class DeviceWind final : public BackendWind {
  public:
    /// `backend` has a device.
    [[nodiscard]] static Result<std::unique_ptr<BackendWind>> create(const Config& config, const Backend& backend,
                                                                     StageClock clock);

    /// times_ms.total is the time from the recording to the end on the device; the stages are by the device's clock, 0 without.
    Diagnostics step(double dt) override { return run(dt); }
    Motors& motors() override { return wind_.motors(); }
    const Motors& motors() const override { return std::as_const(wind_).motors(); }
    Result<void> set_sides(const Sides& sides) override { return changing().set_sides(sides); }
    Result<void> follow(glm::dvec3 point) override { return changing().follow(point); }
    Result<void> set_floor(double height) override { return changing().set_floor(height); }
    void set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) override {
        if (!changing().set_velocity(velocity_at))
            throw std::bad_alloc();
    }
    Result<void> set_velocity(std::span<const glm::vec4> field) override { return changing().set_velocity(field); }
    void reset() override { changing().reset(); }
    const Config& config() const override { return wind_.config(); }
    glm::dvec3 origin() const override { return wind_.origin(); }
    glm::vec3 ambient() const override { return wind_.ambient(); }
    WindView view() const override;

  private:
    DeviceWind(const Backend& backend, vulkan::Wind wind) : backend_(backend), wind_(std::move(wind)), box_(wind_.box()) {}

    vulkan::Wind& changing() {
        read_ = false;
        return wind_;
    }
    /// Runs a step, or with a dt of 0 what was asked for alone, and takes the read-back.
    Diagnostics run(double dt) const;

    Backend backend_;           // before the wind: keeps its device
    mutable vulkan::Wind wind_; // a view may have to fetch what the device holds: nothing that a caller sees changes
    mutable bool read_ = false; ///< the read-back is of now
    Box box_;                   ///< of the view of a device that failed, ...
    mutable std::vector<glm::vec4> broken_{}; ///< ... and its cells
};

} // namespace windrow::cases
