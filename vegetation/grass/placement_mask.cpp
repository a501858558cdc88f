#include "vegetation/grass/placement_mask.h"

#include "fluid/core/validation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace windrow::vegetation::grass {
namespace {

// The nearest value that 16 bits hold.
float whole(float alpha) {
    return alpha > 0.0f ? std::round(std::min(alpha, 1.0f) * 65535.0f) / 65535.0f : 0.0f; // NaN: 0
}

windrow::Result<void> check(glm::ivec2 corners, glm::vec2 extent, float alpha) {
    windrow::detail::Reasons reasons;
    const windrow::detail::FieldPath mask{nullptr, "mask"};
    windrow::detail::check_value(reasons, {&mask, "corners"}, corners, {2.0, 16384.0});
    windrow::detail::check_value(reasons, {&mask, "extent"}, extent, {1e-3, 1e6, "m"});
    windrow::detail::check_value(reasons, {&mask, "alpha"}, alpha, k_fraction_range);
    return reasons.outcome();
}

// Share of the strength at r, 0 at the middle, 1 at the radius.
float share_at(float r, float hardness) {
    if (r >= 1.0f)
        return 0.0f;
    if (r <= hardness)
        return 1.0f;
    const float out = (r - hardness) / (1.0f - hardness);
    const float rest = 1.0f - out * out;
    return rest * rest;
}

} // namespace

PlacementMask::PlacementMask(const windrow::numerics::WindrowGrid& grid, std::vector<float> values)
    : grid_(grid), values_(std::move(values)) {}

windrow::Result<PlacementMask> PlacementMask::create(glm::ivec2 corners, glm::vec2 extent, float alpha) {
    if (auto fits = check(corners, extent, alpha); !fits)
        return fits.failure();
    const std::size_t count = static_cast<std::size_t>(corners.x) * static_cast<std::size_t>(corners.y);
    return PlacementMask({corners, extent / glm::vec2(corners - 1)}, std::vector<float>(count, whole(alpha)));
}

windrow::Result<Touched> PlacementMask::stroke(const Brush& brush, float sign) {
    if (auto fits = windrow::detail::validate_settings(brush, "brush"); !fits)
        return fits.failure();
    const glm::vec2 low = brush.centre - brush.radius, high = brush.centre + brush.radius;
    const glm::vec2 last(grid_.corners - 1);
    const glm::ivec2 first(glm::clamp(glm::floor(low / grid_.spacing), glm::vec2(0.0f), last));
    const glm::ivec2 end(glm::clamp(glm::ceil(high / grid_.spacing), glm::vec2(0.0f), last));
    for (int z = first.y; z <= end.y; ++z)
        for (int x = first.x; x <= end.x; ++x) {
            const glm::vec2 place = glm::vec2(x, z) * grid_.spacing;
            const float share = share_at(glm::length(place - brush.centre) / brush.radius, brush.hardness);
            float& value = values_[static_cast<std::size_t>(z) * grid_.corners.x + x];
            value = whole(value + sign * brush.strength * share);
        }
    // A corner's value reaches to its neighbours.
    return Touched{low - grid_.spacing, high + grid_.spacing};
}

windrow::Result<Touched> PlacementMask::paint(const Brush& brush) {
    return stroke(brush, 1.0f);
}
windrow::Result<Touched> PlacementMask::erase(const Brush& brush) {
    return stroke(brush, -1.0f);
}

Touched PlacementMask::apply(const std::function<float(glm::vec2 place, float alpha)>& change) {
    for (int z = 0; z < grid_.corners.y; ++z)
        for (int x = 0; x < grid_.corners.x; ++x) {
            float& value = values_[static_cast<std::size_t>(z) * grid_.corners.x + x];
            value = whole(change(glm::vec2(x, z) * grid_.spacing, value));
        }
    return {glm::vec2(0.0f), extent()};
}

float PlacementMask::alpha(glm::vec2 place) const {
    return windrow::numerics::windrow_grid_at(windrow::numerics::GridView{values_.data()}, grid_, place);
}

bool PlacementMask::grows(glm::vec2 low, glm::vec2 high) const {
    const glm::ivec2 first = windrow::numerics::windrow_grid_place(grid_, low).low;
    const glm::ivec2 last = windrow::numerics::windrow_grid_place(grid_, high).low + 1;
    for (int z = first.y; z <= last.y; ++z)
        for (int x = first.x; x <= last.x; ++x)
            if (values_[static_cast<std::size_t>(z) * grid_.corners.x + x] > 0.0f)
                return true;
    return false;
}

} // namespace windrow::vegetation::grass
