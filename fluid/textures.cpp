#include "fluid/textures.h"

#include "fluid/cpu/kernels/kernels.h"
#include "fluid/view_place.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace windrow {
namespace {

#include "fluid/cpu/kernels/half_text.inl"

// All levels give the same bits.
const cpu::Kernels& kernels() {
    return *cpu::kernels_for(Simd::best);
}

/// An axis of `window` with its low boundary at `origin` [m] and its blend zone around `centre` [m]. In double, since the offsets
/// are differences of large numbers where the anchor is far away.
AxisBlock axis_block(const WindowBlock& window, int axis, double origin, double centre) {
    constexpr double k_infinity = std::numeric_limits<double>::infinity();
    const double cell = window.cell_size;
    const double length = axis == 1 && window.rows > 0.0f ? static_cast<double>(window.height)
                                                          : cell * static_cast<double>(window.cells[axis]),
                 reach = window.blend_reach[axis];
    const double width = reach > 0.0 ? window.blend_width : cell;
    // Where the box's wind has faded: beyond open boundaries, and at the end of a blend zone.
    double low = window.low_boundaries[axis] == 0.0f ? origin - cell : -k_infinity;
    double high = window.high_boundaries[axis] == 0.0f ? origin + length + cell : k_infinity;
    if (reach > 0.0) {
        low = std::max(low, centre - reach);
        high = std::min(high, centre + reach);
    }
    const auto edge = [&](double distance) {
        return std::isfinite(distance) ? static_cast<float>(distance / width) : detail::k_never_fades;
    };
    AxisBlock block{.texture_scale = static_cast<float>(1.0 / length),
                    .texture_offset = static_cast<float>(-origin / length),
                    .edge_scale = static_cast<float>(1.0 / width),
                    .low_edge = edge(-low),
                    .high_edge = edge(high),
                    .smoothness = reach > 0.0 ? 1.0f : 0.0f};
    if (!std::isfinite(low) && !std::isfinite(high))
        return block; // all of the axis is inner
    // Beyond one wall a length of the box counts as inner; further out the edges give the same weight.
    const double inner_low = std::isfinite(low) ? low + width : origin - length;
    const double inner_high = std::isfinite(high) ? high - width : origin + 2.0 * length;
    const double extent = inner_high - inner_low;
    block.inner_scale = extent > 0.0 ? static_cast<float>(2.0 / extent) : 0.0f;
    block.inner_offset = extent > 0.0 ? static_cast<float>(-(inner_low + inner_high) / extent) : 2.0f; // 2: nothing is
    return block;
}

PlaceBlock place_block(const WindowBlock& window, glm::vec3 origin, glm::vec3 centre) {
    const auto axis = [&](int n) {
        return axis_block(window, n, static_cast<double>(origin[n]), static_cast<double>(centre[n]));
    };
    return {.x = axis(0), .y = axis(1), .z = axis(2)};
}

} // namespace

std::uint16_t to_half(float value) {
    return half_of(value);
}

float from_half(std::uint16_t half) {
    const std::uint32_t sign = (half & 0x8000u) << 16;
    const std::uint32_t exponent = (half >> 10) & 0x1fu;
    const std::uint32_t fraction = half & 0x3ffu;
    if (exponent == 0)
        return std::copysign(static_cast<float>(fraction) * 0x1p-24f, std::bit_cast<float>(sign));
    if (exponent == 31)
        return std::bit_cast<float>(sign | 0x7f800000u | (fraction << 13));
    return std::bit_cast<float>(sign | ((exponent + 112u) << 23) | (fraction << 13));
}

void extract_axis(std::span<const glm::vec4> field, int axis, std::span<float> texels) {
    assert(axis >= 0 && axis < 3 && texels.size() == field.size());
    for (std::size_t n = 0; n < field.size(); ++n)
        texels[n] = field[n][axis];
}

void extract_axis(std::span<const glm::vec4> field, int axis, std::span<std::uint16_t> half_texels) {
    assert(axis >= 0 && axis < 3 && half_texels.size() == field.size());
    if (!field.empty())
        kernels().halve_axis(&field.data()->x, field.size(), axis, half_texels.data());
}

void pack_vectors(std::span<const glm::vec4> field, std::span<float> texels) {
    assert(texels.size() == 4 * field.size());
    for (std::size_t n = 0; n < field.size(); ++n)
        for (int axis = 0; axis < 4; ++axis)
            texels[4 * n + static_cast<std::size_t>(axis)] = axis < 3 ? field[n][axis] : 0.0f;
}

void pack_vectors(std::span<const glm::vec4> field, std::span<std::uint16_t> half_texels) {
    assert(half_texels.size() == 4 * field.size());
    if (!field.empty())
        kernels().halve_vectors(&field.data()->x, field.size(), half_texels.data());
}

FrameBlock frame_block(const WindowBlock& window, const AmbientBlock& ambient, const AmbientBlock& previous_ambient,
                       const RowTable* rows) {
    FrameBlock block{.window = window,
                     .place = place_block(window, window.origin, window.blend_centre),
                     .previous_place = place_block(window, window.previous_origin, window.previous_blend_centre),
                     .ambient = ambient,
                     .previous_ambient = previous_ambient};
    if (rows != nullptr)
        std::ranges::copy(rows->centres(), block.heights.begin());
    return block;
}

} // namespace windrow
