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

// Distances at the corners and centres of the cells.
void Solids::measure(const View& view, const Reach& reach, const Reach& corners) {
    std::size_t n = 0;
    reach.for_each([&](glm::ivec3 cell) { depths_[n++] = view.distance(glm::vec3(cell) + 0.5f); });
    n = 0;
    if (!std::holds_alternative<Plate>(view.body.shape))
        corners.for_each([&](glm::ivec3 corner) { distances_[n++] = view.distance(corner) - k_touch; });
}

// The same, to the bit, over an upright ground, which has one height a column; and its columns.
void Solids::measure_ground(const Ground& ground, const View& view, const Reach& reach, const Reach& corners) {
    const auto fill = [&](const Reach& places, float middle, float touch, detail::HostVector<float>& distances) {
        heights_.clear();
        for (int k = places.low.z; k < places.high.z; ++k)
            for (int i = places.low.x; i < places.high.x; ++i)
                heights_.push_back(detail::height_at(ground, view.own_place(glm::vec3(i, 0, k) + middle)));
        const int across = places.high.x - places.low.x;
        std::size_t n = 0;
        for (int k = 0; k < places.high.z - places.low.z; ++k)
            for (int j = places.low.y; j < places.high.y; ++j) {
                const float y = view.own_place(glm::vec3(0.0f, static_cast<float>(j) + middle, 0.0f)).y;
                for (int i = 0; i < across; ++i)
                    distances[n++] = (y - heights_[static_cast<std::size_t>(k) * across + i]) / view.cell_size - touch;
            }
    };
    fill(corners, 0.0f, k_touch, distances_);
    fill(reach, 0.5f, 0.0f, depths_);
    columns_.clear();
    for (int k = reach.low.z; k < reach.high.z; ++k)
        for (int i = reach.low.x; i < reach.high.x; ++i) {
            const auto level = [&](float x, float z) { // of a place in this column, at height 0
                glm::vec3 place = view.own_place(glm::vec3(static_cast<float>(i) + x, 0.0f, static_cast<float>(k) + z));
                place.y = 0.0f;
                return place;
            };
            const glm::vec3 centre = level(0.5f, 0.5f);
            const float here = heights_[columns_.size()]; // those of the centres, filled last
            Column column;
            const auto meets = [&](float height) {
                const float over = (height - here) / view.cell_size;
                column.low = std::min(column.low, over);
                column.high = std::max(column.high, over);
                return over;
            };
            for (int n = 0; n < 4; ++n) {
                const auto sign = static_cast<float>(2 * (n & 1) - 1);
                meets(detail::height_at(ground, n < 2 ? level(0.5f + sign, 0.5f) : level(0.5f, 0.5f + sign)));
                meets(detail::height_at(ground, level(static_cast<float>(n & 1), static_cast<float>(n >> 1))));
            }
            column.crest[0] = meets(-detail::least_rise(ground, centre, level(1.5f, 0.5f)));
            column.crest[2] = meets(-detail::least_rise(ground, centre, level(0.5f, 1.5f)));
            columns_.push_back(column);
        }
}

// Whether the surface of a body may meet a cell's faces or its neighbours; `away` [cells] from its surface.
bool Solids::may_touch(const View& view, const Reach& reach, glm::ivec3 cell, float away, float within) const {
    const Ground* const ground = std::get_if<Ground>(&view.body.shape);
    const float distance = within * view.coarsest;
    if (ground == nullptr)
        return std::abs(away) <= distance;
    // Beside a steep place the height over the ground is many times the distance from it.
    if (const Column* const column = column_at(reach, cell))
        return away >= column->low - distance && away <= column->high + distance;
    const glm::vec3 place = view.own_place(glm::vec3(cell) + 0.5f);
    const glm::vec2 heights = detail::heights_near(*ground, place, 1.8f * view.coarsest * view.cell_size);
    return place.y >= heights.x - distance * view.cell_size && place.y <= heights.y + distance * view.cell_size;
}

// Of an upright ground.
const Solids::Column* Solids::column_at(const Reach& reach, glm::ivec3 cell) const {
    const auto n = static_cast<std::size_t>((cell.z - reach.low.z) * (reach.high.x - reach.low.x) + cell.x - reach.low.x);
    return columns_.empty() ? nullptr : &columns_[n];
}

// [cells] Of a cell's centre from the surface.
float Solids::depth_at(const View& view, const Reach& reach, glm::ivec3 cell) const {
    return reach.holds(cell) ? depths_[reach.index(cell)] : view.distance(glm::vec3(cell) + 0.5f);
}

