// How many times a step solves for the pressure.
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

} // namespace windrow
