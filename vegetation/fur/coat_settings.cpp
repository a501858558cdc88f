#include "vegetation/fur/coat_settings.h"

#include "fluid/core/validation.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::fur {

using windrow::detail::FieldPath, windrow::detail::Reasons;

windrow::Result<void> validate(const CoatSettings& settings) {
    return windrow::detail::validate_settings(settings, "coat");
}

bool keeps_outside(const CoatSettings& settings) {
    return settings.avoids_body && !settings.translated && !settings.mirrored && !settings.bare && !settings.cloud &&
           settings.wind_at != WindAt::pixel;
}

void check_rules(Reasons& reasons, const FieldPath& path, const CoatMaps& maps) {
    if (maps.noise_a.empty() != maps.noise_b.empty())
        reasons.add(FieldPath{&path, maps.noise_a.empty() ? "noise_a" : "noise_b"},
                    " is empty and the other is not: give both, or none.");
}

windrow::Result<void> validate(std::span<const Lamp> lamps) {
    Reasons reasons;
    windrow::detail::check_items(reasons, {nullptr, "lamps"}, lamps, {0.0, k_max_lamps});
    return reasons.outcome();
}

windrow::Result<void> validate(std::span<const Foot> feet) {
    Reasons reasons;
    windrow::detail::check_items(reasons, {nullptr, "feet"}, feet, {0.0, k_max_feet});
    return reasons.outcome();
}

LayerCount layers_at(const CoatSettings& settings, float distance, float top) {
    if (settings.bare)
        return {};
    const CoatLevels& levels = settings.levels;
    const auto all = static_cast<float>(settings.layers.shells);
    const float afar = all * levels.full_until / std::max(distance, levels.full_until);
    const float n = std::clamp(afar, std::min(static_cast<float>(levels.min_shells), all), all);
    LayerCount made;
    made.layers = static_cast<int>(std::ceil(n - 1e-4f));
    made.divisor = settings.layers.reaches_tip || settings.mirrored ? std::max(n - 1.0f, 1.0f) : n;
    made.drawn = made.layers;
    if (!levels.skip_empty || settings.mirrored)
        return made;
    // Heights are (i / divisor)^a; the layer just above the top is drawn too: rays toward lower ones begin there.
    const float last = made.divisor * std::pow(std::clamp(top, 0.0f, 1.0f), 1.0f / settings.layers.spacing);
    made.drawn = std::clamp(static_cast<int>(std::ceil(last)) + 1, 1, made.layers);
    return made;
}

} // namespace windrow::vegetation::fur
