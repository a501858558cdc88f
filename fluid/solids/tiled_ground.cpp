#include "fluid/solids/tiled_ground.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <tuple>

namespace windrow {

void TiledGround::begin(float cell, float far) {
    tiles_.clear();
    parts_.clear();
    holes_.clear();
    ends_.clear();
    cell_ = cell;
    far_ = far;
    slack_ = k_slack * cell;
}

void TiledGround::add(const PlacedObstacle& body, glm::vec3 between, std::uint32_t kind) {
    const Ground& ground = std::get<Ground>(body.shape);
    const detail::Extent extent = detail::extent_of(body);
    tiles_.push_back({.body = &body,
                      .ground = &ground,
                      .to_own = glm::transpose(body.axes),
                      .between = between,
                      .whole = detail::whole_of(ground),
                      .parts = {},
                      .holes = {},
                      .low = glm::vec2(extent.low.x - between.x, extent.low.z - between.z),
                      .high = glm::vec2(extent.high.x - between.x, extent.high.z - between.z),
                      .top = extent.high.y - between.y,
                      .kind = kind});
}

// By what tiles are and then by where, so that it is the same wherever the box is.
void TiledGround::end() {
    std::sort(tiles_.begin(), tiles_.end(), [this](const Tile& a, const Tile& b) {
        if (a.kind != b.kind)
            return a.kind < b.kind;
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(a.between[axis] - b.between[axis]) > slack_)
                return a.between[axis] > b.between[axis];
        return a.body->slot < b.body->slot;
    });
    for (Tile& tile : tiles_)
        for (const bool hole : {false, true})
            for (const HeightMap::Part& part : hole ? tile.ground->heights->holes() : tile.ground->heights->parts())
                (hole ? holes_ : parts_).push_back(detail::part_of(*tile.ground, part));
    std::span<const detail::GroundPart> parts = parts_, holes = holes_;
    for (Tile& tile : tiles_) {
        tile.parts = parts.first(tile.ground->heights->parts().size());
        tile.holes = holes.first(tile.ground->heights->holes().size());
        parts = parts.subspan(tile.parts.size());
        holes = holes.subspan(tile.holes.size());
    }
    tiles_at_.fill(tiles_.size(), slack_, [this](std::size_t n) {
        return PlaneBuckets::Rectangle{tiles_[n].low, tiles_[n].high};
    });
    find_ends();
    ends_at_.fill(ends_.size(), slack_, [this](std::size_t n) {
        const End& end = ends_[n];
        return PlaneBuckets::Rectangle{glm::min(end.from, end.to), glm::max(end.from, end.to)};
    });
}

template <class Visit>
void TiledGround::each_near(glm::vec2 place, float distance, const Visit& visit) const {
    tiles_at_.each_in({place - distance, place + distance},
                      [&](std::uint32_t n) { return !tiles_[n].is_near(place, distance) || visit(tiles_[n]); });
}

// Tiles that stand upon each other have the same sides.
void TiledGround::find_repeated() {
    const auto is_ordered = [this](std::uint32_t a, std::uint32_t b) {
        const auto key = [](const Tile& tile) {
            return std::tuple(tile.between.x, tile.between.z, tile.whole.first.x, tile.whole.first.y, tile.whole.last.x,
                              tile.whole.last.y, tile.to_own[0].x, tile.to_own[2].x, tile.holes.empty() ? 0u : 1u + tile.kind);
        };
        return key(tiles_[a]) < key(tiles_[b]);
    };
    order_.resize(tiles_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), is_ordered);
    for (std::size_t n = 0; n < order_.size(); ++n)
        tiles_[order_[n]].repeats = n > 0 && !is_ordered(order_[n - 1], order_[n]);
}

