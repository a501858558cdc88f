// What a step does where a setting leaves it open: one rule for every backend.
#pragma once

#include "fluid/config.h"

namespace windrow {

/// Direct solves of the pressure around obstacles in a sub-step, on every backend. Two, the first from the pressure of the sub-step
/// before: of the fastest air, one solve leaves up to 5 %, two leave 1.4 % (blocks, balls and walls in 0.6 to 12 m/s, steady and
/// gusty; docs/obstacles.md). Without a past (the first step of a flow, the flow of volume sources) more: two would leave a fifth
/// of what passes through a wall, eight leave a thousandth.
inline constexpr int k_solves = 2, k_first_solves = 8;
[[nodiscard]] inline int pressure_solves(const Config& config, bool has_past) {
    return config.pressure_solves > 0 ? config.pressure_solves : has_past ? k_solves : k_first_solves;
}

/// [s] Of the relaxation to the ambient wind; 0: never. Air that stands in a lee for 10 s would lose 40 % of what sets it apart within
/// 20 s. Any wind destroys the checkerboard that relaxation is for, so a tenth of it is left there.
[[nodiscard]] inline float relaxation_time(const Config& config, bool wind_meets_bodies) {
    if (!config.stages.relaxation)
        return 0.0f;
    return config.relaxation_time.value_or(wind_meets_bodies ? 200.0f : 20.0f);
}

} // namespace windrow
