#include "fluid/solids/tiled_ground.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace windrow {
namespace {

constexpr float k_slack = 1e-3f;       // of a cell: places of bodies are rounded to a fourth of it
constexpr float k_into_column = 0.75f; // [cells] from a column's centre to its corners, and some

} // namespace

void TiledGround::begin(float cell, float far) {
    tiles_.clear();
    parts_.clear();
    holes_.clear();
    free_corners_.clear();
    cell_ = cell;
    far_ = far;
    slack_ = k_slack * cell;
}

void TiledGround::add(const PlacedObstacle& body, glm::vec3 between, bool drawn) {
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
                      .drawn = drawn});
}

// By what tiles are and then by where, so that it is the same wherever the box is.
void TiledGround::end() {
    std::sort(tiles_.begin(), tiles_.end(), [this](const Tile& a, const Tile& b) {
        PlacedObstacle one = *a.body, other = *b.body;
        one.position = other.position = glm::vec3(0.0f);
        if (const bool first = detail::precedes(one, other); first || detail::precedes(other, one))
            return first;
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
    find_free_corners();
}

// Corners of tiles that the ground does not go on around.
void TiledGround::find_free_corners() {
    free_corners_.clear();
    for (const Tile& tile : tiles_)
        for (int n = 0; n < 4 && std::isfinite(tile.whole.last.x); ++n) {
            const glm::vec2 corner(tile.whole.last.x * static_cast<float>(n & 1), tile.whole.last.y * static_cast<float>(n >> 1));
            bool free = false;
            for (int m = 0; m < 4 && !free; ++m)
                free = !holds(tile.world_place(corner + 2.0f * slack_ * glm::vec2(2 * (m & 1) - 1, 2 * (m >> 1) - 1)));
            if (free)
                free_corners_.push_back(tile.world_place(corner));
        }
}

float TiledGround::Tile::outside(glm::vec2 place) const {
    const glm::vec3 own = own_place(place);
    float nearest = std::numeric_limits<float>::max();
    for (const detail::GroundPart& part : parts)
        nearest = std::min(nearest, part.outside({own.x, own.z}));
    return nearest;
}

bool TiledGround::holds(glm::vec2 place) const {
    return std::any_of(tiles_.begin(), tiles_.end(),
                       [&](const Tile& tile) { return tile.is_near(place, slack_) && tile.outside(place) <= slack_; });
}

TiledGround::Level TiledGround::at(glm::vec2 place) const {
    Level found;
    for (const float slack : {0.0f, slack_}) {
        for (const Tile& tile : tiles_) {
            if (!tile.is_near(place, slack_) || tile.outside(place) > slack)
                continue;
            const Level here{
                .height = detail::height_at(*tile.ground, tile.own_place(place)), .between = tile.between.y, .ground = true};
            if (!found.ground || here.level() > found.level())
                found = here;
        }
        if (found.ground)
            break;
    }
    if (found.ground)
        found.end = to_end(place);
    return found;
}

// The nearest place without ground is across a side of a tile or of a hole, or at a tile's corner.
float TiledGround::to_end(glm::vec2 place) const {
    float nearest = far_;
    for (const Tile& tile : tiles_) {
        if (!tile.is_near(place, far_))
            continue;
        const glm::vec3 own = tile.own_place(place);
        const glm::vec2 at(own.x, own.z);
        const float before = tile.whole.before_end(at);
        bool far = before >= far_;
        for (const detail::GroundPart& hole : tile.holes)
            if (const float way = hole.outside(at); way < far_) {
                far = false;
                const glm::vec2 foot = glm::clamp(at, hole.first + 2.0f * slack_, hole.last - 2.0f * slack_);
                if (way < nearest && !holds(tile.world_place(foot)))
                    nearest = way;
            }
        if (far)
            return far_;
        for (int axis = 0; axis < 2 && before >= -slack_; ++axis)
            for (const float side : {tile.whole.first[axis], tile.whole.last[axis]}) {
                glm::vec2 foot = at;
                foot[axis] = side > tile.whole.first[axis] ? side + 2.0f * slack_ : side - 2.0f * slack_;
                if (const float way = std::abs(side - at[axis]); way < nearest && !holds(tile.world_place(foot)))
                    nearest = way;
            }
    }
    for (const glm::vec2& corner : free_corners_)
        nearest = std::min(nearest, glm::distance(place, corner));
    return nearest;
}

// [m] Of a place that is outside of all.
float TiledGround::beside(glm::vec3 place) const {
    const glm::vec2 level(place.x, place.z);
    float nearest = std::numeric_limits<float>::max();
    for (const Tile& tile : tiles_) {
        if (!tile.is_near(level, nearest))
            continue;
        const float way = tile.outside(level);
        if (way >= nearest)
            continue;
        const float height = place.y + tile.between.y - detail::height_at(*tile.ground, tile.own_place(level));
        nearest = std::min(nearest, height > 0.0f ? glm::length(glm::vec2(way, height)) : way);
    }
    return nearest;
}

float TiledGround::away(const Level& level, glm::vec3 place) const {
    if (!level.ground)
        return beside(place);
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

float TiledGround::crest(glm::vec2 from, glm::vec2 to) const {
    const glm::vec2 middle = 0.5f * (from + to);
    const float half = 0.5f * glm::distance(from, to);
    float highest = -std::numeric_limits<float>::infinity();
    for (const Tile& tile : tiles_) {
        if (!tile.is_near(middle, half))
            continue;
        glm::vec3 begin = tile.own_place(from), end = tile.own_place(to);
        begin.y = end.y = 0.0f;
        for (const detail::GroundPart& part : tile.parts)
            highest = std::max(highest, -detail::least_rise(*tile.ground, part, begin, end) - tile.between.y);
    }
    return highest;
}

TiledGround::Owner TiledGround::owner(glm::vec2 centre) const {
    for (const float reach : {slack_, k_into_column * cell_})
        for (const Tile& tile : tiles_)
            if (tile.is_near(centre, reach) && tile.outside(centre) <= reach)
                return tile.drawn ? Owner::drawn : Owner::other;
    return Owner::none;
}

} // namespace windrow
