// A wind on the CPU or on a Vulkan device, for a caller who asks what a step did before it asks for the next: control is that of
// both (fluid/wind_control.h), and reading too (fluid/wind_reader.h).
#pragma once

#include "fluid/wind.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

    /// Most obstacles whose forces come back from a device (vulkan::Settings::forces); the CPU gives those of all.
    int forces = 0;

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

class BackendWind : public WindControl {
  public:
    /// `outer`: the wind around, on the CPU; null: none.
    [[nodiscard]] static Result<std::unique_ptr<BackendWind>> create(const Config& config, const Backend& backend = {},
                                                                     BackendClock clock = BackendClock::off,
                                                                     std::shared_ptr<const Wind> outer = {});
    /// On the CPU.
    [[nodiscard]] static Result<std::unique_ptr<BackendWind>> create(const Config& config, std::shared_ptr<const Wind> outer);
    /// A wind on the CPU that goes on from what Wind::save returned.
    [[nodiscard]] static Result<std::unique_ptr<BackendWind>>
    load(std::span<const std::byte> bytes, const ParallelFor& parallel_for, std::shared_ptr<const Wind> outer = {});
    virtual ~BackendWind() = default;
    BackendWind(const BackendWind&) = delete;
    BackendWind& operator=(const BackendWind&) = delete;

    /// Reports what this step did, on a device too: there it waits. A device that fails steps no more, and Backend::fault says
    /// why.
    virtual Diagnostics step(double dt) = 0;

    /// The wind itself where it is on the CPU; else null.
    [[nodiscard]] virtual Wind* on_cpu() { return nullptr; }
    /// Of now; what it returns is good until the next step or change.
    [[nodiscard]] virtual WindReader& reader() const = 0;
    /// Where a device failed, its cells are no numbers.
    [[nodiscard]] WindView view() const;
    [[nodiscard]] std::span<const glm::vec4> field() const { return view().field(); }
    [[nodiscard]] glm::vec3 velocity(glm::dvec3 position) const { return view().velocity(position); }
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
        view().velocity(positions, velocities);
    }

    using WindControl::set_velocity;
    /// Throws std::bad_alloc.
    void set_velocity(const std::function<glm::vec3(glm::dvec3 centre)>& velocity_at) {
        if (!WindControl::set_velocity(velocity_at))
            throw std::bad_alloc();
    }

  protected:
    explicit BackendWind(const WindControl& wind) : WindControl(wind) {}

  private:
    [[nodiscard]] virtual bool failed() const { return false; }
    mutable std::vector<glm::vec4> broken_; ///< cells of a device that failed
};

} // namespace windrow::cases
