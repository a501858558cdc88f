// Textures of the wind for a vertex stage: one scalar 3D texture per axis, and the block that places them in the world.
//
// Texel (i, j, k) of a texture is the velocity component of cell (i, j, k) at its centre, x fastest, then y, then z.
#pragma once

#include "fluid/ambient.h"
#include "fluid/result.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow {

/// Position of the three textures, as a uniform block of std140 layout (nine vec4). Positions are relative to an
/// anchor that the host chooses near its camera, so that a shader in float is as exact 10^6 m away as at the origin.
struct WindowBlock {
    glm::vec3 origin{0.0f}; ///< [m] low corner of the box minus the anchor
    float cell_size = 0.0f; ///< [m]
    glm::vec3 cells{0.0f};  ///< an axis
    float factor = 0.0f;    ///< place of this frame between the last two ticks, 0 to 1; 1 without ticks
    /// [m] Low corner of the last frame's box, minus the anchor: for motion vectors. Without ticks, of the step before, with
    /// `follow` called before `step`.
    alignas(16) glm::vec3 previous_origin{0.0f};
    alignas(16) glm::vec3 ambient{0.0f};         ///< [m/s] mean wind outside the box; with a profile or gusts see AmbientBlock
    alignas(16) glm::vec3 low_boundaries{0.0f};  ///< kind of the low boundary of x, y, z: 0 open, 1 wall, 2 periodic
    alignas(16) glm::vec3 high_boundaries{0.0f}; ///< as low_boundaries
    alignas(16) glm::vec3 blend_centre{0.0f};    ///< [m] centre of the blend zone, minus the anchor
    float blend_width = 0.0f;                    ///< [m] over which the box's wind fades to ambient
    alignas(16) glm::vec3 blend_reach{
        0.0f}; ///< [m] distance from that point at which it has faded; 0: no blend zone on that axis
    alignas(16) glm::vec3 previous_blend_centre{0.0f}; ///< [m] the point in the last frame, minus the anchor
};
static_assert(sizeof(WindowBlock) == 144);

/// Nearest half (IEEE binary16) of a float, ties to even; beyond 65504 it is 65504 with the sign, NaN is 0: a texture never holds
/// infinity.
[[nodiscard]] std::uint16_t to_half(float value);
/// The float that a half stands for.
[[nodiscard]] float from_half(std::uint16_t half);

/// Copies one component of a field (0 x, 1 y, 2 z) into the caller's memory; sizes must agree.
void extract_axis(std::span<const glm::vec4> field, int axis, std::span<float> texels);
void extract_axis(std::span<const glm::vec4> field, int axis, std::span<std::uint16_t> half_texels);

/// A uniform block of std140 layout (23 vec4): WindrowFrame of shaders/coupling/windrow_wind.glsl. Positions are relative to the
/// anchor that it was made for.
struct FrameBlock {
    WindowBlock window{};
    AmbientBlock ambient{};
    AmbientBlock previous_ambient{}; ///< of the frame before, for motion vectors
};
static_assert(sizeof(FrameBlock) == 368);

} // namespace windrow
