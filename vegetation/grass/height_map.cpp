#include "vegetation/grass/height_map.h"

#include "fluid/validation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace windrow::vegetation::grass {
namespace {

using windrow::detail::message;

constexpr int k_max_corners = 16384; // 1 GiB of heights
constexpr float k_highest = 1e5f;    // [m] beyond it, a float of a height is coarser than a blade is long

windrow::Result<void> check_grid(glm::ivec2 corners, float spacing) {
    windrow::detail::Reasons reasons;
    const windrow::detail::FieldPath map{nullptr, "heightmap"};
    windrow::detail::check_value(reasons, {&map, "corners"}, corners, {2.0, k_max_corners});
    windrow::detail::check_value(reasons, {&map, "spacing"}, spacing, {1e-3, 1e3, "m"});
    return reasons.outcome();
}

std::size_t count_of(glm::ivec2 corners) {
    return static_cast<std::size_t>(corners.x) * static_cast<std::size_t>(corners.y);
}

} // namespace

HeightMap::HeightMap(const windrow::numerics::WindrowGrid& grid, std::vector<float> heights)
    : grid_(grid), heights_(std::move(heights)) {}

windrow::Result<HeightMap> HeightMap::create(glm::ivec2 corners, float spacing, std::vector<float> heights) {
    if (auto fits = check_grid(corners, spacing); !fits)
        return windrow::Error{fits.error()};
    if (heights.size() != count_of(corners))
        return windrow::Error{
            message("heightmap.heights has ", heights.size(), " values: give ", count_of(corners), ", one a corner.")};
    const auto wrong = std::find_if(heights.begin(), heights.end(), [](float h) { return !(std::abs(h) <= k_highest); });
    if (wrong != heights.end())
        return windrow::Error{
            message("heightmap.heights[", wrong - heights.begin(), "] is ", *wrong, " m: give numbers within +-1e5 m.")};
    return HeightMap({corners, glm::vec2(spacing)}, std::move(heights));
}

windrow::Result<HeightMap> HeightMap::create(glm::ivec2 corners, float spacing,
                                             const std::function<float(glm::vec2 place)>& height) {
    if (auto fits = check_grid(corners, spacing); !fits)
        return windrow::Error{fits.error()};
    std::vector<float> heights;
    heights.reserve(count_of(corners));
    for (int z = 0; z < corners.y; ++z)
        for (int x = 0; x < corners.x; ++x)
            heights.push_back(height(spacing * glm::vec2(x, z)));
    return create(corners, spacing, std::move(heights));
}

HeightMap HeightMap::level() {
    constexpr int corners = 101;
    return {{glm::ivec2(corners), glm::vec2(1.0f)}, std::vector<float>(corners * corners, 0.0f)};
}

float HeightMap::height(glm::vec2 place) const {
    return windrow::numerics::windrow_grid_at(view(), grid_, place);
}

float HeightMap::drawn_height(glm::vec2 place) const {
    return windrow::numerics::windrow_grid_drawn_at(view(), grid_, place);
}

glm::vec3 HeightMap::normal(glm::vec2 place) const {
    return windrow::numerics::windrow_grid_normal(view(), grid_, place);
}

glm::vec2 HeightMap::range(glm::vec2 low, glm::vec2 high) const {
    const glm::ivec2 first = windrow::numerics::windrow_grid_place(grid_, low).low;
    const glm::ivec2 last = windrow::numerics::windrow_grid_place(grid_, high).low + 1;
    glm::vec2 found(heights_[static_cast<std::size_t>(first.y) * grid_.corners.x + first.x]);
    for (int z = first.y; z <= last.y; ++z)
        for (int x = first.x; x <= last.x; ++x) {
            const float h = heights_[static_cast<std::size_t>(z) * grid_.corners.x + x];
            found = {std::min(found.x, h), std::max(found.y, h)};
        }
    return found;
}

} // namespace windrow::vegetation::grass
