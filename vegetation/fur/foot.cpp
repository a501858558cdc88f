#include "vegetation/fur/foot.h"

#include "vegetation/render/refusals.h"

#include <algorithm>

namespace windrow::vegetation::fur {

windrow::Result<void> validate(std::span<const Foot> feet) {
    render::Refusals refusals;
    if (feet.size() > k_most_feet)
        refusals.add("feet are " + std::to_string(feet.size()) + "; give at most " + std::to_string(k_most_feet) +
                     ", the nearest ones.");
    for (std::size_t n = 0; n < std::min(feet.size(), k_most_feet); ++n) {
        const std::string name = "feet[" + std::to_string(n) + "].";
        for (int axis = 0; axis < 3; ++axis)
            refusals.range((name + "position." + "xyz"[axis]).c_str(), feet[n].position[axis], -1e10, 1e10);
        const float radius = feet[n].radius;
        if (!(radius > 0.0f && radius <= 1e3f))
            refusals.add(name + "radius is " + std::to_string(radius) + " m; give it a value above 0, at most 1000 m.");
        refusals.range((name + "weight").c_str(), static_cast<double>(feet[n].weight), 0.0, 1.0);
    }
    return refusals.result();
}

} // namespace windrow::vegetation::fur
