// View of a frame on the grass: camera, and extent of the sun's shadow map.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>

namespace windrow::vegetation::grass {

/// Positions in shaders are [m] from an anchor near the camera, as the wind's block has them (windrow_wind.glsl): exact however
/// far from the world's origin.
struct GrassCamera {
    /// [m] In the world. The same that `frame_block` got.
    glm::dvec3 anchor{0.0};
    /// From positions relative to the anchor to Vulkan's clip space: depth 0 to 1 over w.
    glm::mat4 view_projection{1.0f};
    /// [m] From the anchor. Distances to blades are taken from here, in the shadow's pass too.
    glm::vec3 eye{0.0f};
    /// The sun's, where grass casts shadows.
    std::optional<glm::mat4> shadow_view_projection{};
};

/// Six planes, dot(xyz, p) + w >= 0 inside, xyz unit vectors: left, right, low, high, near, far.
using Planes = std::array<glm::vec4, 6>;

/// Of what a matrix maps into Vulkan's clip space. `corner` [m] is where the planes' own positions begin, from the matrix's: sums
/// in double. A plane at infinity keeps everything. Based on: Gribb & Hartmann 2001, Fast extraction of viewing frustum planes
/// from the world-view-projection matrix.
[[nodiscard]] Planes frustum_planes(const glm::mat4& view_projection, const glm::dvec3& corner);

} // namespace windrow::vegetation::grass
