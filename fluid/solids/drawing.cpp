// Drawings of bodies: which faces they close, and which cells are inside (solids.h). A face's fraction is that of its area where the
// distance is negative, linear between its corners and its middle. A body thinner than k_thin_wall cells closes all faces of the
// cells whose centres it holds: it may hold no corner of a face, and the air would pass through them.
// Based on: Ng, Min & Gibou 2009, Journal of Computational Physics 228 (fractions of faces from distances at their corners).
#include "fluid/solids/body_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace windrow {
namespace {

// Fraction of a triangle's area where a linear function is negative.
float negative_fraction(float a, float b, float c) {
    if (a > b)
        std::swap(a, b);
    if (b > c)
        std::swap(b, c);
    if (a > b)
        std::swap(a, b);
    if (c <= 0.0f)
        return 1.0f;
    if (a >= 0.0f)
        return 0.0f;
    if (b >= 0.0f)
        return a * a / ((b - a) * (c - a));
    return 1.0f - c * c / ((c - a) * (c - b));
}

// Of a square, from the distances at its corners in order around it, by four triangles about its middle.
float negative_fraction(float a, float b, float c, float d) {
    if (a >= 0.0f && b >= 0.0f && c >= 0.0f && d >= 0.0f)
        return 0.0f;
    const float middle = 0.25f * (a + b + c + d);
    return 0.25f * (negative_fraction(a, b, middle) + negative_fraction(b, c, middle) + negative_fraction(c, d, middle) +
                    negative_fraction(d, a, middle));
}

} // namespace

// Distances at the corners and centres of the cells, from the body with those that it touches.
void Solids::measure(const View& view, const Reach& reach) {
    const Reach corners{reach.low, reach.high + 1};
    depths_.resize(reach.count());
    distances_.resize(corners.count());
    before_.resize(together_.any_drawn_before() ? corners.count() : 0);
    std::size_t n = 0;
    reach.for_each([&](glm::ivec3 cell) { depths_[n++] = away_at(view, glm::vec3(cell) + 0.5f); });
    n = 0;
    if (std::holds_alternative<Plate>(view.body.shape))
        return;
    corners.for_each([&](glm::ivec3 corner) {
        if (before_.empty()) {
            distances_[n++] = away_at(view, corner) - k_touch;
            return;
        }
        const Together::Apart apart = together_.apart(view.from_middle(corner));
        distances_[n] = apart.own / view.cell_size - k_touch;
        before_[n++] = std::max(apart.own, apart.before) / view.cell_size - k_touch;
    });
}