// Whether a body passes between the centres of a cell and of its high neighbour, both air, without holding one.
bool Solids::line_is_blocked(const View& view, const Reach& reach, glm::ivec3 cell, int axis) const {
    glm::ivec3 next = cell;
    ++next[axis];
    const bool flat = std::holds_alternative<Plate>(view.body.shape), ground = std::holds_alternative<Ground>(view.body.shape);
    const float away = depth_at(view, reach, cell);
    if (!flat && depth_at(view, reach, next) <= 0.0f)
        return false;
    if (const Column* const column = column_at(reach, cell)) // no vertical line meets it between air and air
        return axis != 1 && away - column->crest[axis] <= detail::k_touches_ground;
    return (ground || away < view.coarsest + k_touch) &&
           detail::blocks(view.body.shape, view.own_place(glm::vec3(cell) + 0.5f), view.own_place(glm::vec3(next) + 0.5f));
}

// Adds the closed faces and the inside cells of one image of a body.
void Solids::draw_image(const PlacedObstacle& body, const Reach& reach, glm::ivec3 offset) {
    const Reach corners{reach.low, reach.high + 1};
    if (reach.count() == 0)
        return;
    const View view(body, offset, box_);
    depths_.resize(reach.count());
    distances_.resize(corners.count());
    const bool upright = body.axes[1] == glm::vec3(0.0f, 1.0f, 0.0f), flat = std::holds_alternative<Plate>(body.shape);
    columns_.clear();
    if (const Ground* const ground = std::get_if<Ground>(&body.shape); ground != nullptr && upright)
        measure_ground(*ground, view, reach, corners);
    else
        measure(view, reach, corners);
    draw_near(view, reach);
    const bool tight = !flat && detail::thickness(body.shape) < k_thin_wall * view.coarsest * view.cell_size;
    std::size_t n = 0;
    reach.for_each([&](glm::ivec3 cell) {
        const float away = depths_[n++];
        const bool in = !flat && away <= 0.0f;
        const bool near = may_touch(view, reach, cell, away, 2.0f);
        if (in)
            draw_inside(view, reach, cell, away, near && may_touch(view, reach, cell, away, 1.5f));
        if (!near)
            return;
        const glm::vec3 centre = glm::vec3(cell) + 0.5f;
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 step(0.0f);
            step[axis] = 1.0f;
            float closed = 0.0f;
            if (!flat) {
                glm::ivec3 face = cell, one(0), other(0);
                ++face[axis];
                one[(axis + 1) % 3] = other[(axis + 2) % 3] = 1;
                const auto at = [&](glm::ivec3 corner) { return distances_[corners.index(corner)]; };
                closed = negative_fraction(at(face), at(face + one), at(face + one + other), at(face + other));
            }
            if (closed < 1.0f && tight && (in || depth_at(view, reach, cell + glm::ivec3(step)) <= 0.0f))
                closed = 1.0f;
            if (closed < 1.0f && !in && line_is_blocked(view, reach, cell, axis))
                closed = 1.0f;
            if (!(closed > k_least_closed))
                continue;
            const float wall = body.moves() ? closed * view.velocity(view.from_middle(centre + 0.5f * step))[axis] : 0.0f;
            drawn_faces_.push_back({cell, axis, closed, wall});
        }
    });
}

// Adds the cells that a reader finds other air in than they hold (reading.h), and those that it may take it from.
void Solids::draw_near(const View& view, const Reach& reach) {
    const float filled = 0.5f * view.coarsest;
    const glm::ivec3 size = reach.high - reach.low;
    const std::size_t strides[3] = {1, static_cast<std::size_t>(size.x), static_cast<std::size_t>(size.x) * size.y};
    std::size_t n = 0;
    reach.for_each([&](glm::ivec3 cell) {
        const float away = depths_[n];
        bool near = away < filled;
        for (int axis = 0; axis < 3 && !near; ++axis)
            near = (cell[axis] > reach.low[axis] && depths_[n - strides[axis]] < filled) ||
                   (cell[axis] + 1 < reach.high[axis] && depths_[n + strides[axis]] < filled);
        if (near && away > -k_under * view.coarsest)
            drawn_near_.push_back({cell, away});
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
        if (!(next > 0.0f))
            continue;
        const glm::vec3 crossing = view.from_middle(centre, -away / (next - away) * out);
        glm::vec3 normal = view.body.axes * detail::normal_at(view.body.shape, view.to_own * crossing, k_apart * view.cell_size);
        if (!(glm::dot(normal, out) > k_aligned))
            normal = out;
        drawn_sides_.push_back({direction, normal, view.body.moves() ? glm::dot(view.velocity(crossing), normal) : 0.0f});
    }
    drawn_inside_.push_back({cell, first, static_cast<std::uint32_t>(drawn_sides_.size()) - first});
}

} // namespace windrow