// The sides of all tiles and holes, less what other tiles go on over.
void TiledGround::find_ends() {
    ends_.clear();
    find_repeated();
    for (const Tile& tile : tiles_) {
        const auto add_sides = [&](const detail::GroundPart& part, float outwards) {
            for (int axis = 0; axis < 2; ++axis)
                for (const bool high : {false, true}) {
                    glm::vec2 from = part.first, to = part.last, out(0.0f);
                    from[axis] = to[axis] = high ? part.last[axis] : part.first[axis];
                    out[axis] = high ? outwards : -outwards;
                    add_ends(tile, from, to, out);
                }
        };
        if (tile.goes_on() || tile.repeats)
            continue;
        add_sides(tile.whole, 1.0f);
        for (const detail::GroundPart& hole : tile.holes)
            add_sides(hole, -1.0f);
    }
}

// The parts of a line that ground is under, in order; the whole once parts that were found cover it.
void TiledGround::cover(glm::vec2 begin, glm::vec2 end) {
    covered_.clear();
    glm::vec2 open(0.0f, 1.0f); // what no part covers is within
    each_near(0.5f * (begin + end), 0.5f * glm::distance(begin, end) + slack_, [&](const Tile& tile) {
        if (tile.repeats)
            return true;
        const glm::vec3 one = tile.own_place(begin), two = tile.own_place(end);
        for (const detail::GroundPart& part : tile.parts) {
            const detail::GroundPart wider{part.first - slack_, part.last + slack_};
            const glm::vec2 over = detail::part_within(wider, {one.x, one.z}, {two.x, two.z});
            if (!(over.x <= over.y))
                continue;
            covered_.push_back(over);
            if (over.x <= open.x)
                open.x = std::max(open.x, over.y);
            if (over.y >= open.y)
                open.y = std::min(open.y, over.x);
        }
        return open.x < open.y;
    });
    if (open.x >= open.y)
        covered_.assign(1, {0.0f, 1.0f});
    std::sort(covered_.begin(), covered_.end(), [](glm::vec2 a, glm::vec2 b) { return a.x < b.x; });
}

void TiledGround::add_ends(const Tile& tile, glm::vec2 from, glm::vec2 to, glm::vec2 outwards) {
    const glm::vec2 beyond = 2.0f * slack_ * outwards, begin = tile.world_place(from + beyond),
                    end = tile.world_place(to + beyond);
    cover(begin, end);
    covered_.emplace_back(1.0f, 1.0f);
    float done = 0.0f;
    for (const glm::vec2& over : covered_) {
        if ((over.x - done) * glm::distance(begin, end) > slack_)
            ends_.push_back({tile.world_place(glm::mix(from, to, done)), tile.world_place(glm::mix(from, to, over.x))});
        done = std::max(done, over.y);
    }
}

float TiledGround::Tile::outside(glm::vec2 place) const {
    const glm::vec3 own = own_place(place);
    float nearest = std::numeric_limits<float>::max();
    for (const detail::GroundPart& part : parts)
        nearest = std::min(nearest, part.outside({own.x, own.z}));
    return nearest;
}

TiledGround::Level TiledGround::at(glm::vec2 from_drawn) const {
    const glm::vec2 place = here(from_drawn);
    Level found;
    for (const float slack : {0.0f, slack_}) {
        for (const std::uint32_t n : tiles_at_.at(place)) {
            const Tile& tile = tiles_[n];
            if (!tile.is_near(place, slack_) || tile.outside(place) > slack)
                continue;
            const Level level{.height = detail::height_at(*tile.ground, tile.own_place(place)),
                              .between = tile.between.y + from_.y,
                              .ground = true};
            if (!found.ground || level.level() > found.level())
                found = level;
        }
        if (found.ground)
            break;
    }
    if (found.ground)
        found.end = to_end(place);
    return found;
}

float TiledGround::to_end(glm::vec2 place) const {
    float nearest = far_;
    if (!tiles_.empty() && tiles_.front().goes_on()) { // alone: it ends at its holes
        const glm::vec3 own = tiles_.front().own_place(place);
        for (const detail::GroundPart& hole : tiles_.front().holes)
            nearest = std::min(nearest, hole.outside({own.x, own.z}));
    }
    each_ring(ends_.size(), nearest, [&](float reach) {
        ends_at_.each_in({place - reach, place + reach}, [&](std::uint32_t n) {
            const End& end = ends_[n];
            const glm::vec2 along = end.to - end.from;
            const float part = glm::clamp(glm::dot(place - end.from, along) / glm::dot(along, along), 0.0f, 1.0f);
            nearest = std::min(nearest, glm::distance(place, end.from + part * along));
            return true;
        });
    });
    return nearest;
}