// The same over an upright ground, which has one level a column, with its columns. The reach ends above what the surface touches.
void Solids::measure_ground(const View& view, Reach& reach, const Reach& drawn) {
    const auto find_levels = [&](glm::ivec3 low, glm::ivec3 high, float middle, std::vector<TiledGround::Level>& levels) {
        levels.clear();
        for (int k = low.z; k < high.z; ++k)
            for (int i = low.x; i < high.x; ++i) {
                const glm::vec3 place = view.from_middle(glm::vec3(i, 0, k) + middle);
                levels.push_back(ground_.at({place.x, place.z}));
            }
    };
    find_levels(reach.low, reach.high, 0.5f, levels_);
    find_levels(reach.low, reach.high + 1, 0.0f, corner_levels_);
    float highest = -std::numeric_limits<float>::infinity(); // [m] from the body's middle
    columns_.assign(levels_.size(), {});
    owners_.clear();
    std::size_t n = 0;
    for (int k = reach.low.z; k < reach.high.z; ++k)
        for (int i = reach.low.x; i < reach.high.x; ++i, ++n) {
            const glm::vec3 centre = view.from_middle(glm::vec3(i, 0, k) + 0.5f);
            owners_.push_back(ground_.owner({centre.x, centre.z}));
            if (i < drawn.low.x || k < drawn.low.z || i >= drawn.high.x || k >= drawn.high.z)
                continue;
            columns_[n] = column_at(view, reach, i, k);
            highest = std::max(highest, columns_[n].level + columns_[n].high * view.cell_size);
        }
    const auto over = [&](int row) {
        return view.from_middle(glm::vec3(0.0f, static_cast<float>(row) + 0.5f, 0.0f)).y - highest;
    };
    int top = reach.low.y;
    while (top < reach.high.y && !(over(top) > k_beside * view.coarsest * view.cell_size))
        ++top;
    reach.high.y = std::min(top + 1, reach.high.y);

    const auto fill = [&](glm::ivec3 size, float middle, float touch, const std::vector<TiledGround::Level>& levels,
                          detail::HostVector<float>& distances) {
        distances.resize(static_cast<std::size_t>(size.x) * size.y * size.z);
        std::size_t to = 0;
        for (int k = 0; k < size.z; ++k)
            for (int j = 0; j < size.y; ++j) {
                const float y = view.from_middle(glm::vec3(0.0f, static_cast<float>(reach.low.y + j) + middle, 0.0f)).y;
                for (int i = 0; i < size.x; ++i) {
                    const TiledGround::Level& level = levels[static_cast<std::size_t>(k) * size.x + i];
                    const bool simple = level.ground && level.end >= ground_.far();
                    float away = level.rise(y);
                    if (!simple) {
                        glm::vec3 place = view.from_middle(glm::vec3(reach.low + glm::ivec3(i, j, k)) + middle);
                        away = ground_.away(level, place);
                    }
                    distances[to++] = away / view.cell_size - touch;
                }
            }
    };
    fill(reach.high - reach.low + 1, 0.0f, k_touch, corner_levels_, distances_);
    fill(reach.high - reach.low, 0.5f, 0.0f, levels_, depths_);
}

// From the levels of the reach, which holds the next columns.
Solids::Column Solids::column_at(const View& view, const Reach& reach, int i, int k) const {
    const int across = reach.high.x - reach.low.x;
    const auto level = [&](int x, int z) -> const TiledGround::Level& {
        return levels_[static_cast<std::size_t>((k + z - reach.low.z) * across + i + x - reach.low.x)];
    };
    const TiledGround::Level& here = level(0, 0);
    Column column;
    column.ends = !here.ground || here.end < k_beside * view.coarsest * view.cell_size;
    column.level = here.ground ? here.level() : 0.0f;
    const auto meets = [&](float height) {
        const float over = (height - column.level) / view.cell_size;
        column.low = std::min(column.low, over);
        column.high = std::max(column.high, over);
        return over;
    };
    const auto meets_ground = [&](const TiledGround::Level& other) {
        if (other.ground)
            meets(other.level());
    };
    for (int n = 0; n < 4; ++n) {
        const int sign = 2 * (n & 1) - 1;
        meets_ground(n < 2 ? level(sign, 0) : level(0, sign));
        meets_ground(
            corner_levels_[static_cast<std::size_t>((k + (n >> 1) - reach.low.z) * (across + 1) + i + (n & 1) - reach.low.x)]);
    }
    const auto centre = [&](int x, int z) {
        const glm::vec3 at = view.from_middle(glm::vec3(i + x, 0, k + z) + 0.5f);
        return glm::vec2(at.x, at.z);
    };
    column.crest[0] = meets(ground_.crest(centre(0, 0), centre(1, 0)));
    column.crest[2] = meets(ground_.crest(centre(0, 0), centre(0, 1)));
    if (column.ends) { // it may meet an end whose height is that of a place between these
        column.low = -std::numeric_limits<float>::infinity();
        column.high = std::numeric_limits<float>::infinity();
    }
    return column;
}

// [cells] Of a cell over the level of its column.
float Solids::rise_over(const View& view, const Column& column, glm::ivec3 cell, float away) {
    return column.ends ? (view.from_middle(glm::vec3(cell) + 0.5f).y - column.level) / view.cell_size : away;
}

