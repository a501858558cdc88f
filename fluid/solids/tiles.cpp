// Tiles of ground among the bodies of a box: which of them draw, the surface that one is drawn from, how thick that is.
#include "fluid/solids/body_view.h"
#include "fluid/solids/solids.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <utility>

namespace windrow {
namespace {

constexpr float k_apart_at_most = 1e-3f; // [cells] between bodies that touch
constexpr float k_row_step = 0.25f;      // [cells] a gap that is thinner may be missed
constexpr std::size_t k_few = 8;         // tiles: each is drawn from the surface that it makes with the others
constexpr std::size_t k_crowd = 48;      // tiles narrower than a cell beside one: all are drawn from one surface

// Whether a tile and another one, that stands `from` [m] it, are within so many metres.
bool are_within(float margin, const detail::Extent& tile, const detail::Extent& other, glm::vec3 from) {
    const glm::vec3 gap = glm::max(from + other.low - tile.high, tile.low - from - other.high);
    return gap.x <= margin && gap.z <= margin;
}

} // namespace

// The tiles among the bodies, with a number for each kind of them.
void Solids::find_tiles() {
    ground_of_.first = other_of_.first = k_no_ground;
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

// Where the tiles and their images are, for what looks at those about a place. Without a periodic end none has images.
void Solids::find_tile_places() {
    const glm::ivec3 images(box_.boundaries.periodic(0), 0, box_.boundaries.periodic(2));
    tile_places_.clear();
    for (const GroundTile& tile : tiles_)
        for (int z = -images.z; z <= images.z; ++z)
            for (int x = -images.x; x <= images.x; ++x) {
                const glm::vec3 place = bodies_[tile.body].position + glm::vec3(x, 0, z) * box_.size();
                tile_places_.push_back(
                    {&bodies_[tile.body], {x, 0, z}, place, place + tile.extent.low, place + tile.extent.high});
            }
    tiles_at_.fill(tile_places_.size(), k_apart_at_most * box_.cell_size, [this](std::size_t n) {
        const GroundTilePlace& at = tile_places_[n];
        return PlaneBuckets::Rectangle{{at.low.x, at.low.z}, {at.high.x, at.high.z}};
    });
}

// The tiles that came or went since the last placement; `drawings_before_` has what no body took.
void Solids::find_changed_tiles() {
    changed_tiles_.clear();
    for (const Drawing& before : drawings_before_)
        if (!std::isnan(before.body.position.x) && TiledGround::is_tile(before.body))
            changed_tiles_.push_back(before.body);
    for (const GroundTile& tile : tiles_)
        if (kept_[tile.body] == 0 || drawings_[tile.body].body.surface != bodies_[tile.body].surface)
            changed_tiles_.push_back(bodies_[tile.body]);
}

// Whether a tile came or went within so many metres of another.
bool Solids::changed_near(const PlacedObstacle& tile, const PlacedObstacle& changed, float margin) const {
    const glm::ivec3 images(box_.boundaries.periodic(0), 0, box_.boundaries.periodic(2));
    const detail::Extent own = detail::extent_of(tile), other = detail::extent_of(changed);
    for (int z = -images.z; z <= images.z; ++z)
        for (int x = -images.x; x <= images.x; ++x)
            if (are_within(margin, own, other, changed.position - tile.position + glm::vec3(x, 0, z) * box_.size()))
                return true;
    return false;
}

bool Solids::any_changed_near(std::size_t number, float margin) const {
    return std::any_of(changed_tiles_.begin(), changed_tiles_.end(),
                       [&](const PlacedObstacle& changed) { return changed_near(bodies_[number], changed, margin); });
}

// Whether one tile comes before another where both could own a column, whatever rounding does (TiledGround::end).
bool Solids::surely_precedes(const GroundTilePlace& one, const GroundTilePlace& other) const {
    const float slack = TiledGround::k_slack * box_.cell_size;
    const std::uint32_t kinds[] = {kind_of(one), kind_of(other)};
    if (kinds[0] != kinds[1])
        return kinds[0] < kinds[1];
    for (int axis = 0; axis < 3; ++axis) {
        const float apart = other.position[axis] - one.position[axis];
        if (std::abs(apart) > 2.0f * slack)
            return apart > 0.0f;
        if (std::abs(apart) > 0.5f * slack)
            return false;
    }
    return one.body->slot < other.body->slot;
}

std::uint32_t Solids::kind_of(const GroundTilePlace& tile) const {
    return tiles_[tile_of_[static_cast<std::size_t>(tile.body - bodies_.data())]].kind;
}

// Which tiles draw. Each column of cells is drawn by its owner, the first tile that holds its centre or reaches into it; the cells near
// the surface in a column that none reaches, by the highest. Tiles far smaller than a cell mostly own none, nor do those that are under
// others: they are left out. One that might own a column by rounding draws.
void Solids::find_drawers(bool as_before) {
    draws_.assign(tiles_.size(), 1);
    if (as_before) {
        for (std::size_t n = 0; n < tiles_.size(); ++n)
            draws_[n] = drawings_[tiles_[n].body].draws;
        return;
    }
    crowded_ = false;
    if (tiles_.size() <= k_few)
        return;
    draws_.assign(tiles_.size(), 0);
    const auto is_narrow = [this](const GroundTile& tile) {
        const glm::vec3 size = tile.extent.high - tile.extent.low;
        return std::min(size.x, size.z) < box_.cell_size;
    };
    const float slack = TiledGround::k_slack * box_.cell_size, into = TiledGround::k_into_column * box_.cell_size;
    const glm::ivec3 beyond = k_beyond * needed_beyond();
    const Reach all{-beyond, box_.cells + beyond};
    owned_.assign(static_cast<std::size_t>(all.high.x - all.low.x) * static_cast<std::size_t>(all.high.z - all.low.z), {});
    // visit(column, [m] its centre outside of the tile)
    const auto each_column = [&](const GroundTilePlace& tile, const auto& visit) {
        PlacedObstacle image = *tile.body;
        image.position = tile.position;
        const View view(*tile.body, tile.image * box_.cells, box_);
        const Reach reach = reach_of(image, beyond);
        const auto& ground = std::get<Ground>(tile.body->shape);
        for (int k = reach.low.z; k < reach.high.z; ++k)
            for (int i = reach.low.x; i < reach.high.x; ++i) {
                const glm::vec3 own = view.own_place(glm::vec3(i, 0, k) + 0.5f);
                float outside = std::numeric_limits<float>::max();
                for (const HeightMap::Part& part : ground.heights->parts())
                    outside = std::min(outside, detail::part_of(ground, part).outside({own.x, own.z}));
                visit(owned_[all.column({i, 0, k})], outside);
            }
    };
    const auto first = [&](std::uint32_t& owner, std::uint32_t n) {
        if (owner == k_none || surely_precedes(tile_places_[n], tile_places_[owner]))
            owner = n;
    };
    for (std::uint32_t n = 0; n < tile_places_.size(); ++n)
        each_column(tile_places_[n], [&](ColumnTiles& column, float outside) {
            if (outside <= 0.5f * slack)
                first(column.holder, n);
            if (outside <= into - slack)
                first(column.beside, n);
            if (column.highest == k_none || tile_places_[n].high.y > tile_places_[column.highest].high.y)
                column.highest = n;
        });
    for (std::uint32_t n = 0; n < tile_places_.size(); ++n)
        each_column(tile_places_[n], [&](const ColumnTiles& column, float outside) {
            const auto may_be = [&](std::uint32_t owner) {
                return owner == k_none || !surely_precedes(tile_places_[owner], tile_places_[n]);
            };
            const bool held = column.holder != k_none;
            if ((outside <= 2.0f * slack && may_be(column.holder)) ||
                (!held && outside <= into + slack && may_be(column.beside)) ||
                (!held && column.beside == k_none && column.highest == n))
                draws_[tile_of_[static_cast<std::size_t>(tile_places_[n].body - bodies_.data())]] = 1;
        });
    std::size_t narrow = 0;
    for (const GroundTile& tile : tiles_)
        narrow += is_narrow(tile) ? 1 : 0;
    for (std::size_t n = 0; n < tiles_.size() && narrow > k_crowd && !crowded_; ++n)
        if (draws_[n] != 0)
            crowded_ = std::count_if(tiles_.begin(), tiles_.end(), [&](const GroundTile& other) {
                           return is_narrow(other) && are_within(beside_margin(), tiles_[n].extent, other.extent,
                                                                 bodies_[other.body].position - bodies_[tiles_[n].body].position);
                       }) > static_cast<std::ptrdiff_t>(k_crowd);
}

// A tile that draws nothing has no thickness of its own, and none of the columns that a box which moves may ask for.
void Solids::leave_out(std::size_t number) {
    Drawing& drawing = drawings_[number];
    drawing.body = bodies_[number];
    drawing.part = wholes_.part(number);
    drawing.draws = false;
    drawing.thickness = k_unknown;
    drawing.low = drawing.high = glm::ivec3(std::numeric_limits<int>::max() / 2);
    drawing.faces.clear();
    drawing.inside.clear();
    drawing.sides.clear();
    drawing.near.clear();
    drawing.beside.clear();
    thickness_of_[number] = k_farthest_row * box_.coarsest();
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

    const glm::vec2 last = detail::whole_of(std::get<Ground>(body.shape)).last;
    float least = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; axis += 2) {
        const float width = axis == 0 ? last.x : last.y;
        const glm::vec3 way = body.axes[axis], middle = body.position + body.axes * (0.5f * glm::vec3(last.x, 0.0f, last.y));
        least = std::min(least, width + row_from(middle + 0.5f * width * way, way) + row_from(middle - 0.5f * width * way, -way));
    }
    return least;
}

// [m] From a place on, how far the tiles go on without a gap.
float Solids::row_from(glm::vec3 place, glm::vec3 way) const {
    const float touch = k_apart_at_most * box_.cell_size, far = k_farthest_row * box_.coarsest();
    const auto depth = [&](float distance) { // below 0: outside
        const glm::vec3 at = place + distance * way;
        float deepest = -1.0f;
        for (const std::uint32_t n : tiles_at_.at({at.x, at.z})) {
            const GroundTilePlace& near = tile_places_[n];
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

// The surface that the image of an upright ground is drawn from: of a tile with those beside it and their images; in a crowd that of all
// tiles.
void Solids::collect_ground(std::size_t number, const View& view) {
    const bool tile = TiledGround::is_tile(view.body), of_all = tile && crowded_;
    static const PlacedObstacle corner{}; // of the box
    const View from_corner(corner, glm::ivec3(0), box_);
    const std::pair wanted = of_all ? std::pair{k_all_tiles, glm::vec3(0.0f)} : std::pair{number, view.base};
    if (ground_of_ != wanted && (other_of_ == wanted || ground_of_.first == k_all_tiles)) {
        std::swap(ground_, other_ground_);
        std::swap(ground_of_, other_of_);
    }
    if (of_all)
        ground_.draw(bodies_[number], view.from_middle_of(from_corner));
    if (std::exchange(ground_of_, wanted) == wanted)
        return;
    ground_.begin(box_.cell_size, View::k_far * box_.coarsest());
    if (!TiledGround::is_upright_ground(view.body))
        return;
    if (!tile) {
        ground_.draw(view.body);
        if (std::get<Ground>(view.body.shape).beyond == Beyond::edge)
            ground_.add(view.body, glm::vec3(0.0f));
        ground_.end();
        return;
    }
    const glm::ivec3 images(box_.boundaries.periodic(0), 0, box_.boundaries.periodic(2));
    const detail::Extent own = of_all ? detail::Extent{glm::vec3(0.0f), box_.size()} : detail::extent_of(view.body);
    const float margin = beside_margin() + (of_all ? k_beyond * box_.cell_size : 0.0f);
    const View& middle = of_all ? from_corner : view;
    if (!of_all)
        ground_.draw(bodies_[number]);
    for (const GroundTile& other : tiles_)
        for (int z = -2 * images.z; z <= 2 * images.z; ++z)
            for (int x = -2 * images.x; x <= 2 * images.x; ++x) {
                const PlacedObstacle& body = bodies_[other.body];
                const glm::vec3 between = middle.from_middle_of(View(body, glm::ivec3(x, 0, z) * box_.cells, box_));
                if (are_within(margin, own, other.extent, -between))
                    ground_.add(body, between, other.kind);
            }
    ground_.end();
}

} // namespace windrow
