#include "vegetation/trees/stand_settings.h"

#include "fluid/core/validation.h"

namespace windrow::vegetation::trees {

windrow::Result<void> validate(const TreeStandSettings& stand) {
    windrow::detail::Reasons reasons;
    for (const windrow::Result<void>& judged :
         {validate(stand.kind.tree), validate(stand.kind.look), validate(stand.kind.levels)})
        reasons.add_all_of(judged);
    windrow::detail::check_settings(reasons, {nullptr, "stand"}, stand);
    return reasons.outcome();
}

windrow::Result<std::vector<TreePlace>> places_of(const TreeStandSettings& stand, const GroundHeight& ground) {
    if (auto judged = validate(stand); !judged)
        return judged.failure();
    std::vector<TreePlace> places = stand.places;
    auto scattered = scatter(stand.scatter, ground);
    if (!scattered)
        return scattered.failure();
    places.insert(places.end(), scattered->begin(), scattered->end());
    return places;
}

} // namespace windrow::vegetation::trees
