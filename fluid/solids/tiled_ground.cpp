#include "fluid/solids/tiled_ground.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace windrow {
namespace {

constexpr float k_slack = 1e-3f;       // of a cell: places of bodies are rounded to a fourth of it
constexpr float k_into_column = 0.75f; // [cells] from a column's centre to its corners, and some
constexpr std::size_t k_few = 8;       // tiles: all of them are looked at
constexpr int k_most_buckets = 64;     // along an axis

} // namespace

void TiledGround::begin(float cell, float far) {
    tiles_.clear();
    parts_.clear();
    holes_.clear();
    ends_.clear();
    cell_ = cell;
    far_ = far;
    slack_ = k_slack * cell;
}

void TiledGround::add(const PlacedObstacle& body, glm::vec3 between, bool drawn, std::uint32_t kind) {
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
                      .drawn = drawn,
                      .kind = kind,
                      .first_bucket = glm::ivec2(0)});
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
    sort_into_buckets();
    find_ends();
}

// Squares as large as the mean tile, so that each stands in few.
void TiledGround::sort_into_buckets() {
    buckets_ = glm::ivec2(1);
    buckets_a_metre_ = glm::vec2(0.0f);
    glm::vec2 low(std::numeric_limits<float>::max()), high(-low);
    glm::vec2 sum(0.0f);
    for (const Tile& tile : tiles_) {
        low = glm::min(low, tile.low);
        high = glm::max(high, tile.high);
        sum += tile.high - tile.low;
    }
    const glm::vec2 size = high - low;
    if (tiles_.size() > k_few && std::isfinite(size.x) && std::isfinite(size.y)) {
        const glm::vec2 tiles = size * static_cast<float>(tiles_.size()) / glm::max(sum, slack_);
        buckets_ = glm::ivec2(glm::clamp(tiles, 1.0f, static_cast<float>(k_most_buckets)));
        buckets_a_metre_ = glm::vec2(buckets_) / glm::max(size, slack_);
    }
    first_bucket_ = low;

    const auto each_square = [&](const auto& visit) {
        for (std::size_t n = 0; n < tiles_.size(); ++n) {
            tiles_[n].first_bucket = bucket_of(tiles_[n].low - slack_);
            const glm::ivec2 from = tiles_[n].first_bucket, to = bucket_of(tiles_[n].high + slack_);
            for (int y = from.y; y <= to.y; ++y)
                for (int x = from.x; x <= to.x; ++x)
                    visit(static_cast<std::size_t>(y * buckets_.x + x), static_cast<std::uint32_t>(n));
        }
    };
    bucket_ends_.assign(static_cast<std::size_t>(buckets_.x * buckets_.y) + 1, 0);
    each_square([&](std::size_t square, std::uint32_t) { ++bucket_ends_[square + 1]; });
    std::partial_sum(bucket_ends_.begin(), bucket_ends_.end(), bucket_ends_.begin());
    in_buckets_.resize(bucket_ends_.back());
    std::vector<std::uint32_t>& next = bucket_ends_; // each moves from a square's begin to its end
    each_square([&](std::size_t square, std::uint32_t tile) { in_buckets_[next[square]++] = tile; });
}

glm::ivec2 TiledGround::bucket_of(glm::vec2 place) const {
    const glm::vec2 square = (place - first_bucket_) * buckets_a_metre_;
    return glm::ivec2(glm::clamp(square, glm::vec2(0.0f), glm::vec2(buckets_ - 1)));
}

// bucket_ends_[n] is the end of square n since it was filled.
std::span<const std::uint32_t> TiledGround::bucket(glm::ivec2 at) const {
    if (tiles_.empty())
        return {};
    const auto square = static_cast<std::size_t>(at.y * buckets_.x + at.x);
    const std::uint32_t first = square > 0 ? bucket_ends_[square - 1] : 0;
    return std::span(in_buckets_).subspan(first, bucket_ends_[square] - first);
}

