// The air of a picture, stepped on the device or on the CPU: one wind for what moves in it and what samples it.
#pragma once

#include "fluid/thread_pool.h"
#include "fluid/vulkan/wind.h"
#include "vegetation/vulkan/frames.h"
#include "vegetation/vulkan/wind_set.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace windrow::vegetation::program {

/// Solver of the air.
enum class Backend { cpu, vulkan };

struct AirSettings {
    std::optional<Backend> backend{}; ///< default: vulkan on a GPU, cpu on a software device, where it is the faster one
    bool pass_times = false;          ///< of the passes on the device
    bool queries = false;             ///< `velocity` is asked: a wind on the device reads its cells back each frame
    int forces = 0;                   ///< obstacles whose forces are asked; on the CPU all have them
    bool gusts = false;               ///< gusts may begin later
};

class Air {
  public:
    /// Rejects what the wind rejects. The device outlives it. `outer`: the wind around, which the host advances first; null: none.
    [[nodiscard]] static Result<Air> create(engine::Device& device, Config config, const AirSettings& settings,
                                            const std::shared_ptr<const Wind>& outer = {});
    /// Air that goes on from what `save` or Wind::save returned, on either solver. Rejects what their `load` rejects.
    /// `outer`: as `create` takes it.
    [[nodiscard]] static Result<Air> load(engine::Device& device, std::span<const std::byte> bytes, const AirSettings& settings,
                                          const std::shared_ptr<const Wind>& outer = {});
    /// The whole state as bytes, as Wind::save returns them. Of a wind on the device it submits a frame and waits for it.
    [[nodiscard]] Result<std::vector<std::byte>> save(engine::Frames& frames);

    [[nodiscard]] WindControl& control() { return *control_; }
    /// On the CPU of the last frame; on the device of the last one that was read back, k_frames_in_flight before.
    [[nodiscard]] const WindReader& reader() const { return *reader_; }
    [[nodiscard]] WindReader& reader() { return *reader_; }
    [[nodiscard]] const WindControl& control() const { return *control_; }

    /// The next `dt` [s], in ticks.
    Result<void> record(const engine::Frame& frame, double dt);
    /// The air as it stands, which its host has stepped through `cpu`.
    Result<void> show(const engine::Frame& frame);
    /// The wind on the CPU; null where the device runs it.
    [[nodiscard]] Wind* cpu() { return cpu_ ? &cpu_->air() : nullptr; }
    [[nodiscard]] engine::SampledWind sampled() const;

    [[nodiscard]] Backend backend() const { return cpu_ ? Backend::cpu : Backend::vulkan; }
    /// [us] The last frame's steps by the wall's clock; 0 on the device, whose own clock times them.
    [[nodiscard]] double cpu_us() const { return cpu_us_; }
    [[nodiscard]] std::optional<windrow::vulkan::PassTimes> pass_times() const;
    /// [bytes] Device memory in use, and taken for it.
    [[nodiscard]] std::uint64_t memory_bytes() const;
    [[nodiscard]] std::uint64_t reserved_bytes() const;

  private:
    Air() = default;
    Air(std::unique_ptr<ThreadPool> threads, std::unique_ptr<engine::CpuWind> wind);
    explicit Air(windrow::vulkan::Wind wind);

    std::unique_ptr<windrow::vulkan::Wind> device_{}; ///< this, or the next two
    std::unique_ptr<ThreadPool> threads_{};
    std::unique_ptr<engine::CpuWind> cpu_{};
    WindControl* control_ = nullptr; ///< of either
    WindReader* reader_ = nullptr;
    double cpu_us_ = 0.0;
};

} // namespace windrow::vegetation::program
