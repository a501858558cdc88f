// A wind on a device for a command, which asks what a step did before it asks for the next: submits, and waits. An engine does
// neither (fluid/vulkan/wind.h).
#pragma once

#include "cases/backend_wind.h"
#include "fluid/vulkan/wind.h"

#include <new>
#include <utility>
#include <vector>

namespace windrow::cases {

class DeviceWind {
  public:
    /// `backend` has a device.
    [[nodiscard]] static Result<DeviceWind> create(const Config& config, const Backend& backend, BackendClock clock);

    /// times_ms.total is the time from the recording to the end on the device; the stages are by the device's clock, 0 without.
    Diagnostics step(double dt) { return run(dt); }
    [[nodiscard]] Motors& motors() { return wind_.motors(); }
    [[nodiscard]] const Motors& motors() const { return std::as_const(wind_).motors(); }
    [[nodiscard]] Obstacles& obstacles() { return wind_.obstacles(); }
    [[nodiscard]] const Obstacles& obstacles() const { return std::as_const(wind_).obstacles(); }
    [[nodiscard]] Result<void> set_boundaries(const Boundaries& boundaries) { return changing().set_boundaries(boundaries); }
    [[nodiscard]] Result<void> follow(glm::dvec3 point) { return changing().follow(point); }
    [[nodiscard]] Result<void> set_floor(double height) { return changing().set_floor(height); }
    void set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) {
        if (!changing().set_velocity(velocity_at))
            throw std::bad_alloc();
    }
    [[nodiscard]] Result<void> set_velocity(std::span<const glm::vec4> field) { return changing().set_velocity(field); }
    void reset() { changing().reset(); }
    [[nodiscard]] const Config& config() const { return wind_.config(); }
    [[nodiscard]] glm::dvec3 origin() const { return wind_.origin(); }
    [[nodiscard]] glm::vec3 ambient() const { return wind_.ambient(); }
    [[nodiscard]] WindView view() const;

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
