// Vertices and keys of plants, for a renderer.
#pragma once

#include "../fluid/api.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace windrow {

/// Vertex of a plant.
struct PlantVertex {
    glm::vec3 position{0.0f};            ///< [m] from the plant's root
    glm::vec3 normal{0.0f, 0.0f, 1.0f};  ///< unit vector
    glm::vec3 tangent{0.0f, 1.0f, 0.0f}; ///< unit vector toward the tip
};

/// Identifier of a plant, the seed of its random numbers: its own place as it is stored, a cell or the bits of its coordinates,
/// never a place relative to a camera.
using PlantKey = glm::uvec2;

/// The key of a place [m], the same in shaders (windrow_place_key).
[[nodiscard]] WINDROW_API PlantKey place_key(float x, float z);
/// [rad] The yaw that a key gives, 0 to 2 pi.
[[nodiscard]] WINDROW_API float plant_yaw(PlantKey key);
/// The factor on the stiffness that a key gives, 1 - spread to 1 + spread.
[[nodiscard]] WINDROW_API float plant_stiffness(PlantKey key, float spread);

} // namespace windrow
