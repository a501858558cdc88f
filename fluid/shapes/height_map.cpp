#include "fluid/shapes/height_map.h"

#include "fluid/core/message.h"
#include "fluid/core/validation.h"
#include "fluid/solids/content.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

namespace windrow {
namespace {

using detail::message;

Result<void> check_grid(glm::ivec2 corners, float spacing) {
    detail::Reasons reasons;
    const detail::FieldPath map{nullptr, "heightmap"};
    detail::check_value(reasons, {&map, "corners"}, corners, {2.0, HeightMap::k_max_corners});
    detail::check_value(reasons, {&map, "spacing"}, spacing, {1e-3, 1e3, "m"});
    return reasons.outcome();
}

std::size_t count_of(glm::ivec2 corners) {
    return static_cast<std::size_t>(corners.x) * static_cast<std::size_t>(corners.y);
}

Result<void> check(const HeightData& data) {
    if (auto fits = check_grid(data.corners, data.spacing); !fits)
        return fits;
    const std::vector<float>& heights = data.heights;
    if (heights.size() != count_of(data.corners))
        return Error{
            message("heightmap.heights has ", heights.size(), " values: give ", count_of(data.corners), ", one a corner.")};
    const auto wrong =
        std::find_if(heights.begin(), heights.end(), [](float h) { return !(std::abs(h) <= HeightMap::k_highest); });
    if (wrong != heights.end())
        return Error{message("heightmap.heights[", wrong - heights.begin(), "] is ", *wrong, " m: give numbers within +-1e5 m.")};
    return {};
}

} // namespace

HeightMap::HeightMap(HeightData data) : data_(std::move(data)), hash_(detail::content_hash(data_.heights)) {}

Result<HeightMap> HeightMap::create(glm::ivec2 corners, float spacing, std::vector<float> heights) {
    HeightData data{corners, spacing, std::move(heights)};
    if (auto checked = check(data); !checked)
        return checked.failure();
    return HeightMap(std::move(data));
}

Result<HeightMap> HeightMap::create(glm::ivec2 corners, float spacing, const std::function<float(glm::vec2 place)>& height) {
    if (auto fits = check_grid(corners, spacing); !fits)
        return fits.failure();
    std::vector<float> heights;
    heights.reserve(count_of(corners));
    for (int z = 0; z < corners.y; ++z)
        for (int x = 0; x < corners.x; ++x)
            heights.push_back(height(spacing * glm::vec2(x, z)));
    return create(corners, spacing, std::move(heights));
}

Result<std::shared_ptr<const HeightMap>> HeightMap::create(HeightData data) {
    return detail::where_memory_lasts([&]() -> Result<std::shared_ptr<const HeightMap>> {
        if (auto checked = check(data); !checked)
            return checked.failure();
        return std::shared_ptr<const HeightMap>(new HeightMap(std::move(data)));
    });
}

HeightMap HeightMap::level() {
    constexpr int corners = 101;
    return HeightMap({glm::ivec2(corners), 1.0f, std::vector<float>(corners * corners, 0.0f)});
}

float HeightMap::height(glm::vec2 place) const {
    return numerics::windrow_grid_at(view(), grid(), place);
}

float HeightMap::drawn_height(glm::vec2 place) const {
    return numerics::windrow_grid_drawn_at(view(), grid(), place);
}

glm::vec3 HeightMap::normal(glm::vec2 place) const {
    return numerics::windrow_grid_normal(view(), grid(), place);
}

glm::vec2 HeightMap::range(glm::vec2 low, glm::vec2 high) const {
    const glm::ivec2 first = numerics::windrow_grid_place(grid(), low).low;
    const glm::ivec2 last = numerics::windrow_grid_place(grid(), high).low + 1;
    const std::size_t across = static_cast<std::size_t>(data_.corners.x);
    glm::vec2 found(data_.heights[static_cast<std::size_t>(first.y) * across + static_cast<std::size_t>(first.x)]);
    for (int z = first.y; z <= last.y; ++z)
        for (int x = first.x; x <= last.x; ++x) {
            const float h = data_.heights[static_cast<std::size_t>(z) * across + static_cast<std::size_t>(x)];
            found = {std::min(found.x, h), std::max(found.y, h)};
        }
    return found;
}

std::strong_ordering operator<=>(const HeightMap& a, const HeightMap& b) {
    if (&a == &b)
        return std::strong_ordering::equal;
    const auto first = [](const HeightMap& map) {
        return std::tuple(map.hash_, map.data_.corners.x, map.data_.corners.y, std::bit_cast<std::uint32_t>(map.data_.spacing));
    };
    const auto order = first(a) <=> first(b);
    return order != 0 ? order : detail::compare_content(a.data_.heights, b.data_.heights);
}

} // namespace windrow