template <class Visit>
void TiledGround::each_near(glm::vec2 place, float distance, const Visit& visit) const {
    const glm::ivec2 from = bucket_of(place - distance), to = bucket_of(place + distance);
    for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x)
            for (const std::uint32_t n : bucket({x, y})) {
                const Tile& tile = tiles_[n];
                if (glm::max(tile.first_bucket, from) == glm::ivec2(x, y) && tile.is_near(place, distance))
                    visit(tile);
            }
}

// The sides of all tiles and holes, less what other tiles go on over.
void TiledGround::find_ends() {
    ends_.clear();
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
        if (tile.goes_on())
            continue;
        add_sides(tile.whole, 1.0f);
        for (const detail::GroundPart& hole : tile.holes)
            add_sides(hole, -1.0f);
    }
}

// The parts of a line that ground is under, in order.
void TiledGround::cover(glm::vec2 begin, glm::vec2 end) {
    covered_.clear();
    each_near(0.5f * (begin + end), 0.5f * glm::distance(begin, end) + slack_, [&](const Tile& tile) {
        const glm::vec3 one = tile.own_place(begin), two = tile.own_place(end);
        for (const detail::GroundPart& part : tile.parts) {
            const detail::GroundPart wider{part.first - slack_, part.last + slack_};
            if (const glm::vec2 over = detail::part_within(wider, {one.x, one.z}, {two.x, two.z}); over.x <= over.y)
                covered_.push_back(over);
        }
    });
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

TiledGround::Level TiledGround::at(glm::vec2 place) const {
    Level found;
    for (const float slack : {0.0f, slack_}) {
        for (const std::uint32_t n : bucket(bucket_of(place))) {
            const Tile& tile = tiles_[n];
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

float TiledGround::to_end(glm::vec2 place) const {
    float nearest = far_;
    if (!tiles_.empty() && tiles_.front().goes_on()) { // alone: it ends at its holes
        const glm::vec3 own = tiles_.front().own_place(place);
        for (const detail::GroundPart& hole : tiles_.front().holes)
            nearest = std::min(nearest, hole.outside({own.x, own.z}));
    }
    for (const End& end : ends_) {
        const glm::vec2 along = end.to - end.from;
        const float part = glm::clamp(glm::dot(place - end.from, along) / glm::dot(along, along), 0.0f, 1.0f);
        nearest = std::min(nearest, glm::distance(place, end.from + part * along));
    }
    return nearest;
}

// [m] Of a place that is outside of all; at most `far`.
float TiledGround::beside(glm::vec3 place) const {
    const glm::vec2 level(place.x, place.z);
    float nearest = far_;
    each_near(level, far_, [&](const Tile& tile) {
        const float way = tile.outside(level);
        const auto at_height = [&](float over) { return over > 0.0f ? glm::length(glm::vec2(way, over)) : way; };
        if (at_height(place.y - tile.top) >= nearest)
            return;
        const float height = detail::height_at(*tile.ground, tile.own_place(level));
        nearest = std::min(nearest, at_height(place.y + tile.between.y - height));
    });
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
    each_near(middle, half, [&](const Tile& tile) {
        glm::vec3 begin = tile.own_place(from), end = tile.own_place(to);
        begin.y = end.y = 0.0f;
        for (const detail::GroundPart& part : tile.parts)
            highest = std::max(highest, -detail::least_rise(*tile.ground, part, begin, end) - tile.between.y);
    });
    return highest;
}

TiledGround::Owner TiledGround::owner(glm::vec2 centre) const {
    for (const float reach : {slack_, k_into_column * cell_}) {
        const Tile* first = nullptr;
        each_near(centre, reach, [&](const Tile& tile) {
            if ((first == nullptr || &tile < first) && tile.outside(centre) <= reach)
                first = &tile;
        });
        if (first != nullptr)
            return first->drawn ? Owner::drawn : Owner::other;
    }
    return Owner::none;
}

} // namespace windrow
