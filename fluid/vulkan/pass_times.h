// Times of the passes of a recording, by the device's clock.
#pragma once

#include <vector>

namespace windrow::vulkan {

struct PassTimes {
    /// [us] From before the first command of the recording to after its last: passes, copies, barriers. It includes what the
    /// clock itself costs, which is most of it where passes take a microsecond.
    double whole_us = 0.0;
    /// [us] Of `whole_us`: the report and what else comes back to the host, passes and barriers; 0 where nothing was read back.
    double read_back_us = 0.0;
    /// One kind of pass, in the order of the step.
    struct Pass {
        const char* name = ""; ///< as in docs/vulkan.md
        int dispatches = 0;    ///< in the recording; those of sub-steps that did not run too
        double us = 0.0;       ///< [us] of all of them, without the barriers around them
    };
    std::vector<Pass> passes;
    /// Dispatches for which the clock had no room: only in recordings of thousands of them.
    int untimed = 0;
};

} // namespace windrow::vulkan
