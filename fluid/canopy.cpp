#include "fluid/canopy.h"

#include "fluid/message.h"

namespace windrow {

Result<void> validate(const Canopy& canopy) {
    detail::Reasons reasons;
    if (!(canopy.height >= 0.0f && canopy.height <= 1000.0f))
        reasons.add("canopy.height is ", canopy.height, " m: give 0 to 1000.");
    if (!(canopy.drag >= 0.0f && canopy.drag <= 1000.0f))
        reasons.add("canopy.drag is ", canopy.drag, " 1/m: give 0 (none) to 1000.");
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

} // namespace windrow
