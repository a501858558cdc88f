#include "vegetation/fur/foot.h"

#include "fluid/validation.h"

namespace windrow::vegetation::fur {

windrow::Result<void> validate(std::span<const Foot> feet) {
    windrow::detail::Reasons reasons;
    windrow::detail::check_items(reasons, {nullptr, "feet"}, feet, {0.0, k_most_feet});
    return reasons.outcome();
}

} // namespace windrow::vegetation::fur
