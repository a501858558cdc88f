// `windrow bench --backend vulkan`: the step on a device, its passes, and what they are compared with, in turns.
#pragma once

#include "cli/bench/bench_command.h"
#include "cli/bench/vulkan/device_contest.h"
#include "fluid/parallel.h"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace windrow::cli {

/// A step of one config, timed whole up to its read-back, without a timestamp in its midst.
struct DeviceStepResult {
    const char* name = "";
    DeviceSpread us{};
    DeviceSpread read_back_us{};
    int dispatches = 0, barriers = 0; ///< recorded; those of sub-steps that may be chosen and were not too
    double vs_stencil = 0.0, vs_copy = 0.0;
};

struct DevicePassResult {
    std::string name;
    DeviceSpread us{};       ///< of all dispatches of its kind in a step
    int dispatches = 0;      ///< recorded
    int dispatches_ran = 0;  ///< with work groups
    std::uint64_t bytes = 0; ///< that the ones that ran move: Passes::bytes
};

struct DeviceGridResult {
    glm::ivec3 cells{0};
    std::size_t rounds = 0;
    /// The default config, whose sub-steps the device chooses, and one that can choose none.
    std::vector<DeviceStepResult> steps{};
    DeviceSpread stencil_us{}, copy_us{};
    std::vector<DevicePassResult> passes{};
    /// Of the recording whose passes are timed, that of one sub-step: its time up to the read-back, what of it is between passes
    /// (barriers, copies, the clock itself), and the read-back.
    DeviceSpread timed_us{}, between_us{}, read_back_us{};
    std::uint64_t pass_bytes = 0, read_back_bytes = 0;
    std::uint64_t memory_bytes = 0;
    int max_substeps = 0;
    bool slept = false;
    /// Against the CPU, from the same flow by as many steps: largest difference in a component over the largest component.
    double parity = 0.0;
    int parity_steps = 0;
    std::uint64_t all_steps = 0; ///< that the default config was stepped in all
};

struct DeviceBenchResult {
    std::string device, driver, api_version, cpu, compiler, commit;
    bool software = false;
    std::vector<DeviceGridResult> grids{};
};

struct DeviceGridRequest {
    glm::ivec3 cells{0};
    double seconds = 5.0;
    /// Of the CPU's wind that the result is compared with.
    Simd simd = Simd::best;
    ParallelFor parallel_for{};
};

/// Nothing where it was stopped.
[[nodiscard]] Result<std::optional<DeviceGridResult>>
measure_device_grid(vulkan::OwnDevice& own, const DeviceGridRequest& request, const std::function<bool()>& stopped);

/// Opens the device, measures each grid, prints, and keeps the file where one is asked for. Returns the exit code.
[[nodiscard]] int run_device_bench(const BenchRequest& request, const Console& console, const std::function<int()>& stop_signal);

/// The same on a device that is open, without a file: what `windrow check` ends with. Grids as far as it came.
[[nodiscard]] int measure_device(vulkan::OwnDevice& own, const BenchRequest& request, const Console& console,
                                 const std::function<int()>& stop_signal, DeviceBenchResult& result);

void report_device(const DeviceBenchResult& result, const Console& console);
void report_device_grid(const DeviceGridResult& grid, bool software, const Console& console);

[[nodiscard]] nlohmann::ordered_json device_bench(const DeviceBenchResult& result);
/// The same as the text of a file.
[[nodiscard]] std::string device_bench_json(const DeviceBenchResult& result);

} // namespace windrow::cli
