#include "fluid/textures.h"

#include "fluid/core/view_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace windrow {
namespace {

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
