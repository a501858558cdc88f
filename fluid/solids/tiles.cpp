// Tiles of ground among the bodies of a box: which stand beside which, the surface that one is drawn from, how thick that is.
#include "fluid/solids/body_view.h"
#include "fluid/solids/solids.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <utility>

namespace windrow {
namespace {

constexpr float k_apart_at_most = 1e-3f; // [cells] between bodies that touch
constexpr float k_farthest_row = 16.0f;  // [cells] what is as thick counts as thicker than any read is long
constexpr float k_row_step = 0.25f;      // [cells] a gap that is thinner may be missed

// Whether a tile and another one, that stands `from` [m] it, are within so many metres.
bool are_within(float margin, const detail::Extent& tile, const detail::Extent& other, glm::vec3 from) {
    const glm::vec3 gap = glm::max(from + other.low - tile.high, tile.low - from - other.high);
    return gap.x <= margin && gap.z <= margin;
}

} // namespace

// The tiles among the bodies, with a number for each kind of them.
void Solids::find_tiles() {
    ground_of_.first = bodies_.size(); // none
    tiles_.clear();
    tile_of_.assign(bodies_.size(), k_none);
    kinds_.clear();
    for (std::size_t n = 0; n < bodies_.size(); ++n)
        if (TiledGround::is_tile(bodies_[n])) {
            tile_of_[n] = static_cast<std::uint32_t>(tiles_.size());
            kinds_.emplace_back(bodies_[n], tile_of_[n]);
            kinds_.back().first.position = glm::vec3(0.0f);
            tiles_.push_back({.body = n, .extent = detail::extent_of(bodies_[n]), .kind = 0});
        }
    std::sort(kinds_.begin(), kinds_.end(), [](const auto& a, const auto& b) { return detail::precedes(a.first, b.first); });
    std::uint32_t kind = 0;
    for (std::size_t n = 0; n < kinds_.size(); ++n) {
        kind += n > 0 && detail::precedes(kinds_[n - 1].first, kinds_[n].first) ? 1 : 0;
        tiles_[kinds_[n].second].kind = kind;
    }
}

void Solids::find_tiles_beside(std::size_t body) {
    const glm::ivec3 images(box_.boundaries.periodic(0), 0, box_.boundaries.periodic(2));
    const float margin = beside_margin();
    const detail::Extent& own = tiles_[tile_of_[body]].extent;
    for (const Tile& tile : tiles_) {
        if (tile.body == body)
            continue;
        const glm::vec3 from = bodies_[tile.body].position - bodies_[body].position;
        bool near = false;
        for (int z = -images.z; z <= images.z; ++z)
            for (int x = -images.x; x <= images.x; ++x)
                near = near || are_within(margin, own, tile.extent, from + glm::vec3(x, 0, z) * box_.size());
        if (!near)
            continue;
        beside_.push_back(bodies_[tile.body]);
        beside_.back().position = from;
    }
}

// [m] Cells within it may touch two tiles.
float Solids::beside_margin() const {
    return 2.0f * View::k_far * box_.coarsest();
}

// Whether a body closes all faces of the cells whose centres it holds.
bool Solids::is_tight(std::size_t number, float thickness) const {
    return !std::holds_alternative<Plate>(bodies_[number].shape) && thickness < k_thin_wall * box_.coarsest();
}

// [m] Of a body with those that it touches beyond its broad sides; of a tile with those in a row, along the one of its axes along which that is less: a wall of tiles is as
// thin as they are, a plateau of tiles is not.
float Solids::find_thickness(std::size_t number) {
    const PlacedObstacle& body = bodies_[number];
    const float own = detail::thickness(wholes_.of(number).shape), far = k_farthest_row * box_.coarsest();
    if (own >= far)
        return own;
    if (tile_of_[number] == k_none)
        return thickness_together(number, own, far);

    const glm::ivec3 images(box_.boundaries.periodic(0), 0, box_.boundaries.periodic(2));
    const detail::Extent& extent = tiles_[tile_of_[number]].extent;
    near_.clear();
    for (const Tile& tile : tiles_)
        for (int z = -images.z; z <= images.z; ++z)
            for (int x = -images.x; x <= images.x; ++x) {
                const glm::vec3 place = bodies_[tile.body].position + glm::vec3(x, 0, z) * box_.size();
                if ((tile.body != number || x != 0 || z != 0) && are_within(far, extent, tile.extent, place - body.position))
                    near_.push_back({&bodies_[tile.body], place, place + tile.extent.low, place + tile.extent.high});
            }
    const glm::vec2 last = detail::whole_of(std::get<Ground>(body.shape)).last;
    float least = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; axis += 2) {
        const float width = axis == 0 ? last.x : last.y;
        const glm::vec3 way = body.axes[axis], middle = body.position + body.axes * (0.5f * glm::vec3(last.x, 0.0f, last.y));
        least = std::min(least, width + row_from(middle + 0.5f * width * way, way) + row_from(middle - 0.5f * width * way, -way));
    }
    return least;
}