// [cells] Of a place [cells] from the surface that is drawn.
float Solids::away_at(const View& view, glm::vec3 place) const {
    const glm::vec3 away = view.from_middle(place);
    return (ground_.empty() ? together_.away(away) : ground_.away(away)) / view.cell_size;
}

TiledGround::Owner Solids::owner_of(const Reach& reach, glm::ivec3 cell) const {
    return owners_.empty() ? TiledGround::Owner::drawn : owners_[reach.column(cell)];
}

// Whether the surface of a body may meet a cell's faces or its neighbours; `away` [cells] from its surface.
bool Solids::may_touch(const View& view, const Reach& reach, glm::ivec3 cell, float away, float within) const {
    const Ground* const ground = std::get_if<Ground>(&view.body.shape);
    const float distance = within * view.coarsest;
    if (ground == nullptr)
        return std::abs(away) <= distance;
    // Beside a steep place the height over the ground is many times the distance from it.
    if (const Column* const column = column_of(reach, cell)) {
        const float rise = rise_over(view, *column, cell, away);
        return rise >= column->low - distance && rise <= column->high + distance;
    }
    const glm::vec3 place = view.own_place(glm::vec3(cell) + 0.5f);
    const glm::vec2 heights = detail::heights_near(*ground, place, 1.8f * view.coarsest * view.cell_size);
    return place.y >= heights.x - distance * view.cell_size && place.y <= heights.y + distance * view.cell_size;
}

// Of an upright ground.
const Solids::Column* Solids::column_of(const Reach& reach, glm::ivec3 cell) const {
    return columns_.empty() ? nullptr : &columns_[reach.column(cell)];
}

// [cells] Of a cell's centre from the surface.
float Solids::depth_at(const View& view, const Reach& reach, glm::ivec3 cell) const {
    return reach.holds(cell) ? depths_[reach.index(cell)] : away_at(view, glm::vec3(cell) + 0.5f);
}

// Whether a body passes between the centres of a cell and of its high neighbour, which it does not hold.
bool Solids::line_is_blocked(const View& view, const Reach& reach, glm::ivec3 cell, int axis) const {
    glm::ivec3 next = cell;
    ++next[axis];
    const bool ground = std::holds_alternative<Ground>(view.body.shape);
    const float away = depth_at(view, reach, cell);
    if (const Column* const column = column_of(reach, cell)) // no vertical line meets it between air and air
        return axis != 1 && rise_over(view, *column, cell, away) - column->crest[axis] <= detail::k_touches;
    return (ground || away < view.coarsest + k_touch) &&
           together_.blocks(view.from_middle(glm::vec3(cell) + 0.5f), view.from_middle(glm::vec3(next) + 0.5f));
}

// Whether another piece of the whole that a body is a part of draws what is at a place [cells], or another body that it touches: the centre
// of a cell, or the middle of a face, whose wall is the body that is nearest to it.
bool Solids::is_anothers(std::size_t number, const View& view, glm::vec3 place) const {
    return (wholes_.is_part(number) && wholes_.is_anothers(number, view.own_place(place))) ||
           (ground_.empty() && together_.is_anothers(view.from_middle(place)));
}

