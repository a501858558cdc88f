#include "vegetation/grass/grass_settings.h"

#include "fluid/core/validation.h"

namespace windrow::vegetation::grass {

using windrow::detail::FieldPath;

windrow::Result<void> validate(const GrassSettings& settings) {
    return windrow::detail::validate_settings(settings, "grass");
}

void check_rules(windrow::detail::Reasons& reasons, const FieldPath& path, const GrassSettings& settings) {
    if (!(settings.split_distance < settings.cut_distance))
        reasons.add(FieldPath{&path, "split_distance"}, " is ", settings.split_distance, " m: give less than ",
                    FieldPath{&path, "cut_distance"}, ", which is ", settings.cut_distance, " m.");
    if (settings.far_vertices == 6)
        reasons.add(FieldPath{&path, "far_vertices"}, " is 6: give 5 or 7, rows of two and the tip.");
}

} // namespace windrow::vegetation::grass
