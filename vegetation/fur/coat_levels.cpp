#include "vegetation/fur/coat_levels.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::fur {

LayerCount layers_at(const CoatSettings& settings, float distance, float top) {
    if (settings.bare)
        return {};
    const CoatLevels& levels = settings.levels;
    const auto all = static_cast<float>(settings.layers.shells);
    const float afar = all * levels.full_until / std::max(distance, levels.full_until);
    const float n = std::clamp(afar, std::min(static_cast<float>(levels.least_shells), all), all);
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