// [m] From a place on, how far the tiles near it go on without a gap.
float Solids::row_from(glm::vec3 place, glm::vec3 way) const {
    const float touch = k_apart_at_most * box_.cell_size, far = k_farthest_row * box_.coarsest();
    const auto depth = [&](float distance) { // below 0: outside
        const glm::vec3 at = place + distance * way;
        float deepest = -1.0f;
        for (const NearTile& near : near_) {
            const auto beyond = [&](int axis) { return at[axis] < near.low[axis] - touch || at[axis] > near.high[axis] + touch; };
            if (beyond(0) || beyond(2))
                continue;
            const glm::vec3 own = glm::transpose(near.body->axes) * (at - near.position);
            const auto& ground = std::get<Ground>(near.body->shape);
            if (detail::holds(ground, {own.x, own.z}, -touch))
                deepest = std::max(deepest, detail::whole_of(ground).before_end({own.x, own.z}) + touch);
        }
        return deepest;
    };
    float inside = 0.0f, next = 2.0f * touch;
    for (float deep = depth(next); deep >= 0.0f; deep = depth(next)) {
        inside = next;
        next += std::max(deep, k_row_step * box_.cell_size);
        if (next >= far)
            return far;
    }
    for (int halving = 0; halving < 12; ++halving)
        (depth(0.5f * (inside + next)) >= 0.0f ? inside : next) = 0.5f * (inside + next);
    return inside;
}

// The surface that the image of an upright ground is drawn from: of a tile with those beside it and their images.
void Solids::collect_ground(std::size_t number, const View& view) {
    if (const std::pair wanted{number, view.base}; ground_of_ != wanted)
        ground_of_ = wanted;
    else
        return;
    ground_.begin(box_.cell_size, View::k_far * box_.coarsest());
    if (!TiledGround::is_upright_ground(view.body))
        return;
    if (!TiledGround::is_tile(view.body)) {
        if (std::get<Ground>(view.body.shape).beyond == Beyond::edge)
            ground_.add(view.body, glm::vec3(0.0f), true);
        ground_.end();
        return;
    }
    const glm::ivec3 images(box_.boundaries.periodic(0), 0, box_.boundaries.periodic(2));
    const detail::Extent own = detail::extent_of(view.body);
    for (const Tile& tile : tiles_)
        for (int z = -2 * images.z; z <= 2 * images.z; ++z)
            for (int x = -2 * images.x; x <= 2 * images.x; ++x) {
                const PlacedObstacle& other = bodies_[tile.body];
                const glm::vec3 between = view.from_middle_of(View(other, glm::ivec3(x, 0, z) * box_.cells, box_));
                if (are_within(beside_margin(), own, tile.extent, -between))
                    ground_.add(other, between, tile.body == number && between == glm::vec3(0.0f), tile.kind);
            }
    ground_.end();
}

} // namespace windrow
