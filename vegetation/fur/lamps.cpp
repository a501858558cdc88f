#include "vegetation/fur/lamps.h"

#include "vegetation/render/refusals.h"

#include <algorithm>

namespace windrow::vegetation::fur {

windrow::Result<void> validate(std::span<const Lamp> lamps) {
    render::Refusals refusals;
    if (lamps.size() > k_most_lamps)
        refusals.add("lamps are " + std::to_string(lamps.size()) + "; give at most " + std::to_string(k_most_lamps) + ".");
    for (std::size_t n = 0; n < std::min(lamps.size(), k_most_lamps); ++n) {
        const std::string name = "lamps[" + std::to_string(n) + "].";
        for (int axis = 0; axis < 3; ++axis)
            refusals.range((name + "position." + "xyz"[axis]).c_str(), lamps[n].position[axis], -1e9, 1e9);
        for (int channel = 0; channel < 3; ++channel)
            refusals.range((name + "colour." + "rgb"[channel]).c_str(), static_cast<double>(lamps[n].colour[channel]), 0.0, 1e6);
        const float reach = lamps[n].reach;
        if (!(reach > 0.0f && reach <= 1e4f))
            refusals.add(name + "reach is " + std::to_string(reach) + " m; give it a value above 0, at most 10000 m.");
    }
    return refusals.result();
}

} // namespace windrow::vegetation::fur
