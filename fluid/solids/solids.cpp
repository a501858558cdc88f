// Drawings of bodies: which faces they close, and which cells are inside (solids.h). A face's fraction is that of its area where the
// distance is negative, linear between its corners and its middle.
// Based on: Ng, Min & Gibou 2009, Journal of Computational Physics 228 (fractions of faces from distances at their corners).
#include "fluid/solids/solids.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <tuple>
#include <utility>

namespace windrow {
namespace {

// Distances below this fraction of a cell count as 0: a body along the cells' faces has these faces closed, whatever rounding does.
constexpr float k_touch = 1e-4f;
// Closed fraction of a face that a body only touches; it stays open. A block along the cells has three such faces for each that it
// closes, and each costs as much.
constexpr float k_least_closed = 2.0f * k_touch;
constexpr int k_beyond = 8;        // [cells] drawn beyond the box, so that not every shift draws a large body again
constexpr float k_far = 3.0f;      // [cells] from a surface; beyond it a distance need not be right
constexpr double k_parts = 4096.0; // of a cell, in which a body's place is rounded

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

Solids::Solids(const Box& box, int pitch)
    : box_(box), pitch_(pitch), flags_(box.cell_count()), body_of_(box.cell_count()), drawn_of_(box.cell_count()),
      surface_of_(box.cell_count()), layers_(box.cell_count()), face_of_(3 * box.cell_count(), k_none) {}

glm::ivec3 Solids::place_of(std::uint32_t cell) const {
    const auto x = static_cast<std::uint32_t>(box_.cells.x), y = static_cast<std::uint32_t>(box_.cells.y);
    return {static_cast<int>(cell % x), static_cast<int>(cell / x % y), static_cast<int>(cell / x / y)};
}

std::uint32_t Solids::index(glm::ivec3 cell) const {
    return static_cast<std::uint32_t>(box_.index(cell.x, cell.y, cell.z));
}

std::uint32_t Solids::potential_of(glm::ivec3 cell) const {
    return static_cast<std::uint32_t>((static_cast<std::size_t>(cell.z) * box_.cells.y + cell.y) * pitch_ + cell.x);
}

// The neighbour along an axis (side -1 or 1), through a periodic boundary too; false beyond the box.
bool Solids::neighbour(glm::ivec3 cell, int axis, int side, glm::ivec3& result) const {
    result = cell;
    result[axis] += side;
    if (result[axis] >= 0 && result[axis] < box_.cells[axis])
        return true;
    if (!box_.boundaries.periodic(axis) || box_.cells[axis] < 2)
        return false;
    result[axis] -= side * box_.cells[axis];
    return true;
}

bool Solids::at_open_end(glm::ivec3 cell) const {
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            if (cell[axis] == end * (box_.cells[axis] - 1) && box_.boundaries.at(axis, end).kind == BoundaryKind::open)
                return true;
    return false;
}

// --- Drawings ----------------------------------------------------------------------------------------------------------------

void Solids::place(std::span<const PlacedObstacle> obstacles, glm::ivec3 shift) {
    for (const ClosedFace& face : faces_) {
        face_of_[3 * static_cast<std::size_t>(face.cell[0]) + face.axis] = k_none;
        flags_[face.cell[0]] = 0;
    }
    for (const SurfaceCell& cell : surface_)
        flags_[cell.cell] = 0;
    for (const InsideCell& cell : inside_)
        flags_[cell.cell] = layers_[cell.cell] = 0;
    for (const std::uint32_t cell : thin_)
        flags_[cell] = 0;
    for (const std::uint32_t cell : rooms_)
        layers_[cell] = 0;

    detail::make_room(bodies_, obstacles.size());
    bodies_.assign(obstacles.begin(), obstacles.end());
    drawings_.swap(drawings_before_);
    for (Drawing& drawing : drawings_before_) {
        if (box_.rows && shift.y != 0) // the rows lie elsewhere in the world
            drawing.body.position.x = std::numeric_limits<float>::quiet_NaN();
        drawing.body.position -= glm::vec3(shift) * box_.cell_size;
        drawing.low -= shift;
        drawing.high -= shift;
        for (Drawing::Face& face : drawing.faces)
            face.cell -= shift;
        for (Drawing::Inside& inside : drawing.inside)
            inside.cell -= shift;
    }
    // Both lists have about the same order, so that what is looked for is mostly the next.
    drawn_ = 0;
    if (drawings_.size() < bodies_.size())
        drawings_.resize(bodies_.size());
    std::size_t from = 0;
    for (std::size_t n = 0; n < bodies_.size(); ++n) {
        std::size_t tries = 0;
        while (tries < drawings_before_.size() && !still_holds(drawings_before_[from], bodies_[n])) {
            from = from + 1 < drawings_before_.size() ? from + 1 : 0;
            ++tries;
        }
        if (tries < drawings_before_.size()) {
            take(drawings_[n], drawings_before_[from]);
            from = from + 1 < drawings_before_.size() ? from + 1 : 0;
        } else {
            take_room(drawings_[n], bodies_[n]);
            drawings_[n].body = bodies_[n];
            draw(drawings_[n]);
            ++drawn_;
        }
    }
    for (std::size_t n = bodies_.size(); n < drawings_.size(); ++n)
        drawings_[n].body.position.x = std::numeric_limits<float>::quiet_NaN();
    find_thicknesses();
    gather_faces();
    sort_faces();
    layered_.clear();
    layer_ends_.clear();
    find_rooms();
    layer_inside(false);
    if (!rooms_.empty())
        layer_inside(true);
    close_rooms();
    for (const ClosedFace& face : faces_)
        if (face.closed >= 0.5f)
            flags_[face.cell[0]] |= static_cast<std::uint8_t>(1u << face.axis);
    find_shut_cells();
    collect_surface();
    collect_ghosts();
    collect_thin();
    make_room_for_motion();
}

// Cells whose centre, corner or line to a neighbour a body may touch, within the box and `beyond` it.
Solids::Reach Solids::reach_of(const PlacedObstacle& obstacle, glm::ivec3 beyond) const {
    const glm::vec3 own = detail::half_extent(obstacle.shape);
    glm::vec3 half(0.0f);
    for (int axis = 0; axis < 3; ++axis)
        half += glm::abs(obstacle.axes[axis]) * own[axis];
    const float h = box_.cell_size;
    const glm::vec3 least(-beyond), most(box_.cells + beyond);
    const auto place = [&](glm::vec3 metres) {
        glm::vec3 cells = metres / h;
        if (box_.rows)
            cells.y = static_cast<float>(box_.rows->place(static_cast<double>(metres.y)));
        return cells;
    };
    return {glm::ivec3(glm::clamp(glm::floor(place(obstacle.position - half)) - 1.0f, least, most)),
            glm::ivec3(glm::clamp(glm::ceil(place(obstacle.position + half)) + 1.0f, least, most))};
}

bool Solids::still_holds(const Drawing& drawing, const PlacedObstacle& obstacle) const {
    const PlacedObstacle& drawn = drawing.body;
    if (drawn.moves() || obstacle.moves() || !detail::same(drawn.shape, obstacle.shape) || drawn.axes != obstacle.axes)
        return false;
    const glm::vec3 apart = glm::abs(drawn.position - obstacle.position);
    if (!(std::max({apart.x, apart.y, apart.z}) < k_touch * box_.cell_size)) // or taken
        return false;
    const Reach needed = reach_of(obstacle, glm::ivec3(0));
    return glm::all(glm::lessThanEqual(drawing.low, needed.low)) && glm::all(glm::greaterThanEqual(drawing.high, needed.high));
}

void Solids::take(Drawing& drawing, Drawing& before) {
    std::swap(drawing, before);
    before.body.position.x = std::numeric_limits<float>::quiet_NaN();
}

// The room of the body's own last drawing, or the largest that no body has, so that a body that moves on allocates nothing.
void Solids::take_room(Drawing& drawing, const PlacedObstacle& body) {
    Drawing* largest = &drawing;
    const auto room = [](const Drawing& one) { return one.faces.capacity() + one.inside.capacity(); };
    for (Drawing& before : drawings_before_) {
        const bool is_free = std::isnan(before.body.position.x);
        if (!is_free && before.body.slot == body.slot && before.body.generation == body.generation)
            return take(drawing, before);
        if (is_free && room(before) > room(*largest))
            largest = &before;
    }
    if (largest != &drawing)
        take(drawing, *largest);
}

void Solids::draw(Drawing& drawing) {
    drawn_faces_.clear();
    drawn_inside_.clear();
    drawn_sides_.clear();
    const glm::ivec3 images(box_.boundaries.periodic(0), box_.boundaries.periodic(1), box_.boundaries.periodic(2));
    const glm::ivec3 beyond = k_beyond * (1 - images);
    const glm::vec3 size = glm::vec3(box_.cells) * box_.cell_size;
    const Reach whole = reach_of(drawing.body, beyond);
    drawing.low = glm::mix(whole.low, glm::ivec3(0), glm::equal(images, glm::ivec3(1)));
    drawing.high = glm::mix(whole.high, box_.cells, glm::equal(images, glm::ivec3(1)));
    for (int z = -images.z; z <= images.z; ++z)
        for (int y = -images.y; y <= images.y; ++y)
            for (int x = -images.x; x <= images.x; ++x) {
                PlacedObstacle image = drawing.body;
                image.position += glm::vec3(x, y, z) * size;
                draw_image(drawing.body, reach_of(image, beyond), glm::ivec3(x, y, z) * box_.cells);
            }
    if (images != glm::ivec3(0)) { // images of one body may overlap: they close a face once
        const auto order = [](const Drawing::Face& face) {
            return std::tuple(face.cell.z, face.cell.y, face.cell.x, face.axis, -face.closed);
        };
        const auto same = [](const Drawing::Face& a, const Drawing::Face& b) { return a.cell == b.cell && a.axis == b.axis; };
        std::sort(drawn_faces_.begin(), drawn_faces_.end(), [&](const auto& a, const auto& b) { return order(a) < order(b); });
        drawn_faces_.erase(std::unique(drawn_faces_.begin(), drawn_faces_.end(), same), drawn_faces_.end());
    }
    detail::make_room(drawing.faces, drawn_faces_.size());
    detail::make_room(drawing.inside, drawn_inside_.size());
    detail::make_room(drawing.sides, drawn_sides_.size());
    drawing.faces.assign(drawn_faces_.begin(), drawn_faces_.end());
    drawing.inside.assign(drawn_inside_.begin(), drawn_inside_.end());
    drawing.sides.assign(drawn_sides_.begin(), drawn_sides_.end());
}

// Where the cells of the box are from one image of a body.
struct Solids::View {
    const PlacedObstacle& body;
    float cell_size;
    const RowTable* rows;
    float coarsest; // [cells] distance between two cells
    glm::mat3 to_own = glm::transpose(body.axes);
    glm::vec3 base{0.0f}, part{0.0f}; // [cells] the body's middle: whole cells and the rest

