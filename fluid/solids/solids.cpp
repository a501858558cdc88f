// Placement of obstacles in a box: drawings that are kept, taken over or made (drawing.cpp), and what is found from them (solid_lists.cpp).
#include "fluid/solids/solids.h"

#include "fluid/solids/body_view.h"

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

constexpr int k_beyond = 8; // [cells] drawn beyond the box, so that not every shift draws a large body again

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
        for (Drawing::Near& near : drawing.near)
            near.cell -= shift;
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
    drawn_near_.clear();
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
    detail::make_room(drawing.near, drawn_near_.size());
    drawing.faces.assign(drawn_faces_.begin(), drawn_faces_.end());
    drawing.inside.assign(drawn_inside_.begin(), drawn_inside_.end());
    drawing.sides.assign(drawn_sides_.begin(), drawn_sides_.end());
    drawing.near.assign(drawn_near_.begin(), drawn_near_.end());
}

float Solids::height_over(std::size_t number, glm::ivec3 cell) const {
    const PlacedObstacle& body = bodies_[number];
    const glm::vec3 centre = glm::vec3(cell) + 0.5f;
    const glm::ivec3 images(box_.boundaries.periodic(0), box_.boundaries.periodic(1), box_.boundaries.periodic(2));
    float nearest = std::numeric_limits<float>::max();
    for (int z = -images.z; z <= images.z; ++z)
        for (int y = -images.y; y <= images.y; ++y)
            for (int x = -images.x; x <= images.x; ++x)
                nearest = std::min(nearest, View(body, glm::ivec3(x, y, z) * box_.cells, box_).distance(centre));
    return nearest;
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
