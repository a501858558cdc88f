// Clock that divides the time of frames into fixed ticks.
#pragma once

#include "fluid/wind.h"

#include <algorithm>
#include <cmath>

namespace windrow {

struct TickClock {
    double lead = 0.0; ///< [s] time of the frame after the last tick, 0 <= lead < one tick

    /// Ticks of a frame.
    struct Due {
        int ticks = 0;        ///< to run
        double dropped = 0.0; ///< [s] beyond Ticks::max_per_call
    };
    /// Adds a frame of dt [s] and spends all whole ticks.
    [[nodiscard]] Due spend(double dt, const Ticks& ticks) {
        constexpr double k_rounding = 1e-9; // of a tick: sums of frame times meet tick times only so nearly
        const double duration = 1.0 / ticks.hz, most = ticks.max_per_call;
        lead += dt;
        const double due = std::floor(lead * ticks.hz + k_rounding);
        Due spent{.ticks = static_cast<int>(std::min(due, most))};
        if (due > most)
            spent.dropped = (due - most) * duration;
        lead -= spent.dropped;
        for (int n = 0; n < spent.ticks; ++n)
            lead -= duration;
        lead = std::max(0.0, lead);
        return spent;
    }
    /// Position of the frame between the last two ticks, 0 to 1.
    [[nodiscard]] double factor(const Ticks& ticks) const { return lead * ticks.hz; }
};

} // namespace windrow
