#include "vegetation/grass/mask_patterns.h"

#include "fluid/core/validation.h"

#include <cmath>
#include <glm/common.hpp>

namespace windrow::vegetation::grass {

using windrow::numerics::windrow_place_noise;

windrow::Result<void> thin_out(PlacementMask& mask, const BarePatches& patches) {
    if (auto judged = windrow::detail::validate_settings(patches, "mask"); !judged || patches.share == 0.0f)
        return judged;
    const float shift = 13.7f * static_cast<float>(patches.seed % 64u);
    mask.apply([&](glm::vec2 place, float alpha) {
        // Two octaves, whose sum lies about 1/2.
        const glm::vec2 at = place / patches.size + shift;
        const float noise = 0.7f * windrow_place_noise(at) + 0.3f * windrow_place_noise(2.7f * at + 5.0f);
        const float above = noise + 0.5f * (patches.share - 0.5f);
        return alpha * glm::smoothstep(patches.share - 0.12f, patches.share + 0.08f, above);
    });
    return {};
}

windrow::Result<void> tread(PlacementMask& mask, const FootPath& path) {
    if (auto judged = windrow::detail::validate_settings(path, "mask.path"); !judged || path.width == 0.0f)
        return judged;
    mask.apply([&](glm::vec2 place, float alpha) {
        const float middle = path.at + 1.1f * std::sin(0.21f * place.y) + 0.5f * std::sin(0.47f * place.y + 1.0f);
        const float beside = std::abs(place.x - middle) / (0.5f * path.width);
        const float ragged = 0.25f * (windrow_place_noise(place / 0.35f) - 0.5f);
        return alpha * glm::smoothstep(0.75f, 1.9f, beside + ragged);
    });
    return {};
}

} // namespace windrow::vegetation::grass
