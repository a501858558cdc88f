// Seven meadows to begin with: what grows on each, in which colours, and how far it bends. After the presets of Pitarch 2023,
// Interactive grass tools with wind by fluid simulation; the values are ours.
#pragma once

#include "examples/render/grass_layer.h"

#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace render {

/// One kind of plant of a look.
struct LookLayer {
    GrassLayerSettings settings{};
    /// Share of the ground, about, on which it does not grow, in patches, 0 (it grows everywhere) to 0.95: flowers in places.
    float bare = 0.0f;
    /// [m] Size of those patches, 0.2 to 1000. Default 4.
    float bare_size = 4.0f;
};

struct GrassLook {
    std::string name{};              ///< for files
    std::vector<LookLayer> layers{}; ///< the ground takes the first one's colours (Scene::look)
    glm::vec2 wind{2.8f, -1.1f};     ///< [m/s] along x and z, that shows it at its best
    float path_width = 0.0f;         ///< [m] of a path along which nothing grows, 0 (none) to 20; plants grow lower beside it
};

/// tall, short, violet, path, yellow, wind, composition: in this order.
[[nodiscard]] std::vector<GrassLook> grass_looks();

/// Where a layer grows: its patches, and not on the path, which winds along z through x = `path_at` [m from the corner].
[[nodiscard]] windrow::Result<grass::PlacementMask> mask_of(const GrassLook& look, const LookLayer& layer,
                                                            const grass::HeightMap& heights, float path_at);

} // namespace render
