#include "vegetation/fur/lamps.h"

#include "fluid/validation.h"

namespace windrow::vegetation::fur {

windrow::Result<void> validate(std::span<const Lamp> lamps) {
    windrow::detail::Reasons reasons;
    windrow::detail::check_items(reasons, {nullptr, "lamps"}, lamps, {0.0, k_most_lamps});
    return reasons.outcome();
}

} // namespace windrow::vegetation::fur