// Adds the closed faces and the inside cells of one image of a body.
void Solids::draw_image(std::size_t number, const Reach& drawn, glm::ivec3 offset) {
    if (drawn.count() == 0)
        return;
    const PlacedObstacle& body = wholes_.of(number);
    const View view(body, offset, box_);
    const bool flat = std::holds_alternative<Plate>(body.shape);
    Reach reach = drawn;
    columns_.clear();
    owners_.clear();
    collect_ground(number, view);
    collect_together(number, view, bodies_[number].moves() ? beside_ : drawings_[number].beside);
    if (ground_.empty()) {
        measure(view, reach);
    } else {
        before_.clear();
        reach.low -= glm::ivec3(1, 0, 1);
        reach.high += glm::ivec3(1, 0, 1);
        measure_ground(view, reach, drawn);
    }
    const Reach corners{reach.low, reach.high + 1};
    draw_near(number, view, reach, drawn);
    const bool tight = is_tight(number, thickness_of_[number]);
    shut_.clear();
    if (!tight && ground_.empty() && together_.any_edges())
        reach.for_each([&](glm::ivec3 cell) { shut_.push_back(shut_by_edges(view, cell, depths_[shut_.size()])); });
    const auto holds_own = [&](glm::ivec3 cell, float away) { // what was drawn before it holds none of its cells
        return !flat && holds(away) &&
               (before_.empty() || together_.holds_own(view.from_middle(glm::vec3(cell) + 0.5f), k_touch * view.cell_size));
    };
    std::size_t n = 0;
    reach.for_each([&](glm::ivec3 cell) {
        const float away = depths_[n++];
        const Column* const column = column_of(reach, cell);
        if (column != nullptr) {
            if (!drawn.holds(cell))
                return;
            if (!column->ends && away > column->high + k_beside * view.coarsest)
                return; // above all that it meets
        }
        const TiledGround::Owner owner = owner_of(reach, cell);
        const bool near = may_touch(view, reach, cell, away, k_beside);
        if (owner == TiledGround::Owner::other || (!near && !holds(away)))
            return;
        const glm::vec3 centre = glm::vec3(cell) + 0.5f;
        const bool in = holds_own(cell, away);
        if (in && !is_anothers(number, view, centre))
            draw_inside(view, reach, cell, away, near && may_touch(view, reach, cell, away, 1.5f));
        if (!near)
            return;
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 step(0.0f);
            step[axis] = 1.0f;
            if (owner == TiledGround::Owner::none &&
                (axis == 1 || owner_of(reach, cell + glm::ivec3(step)) != TiledGround::Owner::drawn))
                continue;
            if (is_anothers(number, view, centre + 0.5f * step))
                continue;
            const auto fraction = [&](const detail::HostVector<float>& distances) {
                glm::ivec3 face = cell, one(0), other(0);
                ++face[axis];
                one[(axis + 1) % 3] = other[(axis + 2) % 3] = 1;
                const auto at = [&](glm::ivec3 corner) { return distances[corners.index(corner)]; };
                return negative_fraction(at(face), at(face + one), at(face + one + other), at(face + other));
            };
            const glm::ivec3 next = cell + glm::ivec3(step);
            float closed = flat ? 0.0f : fraction(distances_);
            if (closed < 1.0f) {
                const bool holds_one = in || holds_own(next, depth_at(view, reach, next));
                if (!holds_one && line_is_blocked(view, reach, cell, axis))
                    closed = 1.0f;
                else if (holds_one && tight)
                    closed = 1.0f;
                else if (!shut_.empty())
                    closed += (1.0f - closed) * std::max(shut_at(view, reach, cell, axis), shut_at(view, reach, next, axis));
            }
            if (!before_.empty())
                closed -= fraction(before_);
            if (!(closed > k_least_closed))
                continue;
            const float wall = body.moves() ? closed * view.velocity(view.from_middle(centre + 0.5f * step))[axis] : 0.0f;
            drawn_faces_.push_back({cell, axis, closed, wall});
        }
    });
}

// How far a cell at sharp edges along each axis is shut (edges.h), `away` [cells] from the surface: wholly .2 cells inside the body, not at
// all .3 outside, so that a body that moves closes it by and by. What is drawn before the body has no part in it.
glm::vec3 Solids::shut_by_edges(const View& view, glm::ivec3 cell, float away) const {
    constexpr float k_at_surface = 0.6f, k_slope = 2.0f; // [1/cell]
    const glm::vec3 centre = glm::vec3(cell) + 0.5f, up(0.0f, 0.5f, 0.0f);
    if (!before_.empty() && away < k_at_surface / k_slope)
        away = together_.own_away(view.from_middle(centre)) / view.cell_size;
    const float row = view.from_middle(centre + up).y - view.from_middle(centre - up).y;
    away /= std::min(row / view.cell_size, 1.0f);
    const float shut = std::clamp(k_at_surface - k_slope * away, 0.0f, 1.0f);
    if (!(shut > 0.0f && away > -k_beside * view.coarsest))
        return glm::vec3(0.0f);
    return shut * together_.edges_at(view.from_middle(centre), {view.cell_size, row, view.cell_size});
}

