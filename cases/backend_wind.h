// A wind on the CPU or on a Vulkan device, for a caller who asks what a step did before it asks for the next: the calls of
// windrow::Wind that such a caller makes (fluid/wind.h says more of each).
#pragma once

#include "fluid/wind.h"

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace windrow::vulkan {
class OwnDevice;
}

namespace windrow::cases {

enum class BackendKind : std::uint8_t {
    cpu,   ///< the default
    vulkan ///< a Vulkan device
};

[[nodiscard]] inline const char* name_of(BackendKind kind) {
    return kind == BackendKind::vulkan ? "vulkan" : "cpu";
}

/// What runs the air: the CPU, or a device that is opened once and shared by all its winds.
class Backend {
  public:
    Backend() = default; ///< the CPU
    /// `words`: the device's name, driver and version.
    Backend(std::shared_ptr<vulkan::OwnDevice> device, std::string words)
        : device_(std::move(device)), words_(std::move(words)) {}

    [[nodiscard]] bool is_cpu() const { return device_ == nullptr; }
    [[nodiscard]] BackendKind kind() const { return is_cpu() ? BackendKind::cpu : BackendKind::vulkan; }
    /// Null: the CPU.
    [[nodiscard]] vulkan::OwnDevice* device() const { return device_.get(); }
    /// Empty: the CPU.
    [[nodiscard]] const std::string& device_words() const { return words_; }

    /// The first thing that went wrong on the device, in a sentence; empty: nothing. A wind of a device that is lost steps no
    /// more.
    [[nodiscard]] const std::string& fault() const { return *fault_; }
    void note_fault(const std::string& sentence) const {
        if (fault_->empty())
            *fault_ = sentence;
    }

  private:
    std::shared_ptr<vulkan::OwnDevice> device_{};
    std::string words_{};
    std::shared_ptr<std::string> fault_ = std::make_shared<std::string>(); ///< one for all copies
};

/// Whether a device times the stages of its steps: its own clock holds each pass back until the one before has ended. The CPU
/// always does.
enum class BackendClock : std::uint8_t { off, on };

class BackendWind {
  public:
    [[nodiscard]] static Result<std::unique_ptr<BackendWind>> create(const Config& config, const Backend& backend = {},
                                                                     BackendClock clock = BackendClock::off);
    ~BackendWind();
    BackendWind(const BackendWind&) = delete;
    BackendWind& operator=(const BackendWind&) = delete;

    /// Reports what this step did, on a device too: there it waits. A device that fails steps no more, and Backend::fault says
    /// why.
    Diagnostics step(double dt);

    [[nodiscard]] Motors& motors();
    [[nodiscard]] const Motors& motors() const;
    [[nodiscard]] Obstacles& obstacles();
    [[nodiscard]] const Obstacles& obstacles() const;
    [[nodiscard]] Result<void> set_boundaries(const Boundaries& boundaries);
    [[nodiscard]] Result<void> follow(glm::dvec3 point);
    [[nodiscard]] Result<void> set_floor(double height);
    void set_velocity(const std::function<glm::vec3(glm::dvec3 centre)>& velocity_at);
    [[nodiscard]] Result<void> set_velocity(std::span<const glm::vec4> field);
    void reset();

    [[nodiscard]] const Config& config() const;
    [[nodiscard]] glm::dvec3 origin() const;
    [[nodiscard]] glm::vec3 ambient() const;
    /// Of now; good until the next step or change. Where a device failed, its cells are no numbers.
    [[nodiscard]] WindView view() const;

    /// None on a device, which has no obstacles.
    Result<void> write_obstacles(std::span<float> cells) const;
    /// Rejected on a device, which hands out no pressure.
    Result<void> write_pressure(std::span<float> cells);
    [[nodiscard]] Box box() const { return view().box(); }
    [[nodiscard]] std::span<const glm::vec4> field() const { return view().field(); }
    [[nodiscard]] glm::vec3 velocity(glm::dvec3 position) const { return view().velocity(position); }
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
        view().velocity(positions, velocities);
    }

  private:
    struct EitherWind; // a windrow::Wind, or a DeviceWind
    explicit BackendWind(std::unique_ptr<EitherWind> wind);
    std::unique_ptr<EitherWind> wind_;
};

} // namespace windrow::cases