// look(reach) for distances up to `far` until what is nearest of `count` things is within: among many it is mostly near.
template <class Look>
void TiledGround::each_ring(std::size_t count, const float& nearest, const Look& look) const {
    constexpr std::size_t k_few = 32;
    float reach = count > k_few ? 0.125f * far_ : far_;
    look(reach);
    while (reach < far_ && nearest > reach) {
        reach = std::min(2.0f * reach, far_);
        look(reach);
    }
}

// [m] Of a place that is outside of all; at most `far`.
float TiledGround::beside(glm::vec3 place) const {
    const glm::vec2 level(place.x, place.z);
    float nearest = far_;
    const auto beyond = [level](const Tile& tile) {
        const glm::vec2 gap = glm::max(glm::max(tile.low - level, level - tile.high), 0.0f);
        return std::max(gap.x, gap.y);
    };
    const auto look_at = [&](const Tile& tile) {
        if (std::max(place.y - tile.top, beyond(tile)) >= nearest)
            return;
        const float way = tile.outside(level);
        const auto at_height = [&](float over) { return over > 0.0f ? glm::length(glm::vec2(way, over)) : way; };
        if (at_height(place.y - tile.top) >= nearest)
            return;
        const float height = detail::height_at(*tile.ground, tile.own_place(level));
        nearest = std::min(nearest, at_height(place.y + tile.between.y - height));
    };
    each_ring(tiles_.size(), nearest, [&](float reach) {
        const Tile* first = nullptr; // after the one that is nearest to it, most others need no look
        each_near(level, reach, [&](const Tile& tile) {
            if (first == nullptr || beyond(tile) < beyond(*first))
                first = &tile;
            return true;
        });
        if (first != nullptr)
            look_at(*first);
        each_near(level, reach, [&](const Tile& tile) {
            look_at(tile);
            return true;
        });
    });
    return nearest;
}

float TiledGround::away(const Level& level, glm::vec3 place) const {
    if (!level.ground)
        return beside(place + from_);
    return level.end < far_ ? std::max(level.rise(place.y), -level.end) : level.rise(place.y);
}

glm::vec3 TiledGround::normal(glm::vec3 place, float step) const {
    glm::vec3 rise;
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 by(0.0f);
        by[axis] = step;
        rise[axis] = away(place + by) - away(place - by);
    }
    const float length = glm::length(rise);
    return length > 0.0f ? rise / length : glm::vec3(0.0f);
}

float TiledGround::crest(glm::vec2 from_drawn, glm::vec2 to_drawn) const {
    const glm::vec2 from = here(from_drawn), to = here(to_drawn), middle = 0.5f * (from + to);
    const float half = 0.5f * glm::distance(from, to);
    float highest = -std::numeric_limits<float>::infinity();
    each_near(middle, half, [&](const Tile& tile) {
        glm::vec3 begin = tile.own_place(from), end = tile.own_place(to);
        begin.y = end.y = 0.0f;
        for (const detail::GroundPart& part : tile.parts)
            highest = std::max(highest, -detail::least_rise(*tile.ground, part, begin, end) - (tile.between.y + from_.y));
        return true;
    });
    return highest;
}

TiledGround::Owner TiledGround::owner(glm::vec2 from_drawn) const {
    const glm::vec2 centre = here(from_drawn);
    for (const float reach : {slack_, k_into_column * cell_}) {
        const Tile* first = nullptr;
        each_near(centre, reach, [&](const Tile& tile) {
            if ((first == nullptr || &tile < first) && tile.outside(centre) <= reach)
                first = &tile;
            return true;
        });
        if (first != nullptr) // another image of a body is not it
            return first->body == drawn_ && glm::length(first->between + from_) <= cell_ ? Owner::drawn : Owner::other;
    }
    return Owner::none;
}

} // namespace windrow