// How far a face of a cell across an axis is shut: air that goes along an edge passes.
float Solids::shut_at(const View& view, const Reach& reach, glm::ivec3 cell, int axis) const {
    const glm::vec3 shut =
        reach.holds(cell) ? shut_[reach.index(cell)] : shut_by_edges(view, cell, away_at(view, glm::vec3(cell) + 0.5f));
    return std::max(shut[(axis + 1) % 3], shut[(axis + 2) % 3]);
}

// Adds the cells that a reader finds other air in than they hold (reading.h), and those that it may take it from.
void Solids::draw_near(std::size_t number, const View& view, const Reach& reach, const Reach& drawn) {
    const float filled = 0.5f * view.coarsest;
    const glm::ivec3 size = reach.high - reach.low;
    const std::size_t strides[3] = {1, static_cast<std::size_t>(size.x), static_cast<std::size_t>(size.x) * size.y};
    std::size_t n = 0;
    reach.for_each([&](glm::ivec3 cell) {
        const float away = depths_[n];
        bool near = away < filled;
        if (away > -k_under * view.coarsest && drawn.holds(cell) && owner_of(reach, cell) != TiledGround::Owner::other) {
            for (int axis = 0; axis < 3 && !near; ++axis)
                near = (cell[axis] > reach.low[axis] && depths_[n - strides[axis]] < filled) ||
                       (cell[axis] + 1 < reach.high[axis] && depths_[n + strides[axis]] < filled);
            if (near && !is_anothers(number, view, glm::vec3(cell) + 0.5f)) {
                const bool others = away > 0.0f && !before_.empty(); // what was drawn before it has the cells near to itself
                drawn_near_.push_back(
                    {cell, others ? together_.own_away(view.from_middle(glm::vec3(cell) + 0.5f)) / view.cell_size : away});
            }
        }
        ++n;
    });
}

// Adds an inside cell, `away` [cells] from the surface, with its sides toward cells outside, if it may be `beside` some.
void Solids::draw_inside(const View& view, const Reach& reach, glm::ivec3 cell, float away, bool beside) {
    constexpr float k_apart = 0.1f;   // [cells] of the distances that a normal is found from
    constexpr float k_aligned = 0.1f; // a normal turned farther from the way outside is that of an edge
    const auto first = static_cast<std::uint32_t>(drawn_sides_.size());
    const glm::vec3 centre = glm::vec3(cell) + 0.5f;
    for (std::uint32_t direction = 0; direction < 6 && beside; ++direction) {
        glm::ivec3 step(0);
        step[static_cast<int>(direction / 2)] = direction % 2 == 0 ? -1 : 1;
        const glm::vec3 out(step);
        const float next = depth_at(view, reach, cell + step);
        if (holds(next))
            continue;
        const glm::vec3 crossing = view.from_middle(centre, std::max(-away, 0.0f) / (next - away) * out);
        const float apart = k_apart * view.cell_size;
        glm::vec3 normal = ground_.empty() ? together_.normal(crossing, apart) : ground_.normal(crossing, apart);
        if (!(glm::dot(normal, out) > k_aligned))
            normal = out;
        drawn_sides_.push_back({direction, normal, view.body.moves() ? glm::dot(view.velocity(crossing), normal) : 0.0f});
    }
    drawn_inside_.push_back({cell, first, static_cast<std::uint32_t>(drawn_sides_.size()) - first});
}

} // namespace windrow