    // From the cell that holds the middle, so that a body has the same cells wherever the box is.
    View(const PlacedObstacle& seen, glm::ivec3 offset, const Box& box)
        : body(seen), cell_size(box.cell_size), rows(box.rows.get()), coarsest(box.coarsest() / box.cell_size) {
        const float h = cell_size;
        const glm::dvec3 middle = glm::dvec3(body.position) / static_cast<double>(h) + glm::dvec3(offset);
        const glm::dvec3 whole = glm::floor(middle);
        base = glm::vec3(whole);
        part = glm::vec3(glm::round((middle - whole) * k_parts) / k_parts);
    }
    // `beside`: the rest of a place that no float holds exactly.
    [[nodiscard]] glm::vec3 from_middle(glm::vec3 cell, glm::vec3 beside = glm::vec3(0.0f)) const {
        glm::vec3 away = ((cell - base) - part + beside) * cell_size;
        if (rows != nullptr)
            away.y = static_cast<float>(rows->height_at(static_cast<double>(cell.y + beside.y)) -
                                        static_cast<double>(body.position.y));
        return away;
    }
    [[nodiscard]] glm::vec3 own_place(glm::vec3 cell) const { return to_own * from_middle(cell); }
    [[nodiscard]] float distance(glm::vec3 cell) const { // [cells]
        return detail::distance_to(body.shape, own_place(cell), k_far * coarsest * cell_size) / cell_size;
    }
    [[nodiscard]] glm::vec3 velocity(glm::vec3 away) const { return body.velocity + glm::cross(body.spin, away); }
};

float Solids::height_over(std::size_t number, glm::ivec3 cell) const {
    const PlacedObstacle& body = bodies_[number];
    const glm::vec3 centre = glm::vec3(cell) + 0.5f;
    const glm::ivec3 images(box_.boundaries.periodic(0), box_.boundaries.periodic(1), box_.boundaries.periodic(2));
    float nearest = std::numeric_limits<float>::max();
    for (int z = -images.z; z <= images.z; ++z)
        for (int y = -images.y; y <= images.y; ++y)
            for (int x = -images.x; x <= images.x; ++x)
                nearest = std::min(nearest, View(body, glm::ivec3(x, y, z) * box_.cells, box_).distance(centre));
    const Ground* const ground = std::get_if<Ground>(&body.shape);
    return ground != nullptr ? nearest / detail::nearness(*ground) : nearest;
}

// visit(cell) in the order of Reach::index.
template <class Visit>
void Solids::Reach::for_each(const Visit& visit) const {
    for (int k = low.z; k < high.z; ++k)
        for (int j = low.y; j < high.y; ++j)
            for (int i = low.x; i < high.x; ++i)
                visit(glm::ivec3(i, j, k));
}

// Distances at the corners and centres of the cells.
void Solids::measure(const View& view, const Reach& reach, const Reach& corners) {
    std::size_t n = 0;
    reach.for_each([&](glm::ivec3 cell) { depths_[n++] = view.distance(glm::vec3(cell) + 0.5f); });
    n = 0;
    if (!std::holds_alternative<Plate>(view.body.shape))
        corners.for_each([&](glm::ivec3 corner) { distances_[n++] = view.distance(corner) - k_touch; });
}

// The same, to the bit, over an upright ground, which has one height a column.
void Solids::measure_ground(const Ground& ground, const View& view, const Reach& reach, const Reach& corners) {
    const auto fill = [&](const Reach& places, float middle, float touch, detail::HostVector<float>& distances) {
        heights_.clear();
        for (int k = places.low.z; k < places.high.z; ++k)
            for (int i = places.low.x; i < places.high.x; ++i)
                heights_.push_back(detail::height_at(ground, view.own_place(glm::vec3(i, 0, k) + middle)));
        const float nearness = detail::nearness(ground);
        const int across = places.high.x - places.low.x;
        std::size_t n = 0;
        for (int k = 0; k < places.high.z - places.low.z; ++k)
            for (int j = places.low.y; j < places.high.y; ++j) {
                const float y = view.own_place(glm::vec3(0.0f, static_cast<float>(j) + middle, 0.0f)).y;
                for (int i = 0; i < across; ++i)
                    distances[n++] = (y - heights_[static_cast<std::size_t>(k) * across + i]) * nearness / view.cell_size - touch;
            }
    };
    fill(reach, 0.5f, 0.0f, depths_);
    fill(corners, 0.0f, k_touch, distances_);
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
    if (const Ground* const ground = std::get_if<Ground>(&body.shape); ground != nullptr && upright)
        measure_ground(*ground, view, reach, corners);
    else
        measure(view, reach, corners);
    std::size_t n = 0;
    reach.for_each([&](glm::ivec3 cell) {
        const float away = depths_[n++];
        const bool in = !flat && away <= 0.0f;
        if (in)
            draw_inside(view, reach, cell, away);
        if (std::abs(away) > 2.0f * view.coarsest)
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
            if (closed < 1.0f && !in && away < view.coarsest + k_touch) { // also where the next centre is on the surface
                const glm::vec3 here = view.own_place(centre), beyond = view.own_place(centre + step);
                if ((flat || detail::distance_to(body.shape, beyond) > 0.0f) && detail::blocks(body.shape, here, beyond))
                    closed = 1.0f;
            }
            if (!(closed > k_least_closed))
                continue;
            const float wall = body.moves() ? closed * view.velocity(view.from_middle(centre + 0.5f * step))[axis] : 0.0f;
            drawn_faces_.push_back({cell, axis, closed, wall});
        }
    });
}

// Adds an inside cell, `away` [cells] from the surface, with its sides toward cells outside.
void Solids::draw_inside(const View& view, const Reach& reach, glm::ivec3 cell, float away) {
    constexpr float k_apart = 0.1f;   // [cells] of the distances that a normal is found from
    constexpr float k_aligned = 0.1f; // a normal turned farther from the way outside is that of an edge
    const auto first = static_cast<std::uint32_t>(drawn_sides_.size());
    const glm::vec3 centre = glm::vec3(cell) + 0.5f;
    for (std::uint32_t direction = 0; direction < 6 && away > -1.5f * view.coarsest; ++direction) {
        glm::ivec3 step(0);
        step[static_cast<int>(direction / 2)] = direction % 2 == 0 ? -1 : 1;
        const glm::vec3 out(step);
        const float next = reach.holds(cell + step) ? depths_[reach.index(cell + step)] : view.distance(centre + out);
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

void Solids::name_faces(std::vector<std::uint32_t>& names) const {
    detail::make_room(names, faces_.size());
    names.clear();
    for (const ClosedFace& face : faces_)
        names.push_back(4 * face.cell[0] + face.axis);
}

void Solids::find_origins(std::span<const std::uint32_t> before, glm::ivec3 shift, std::vector<std::int32_t>& origins) {
    detail::make_room(origins, faces_.size());
    detail::make_room(closes_new_, bodies_.size());
    origins.assign(faces_.size(), -1);
    closes_new_.assign(bodies_.size(), 0);
    if (box_.rows && shift.y != 0)
        before = {};
    std::size_t from = 0; // both lists are sorted by cell; a shift of the box does not change the order of the cells that stay
    for (std::size_t n = 0; n < faces_.size(); ++n) {
        const ClosedFace& face = faces_[n];
        const glm::ivec3 then = glm::ivec3(face.place[0], face.place[1], face.place[2]) + shift;
        if (glm::all(glm::greaterThanEqual(then, glm::ivec3(0))) && glm::all(glm::lessThan(then, box_.cells))) {
            const std::uint32_t name = 4 * index(then) + face.axis;
            while (from < before.size() && before[from] < name)
                ++from;
            if (from < before.size() && before[from] == name)
                origins[n] = static_cast<std::int32_t>(from);
        }
        if (origins[n] < 0 && bodies_[face.body].moves())
            closes_new_[face.body] = 1;
    }
    for (std::size_t n = 0; n < faces_.size(); ++n)
        if (closes_new_[faces_[n].body] != 0)
            origins[n] = -1;
}

} // namespace windrow
