// The figures that `windrow bench --backend vulkan` finds.
#pragma once

#include "cli/bench/vulkan/device_contest.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace windrow::cli {

/// A step of one config, timed whole, without a timestamp in its midst.
struct DeviceStepResult {
    const char* name = "";
    DeviceSpread us{};
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
    /// Of the recording whose passes are timed: whole, and what lies between its passes (barriers, copies, the clock itself).
    DeviceSpread timed_us{}, between_us{};
    std::uint64_t pass_bytes = 0, read_back_bytes = 0;
    std::uint64_t memory_bytes = 0;
    int most_substeps = 0;
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

} // namespace windrow::cli
