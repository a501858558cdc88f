#include "vegetation/fur/coat_settings.h"

#include "fluid/validation.h"

namespace windrow::vegetation::fur {

using windrow::detail::FieldPath, windrow::detail::Reasons;

windrow::Result<void> validate(const CoatSettings& settings) {
    return windrow::detail::validate_settings(settings, "coat");
}

void check_rules(Reasons& reasons, const FieldPath& path, const CoatMaps& maps) {
    if (maps.noise_a.empty() != maps.noise_b.empty())
        reasons.add(FieldPath{&path, maps.noise_a.empty() ? "noise_a" : "noise_b"},
                    " is empty beside the other: give both, or none.");
}

} // namespace windrow::vegetation::fur
