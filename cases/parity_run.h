// A parity story run on a device and on the CPU, step by step.
#pragma once

#include "cases/parity_story.h"
#include "fluid/parallel.h"
#include "fluid/vulkan/own_device.h"
#include "fluid/vulkan/wind.h"

#include <cstdint>
#include <functional>
#include <string>

namespace windrow::cases {

struct ParityResult {
    std::string name{};
    glm::ivec3 cells{0};
    int steps = 0; ///< compared
    /// Largest difference in a component over the largest component of the CPU's velocity at that moment; NaN where the device
    /// gave one. After the first step, after the last, and the largest of all.
    double first = 0.0, last = 0.0, largest = 0.0;
    double first_bound = 0.0, bound = 0.0; ///< the story's
    /// [m/s] Largest component of the CPU's velocity over the story.
    double largest_component = 0.0;
    int max_substeps = 0;               ///< that the CPU took in a step
    std::int64_t max_limited_cells = 0; ///< whose speed the CPU cut in a step
    int dispatches = 0, barriers = 0;   ///< of the recording that had the most of them
    int messages = 0;                   ///< of the validation layer, where the device has it, while the story ran

    /// Within its bounds, and the layer silent.
    [[nodiscard]] bool pass() const;
};

struct ParitySettings {
    vulkan::Texel texel = vulkan::Texel::single;
    /// 1 to 8. With more than one, frames are submitted without a wait, and each is compared as its read-back comes in.
    int frames_in_flight = 1;
    bool split_planes = false; ///< as on a device whose shared memory holds half a plane
    Simd simd = Simd::best;
    ParallelFor parallel_for{}; ///< of the CPU's wind; results do not depend on it
    /// Asked between steps; true ends the story with the error "stopped".
    std::function<bool()> stopped{};
};

/// The error names the story and what failed: a wind that was rejected, a call of the device.
[[nodiscard]] Result<ParityResult> run_parity(vulkan::OwnDevice& device, const ParityStory& story,
                                              const ParitySettings& settings = {});

} // namespace windrow::cases
