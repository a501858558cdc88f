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
    const HoleMask& holes = data.holes;
    if (holes.cells == glm::ivec2(0) && holes.open.empty())
        return {};
    detail::Reasons reasons;
    const detail::FieldPath map{nullptr, "heightmap"}, mask{&map, "holes"};
    detail::check_value(reasons, {&mask, "cells"}, holes.cells, {1.0, HeightMap::k_max_corners});
    if (auto fits = reasons.outcome(); !fits)
        return fits;
    if (holes.open.size() != count_of(holes.cells))
        return Error{
            message("heightmap.holes.open has ", holes.open.size(), " values: give ", count_of(holes.cells), ", one a cell.")};
    return {};
}

} // namespace

HeightMap::HeightMap(HeightData data, Parts parts)
    : data_(std::move(data)), parts_(std::move(parts)), hash_(detail::content_hash(data_.heights)) {}

// From each cell that is in none yet: as far along x as the mask is the same, then as far along z as that whole row is.
Result<HeightMap::Parts> HeightMap::parts_of(const HeightData& data) {
    const glm::vec2 extent = glm::vec2(data.corners - 1) * data.spacing;
    const glm::ivec2 cells = data.holes.cells;
    Parts parts;
    if (data.holes.open.empty()) {
        parts.ground.push_back({glm::vec2(0.0f), extent});
        return parts;
    }
    constexpr std::uint8_t k_taken = 2;
    std::vector<std::uint8_t> mask = data.holes.open;
    const auto at = [&](int x, int z) -> std::uint8_t& {
        return mask[static_cast<std::size_t>(z) * static_cast<std::size_t>(cells.x) + static_cast<std::size_t>(x)];
    };
    const auto place = [&](int x, int z) { return extent * (glm::vec2(x, z) / glm::vec2(cells)); };
    for (int z = 0; z < cells.y; ++z)
        for (int x = 0; x < cells.x; ++x) {
            const std::uint8_t open = at(x, z);
            if (open == k_taken)
                continue;
            int x1 = x + 1, z1 = z + 1;
            while (x1 < cells.x && at(x1, z) == open)
                ++x1;
            const auto is_same = [&](std::uint8_t cell) { return cell == open; };
            while (z1 < cells.y && std::all_of(&at(x, z1), &at(x, z1) + (x1 - x), is_same))
                ++z1;
            for (int row = z; row < z1; ++row)
                std::fill_n(&at(x, row), x1 - x, k_taken);
            std::vector<Part>& list = open != 0 ? parts.holes : parts.ground;
            list.push_back({place(x, z), place(x1, z1)});
            if (list.size() > k_max_parts)
                return Error{message("heightmap.holes.open cuts the ground into more than ", k_max_parts,
                                     " rectangles: give fewer holes, or with straighter edges.")};
            x = x1 - 1;
        }
    if (parts.ground.empty())
        return Error{"heightmap.holes.open is a hole everywhere: leave the ground out, or give a cell of 0."};
    return parts;
}

Result<HeightMap> HeightMap::create(glm::ivec2 corners, float spacing, std::vector<float> heights) {
    HeightData data{corners, spacing, std::move(heights), {}};
    if (auto checked = check(data); !checked)
        return checked.failure();
    auto parts = parts_of(data);
    return HeightMap(std::move(data), *std::move(parts));
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
        for (std::uint8_t& open : data.holes.open)
            open = open != 0;
        auto parts = parts_of(data);
        if (!parts)
            return parts.failure();
        return std::shared_ptr<const HeightMap>(new HeightMap(std::move(data), *std::move(parts)));
    });
}

HeightMap HeightMap::level() {
    constexpr int corners = 101;
    return *create({corners, corners}, 1.0f, std::vector<float>(corners * corners, 0.0f));
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
    const HoleMask &holes = a.data_.holes, &others = b.data_.holes;
    auto order = first(a) <=> first(b);
    if (order == 0)
        order = detail::compare_content(a.data_.heights, b.data_.heights);
    if (order == 0)
        order = std::tuple(holes.cells.x, holes.cells.y) <=> std::tuple(others.cells.x, others.cells.y);
    return order != 0 ? order : detail::compare_content(holes.open, others.open);
}

} // namespace windrow
