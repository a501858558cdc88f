// The wind of a command, on the backend that it was asked for: the calls of windrow::Wind that commands make (fluid/wind.h says
// more of each).
#pragma once

#include "cli/backend/backend.h"
#include "fluid/wind.h"

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>

namespace windrow::cli {

/// Whether a device times the stages of its steps: its own clock holds each pass back until the one before has ended. The CPU
/// always does.
enum class StageClock : std::uint8_t { off, on };

class CommandWind {
  public:
    [[nodiscard]] static Result<std::unique_ptr<CommandWind>> create(const Config& config, const Backend& backend = {},
                                                                     StageClock clock = StageClock::off);
    virtual ~CommandWind() = default;
    CommandWind(const CommandWind&) = delete;
    CommandWind& operator=(const CommandWind&) = delete;

    /// Reports what this step did, on a device too: there it waits. A device that fails steps no more, and Backend::fault says
    /// why.
    virtual Diagnostics step(double dt) = 0;

    [[nodiscard]] virtual Motors& motors() = 0;
    [[nodiscard]] virtual const Motors& motors() const = 0;
    [[nodiscard]] virtual Result<void> set_sides(const Sides& sides) = 0;
    [[nodiscard]] virtual Result<void> follow(glm::dvec3 point) = 0;
    [[nodiscard]] virtual Result<void> set_floor(double height) = 0;
    virtual void set_velocity(const std::function<glm::vec3(glm::dvec3 centre)>& velocity_at) = 0;
    [[nodiscard]] virtual Result<void> set_velocity(std::span<const glm::vec4> field) = 0;
    virtual void reset() = 0;

    [[nodiscard]] virtual const Config& config() const = 0;
    [[nodiscard]] virtual glm::dvec3 origin() const = 0;
    [[nodiscard]] virtual glm::vec3 ambient() const = 0;
    /// Of now; good until the next step or change. Where a device failed, its cells are no numbers.
    [[nodiscard]] virtual WindView view() const = 0;

    [[nodiscard]] Box box() const { return view().box(); }
    [[nodiscard]] std::span<const glm::vec4> field() const { return view().field(); }
    [[nodiscard]] glm::vec3 velocity(glm::dvec3 position) const { return view().velocity(position); }
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
        view().velocity(positions, velocities);
    }

  protected:
    CommandWind() = default;
};

} // namespace windrow::cli
