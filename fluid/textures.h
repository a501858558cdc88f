// Textures of the wind for a shader: one 3D texture of four components, or one of a component per axis, and the block that places
// them in the world.
//
// Texel (i, j, k) of a texture is the velocity, or its component, of cell (i, j, k) at its centre, x fastest, then y, then z.
#pragma once

#include "ambient.h"
#include "api.h"
#include "result.h"
#include "rows.h"

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow {

/// Position of the textures, as a uniform block of std140 layout (nine vec4). Positions are relative to an
/// anchor that the host chooses near its camera, so that a shader in float is as exact 10^6 m away as at the origin.
struct WindowBlock {
    glm::vec3 origin{0.0f}; ///< [m] low corner of the box minus the anchor
    float cell_size = 0.0f; ///< [m]
    glm::vec3 cells{0.0f};  ///< an axis
    float factor = 0.0f;    ///< place of this frame between the last two ticks, 0 to 1; 1 without ticks
    /// [m] Low corner of the last frame's box, minus the anchor: for motion vectors. Without ticks, of the step before, with
    /// `follow` called before `step`.
    alignas(16) glm::vec3 previous_origin{0.0f};
    float rows = 0.0f;                   ///< number of rows where they have heights of their own (FrameBlock::heights); else 0
    alignas(16) glm::vec3 ambient{0.0f}; ///< [m/s] mean wind outside the box; with a profile or gusts see AmbientBlock
    float height = 0.0f;                 ///< [m] of the box
    alignas(16) glm::vec3 low_boundaries{0.0f}; ///< kind of the low boundary of x, y, z: 0 open, 1 wall, 2 periodic
    float wall_per_length = 0.0f; ///< [1/m] the law of the wall over rough ground, as WallLaw (fluid/view.h); all four 0: none
    alignas(16) glm::vec3 high_boundaries{0.0f}; ///< as low_boundaries
    float wall_per_log = 0.0f;                   ///< see wall_per_length
    alignas(16) glm::vec3 blend_centre{0.0f};    ///< [m] centre of the blend zone, minus the anchor
    float blend_width = 0.0f;                    ///< [m] over which the box's wind fades to ambient
    alignas(16) glm::vec3 blend_reach{
        0.0f};                ///< [m] distance from that point at which it has faded; 0: no blend zone on that axis
    float wall_lowest = 0.0f; ///< [m] see wall_per_length
    alignas(16) glm::vec3 previous_blend_centre{0.0f}; ///< [m] the point in the last frame, minus the anchor
    float wall_fall = 0.0f;                            ///< see wall_per_length
};
static_assert(sizeof(WindowBlock) == 144);

/// Nearest half (IEEE binary16) of a float, ties to even; beyond 65504 it is 65504 with the sign, NaN is 0: a texture never holds
/// infinity.
[[nodiscard]] WINDROW_API std::uint16_t to_half(float value);
/// The float that a half stands for.
[[nodiscard]] WINDROW_API float from_half(std::uint16_t half);

/// Copies one component of a field (0 x, 1 y, 2 z) into the caller's memory; sizes must agree.
WINDROW_API void extract_axis(std::span<const glm::vec4> field, int axis, std::span<float> texels);
WINDROW_API void extract_axis(std::span<const glm::vec4> field, int axis, std::span<std::uint16_t> half_texels);

/// Copies a field into the caller's memory, four numbers a cell: its velocity and 0; sizes must agree.
WINDROW_API void pack_vectors(std::span<const glm::vec4> field, std::span<float> texels);
WINDROW_API void pack_vectors(std::span<const glm::vec4> field, std::span<std::uint16_t> half_texels);

/// One axis of a window as factors of the coordinate p [m] from the anchor, so that a shader divides nothing.
struct AxisBlock {
    float texture_scale = 0.0f; ///< [1/m] texture_scale * p + texture_offset is 0 at the box's low boundary and 1 at its high one
    float texture_offset = 0.0f; ///< see texture_scale
    float inner_scale = 0.0f;  ///< [1/m] where |inner_scale * p + inner_offset| <= 1 on all axes, the box's wind has the weight 1
    float inner_offset = 0.0f; ///< see inner_scale
    float edge_scale = 0.0f;   ///< [1/m] one over the width that the box's wind fades over
    float low_edge = 0.0f;     ///< low_edge + edge_scale * p: distance from the low place where it has faded, in such widths
    float high_edge = 0.0f;    ///< high_edge - edge_scale * p: the same from the high place; 1e30 where it does not fade
    float smoothness = 0.0f;   ///< 1: it fades smoothly over a blend zone; 0: linearly over the cell beyond an open boundary
};
/// The three axes of a window.
struct PlaceBlock {
    AxisBlock x{}, y{}, z{};
};
static_assert(sizeof(PlaceBlock) == 96);

/// A uniform block of std140 layout (67 vec4): WindrowFrame and the rows of shaders/coupling/windrow_wind.glsl. Positions are
/// relative to the anchor that it was made for.
struct FrameBlock {
    WindowBlock window{};
    PlaceBlock place{};          ///< of the window
    PlaceBlock previous_place{}; ///< of the frame before, for motion vectors
    AmbientBlock ambient{};
    AmbientBlock previous_ambient{}; ///< of the frame before
    /// [m] Of the rows' centres over the box's low boundary, where WindowBlock::rows is above 0. Four to a vec4.
    std::array<float, k_max_rows> heights{};
};
static_assert(sizeof(FrameBlock) == 560 + 512);

/// The block of a window with its places; all of one anchor. `rows`: of a box that has some.
[[nodiscard]] WINDROW_API FrameBlock frame_block(const WindowBlock& window, const AmbientBlock& ambient,
                                                 const AmbientBlock& previous_ambient, const RowTable* rows = nullptr);

} // namespace windrow
