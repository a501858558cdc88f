// How many layers a coat is drawn in, by its distance, and which of them could show anything.
#pragma once

#include "vegetation/fur/coat_settings.h"

namespace windrow::vegetation::fur {

struct LayerCount {
    float divisor = 1.0f; ///< of a layer's number: its place in the strand is i / divisor, held at 1
    int layers = 1;       ///< that exist at this distance
    int drawn = 1;        ///< the inner ones of them; the others lie above every strand's tip
};

/// At a distance [m] from the eye. Their number goes by a continuous one, n: layer i lies at i / (n - 1), so that a layer that
/// comes with a growing n begins where the outermost already is, and nothing pops. `top` is the largest height at which any
/// strand shows, 0 to 1.
[[nodiscard]] LayerCount layers_at(const CoatSettings& settings, float distance, float top);

} // namespace windrow::vegetation::fur
