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
            if (cell[axis] == end * (box_.cells[axis] - 1) && is_open_end(axis, end))
                return true;
    return false;
}

// --- Drawings ----------------------------------------------------------------------------------------------------------------

void Solids::place(std::span<const PlacedObstacle> obstacles, glm::ivec3 shift) {
    const bool tiles_are_drawn = std::exchange(tiles_are_drawn_, false); // until all is: memory may end
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
    std::size_t from = 0, resting = 0, stand_as_before = 0;
    kept_.assign(bodies_.size(), 0);
    for (std::size_t n = 0; n < bodies_.size(); ++n) {
        std::size_t tries = 0;
        while (tries < drawings_before_.size() && !is_drawing_of(drawings_before_[from], bodies_[n])) {
            from = from + 1 < drawings_before_.size() ? from + 1 : 0;
            ++tries;
        }
        resting += bodies_[n].moves() ? 0 : 1;
        if (tries < drawings_before_.size()) {
            take(drawings_[n], drawings_before_[from]);
            from = from + 1 < drawings_before_.size() ? from + 1 : 0;
            kept_[n] = 1;
            ++stand_as_before;
        }
    }
    find_tiles();
    find_tile_places();
    find_changed_tiles();
    find_drawers(tiles_are_drawn && shift == glm::ivec3(0) && changed_tiles_.empty());
    // Not as before until all is found: memory may end.
    const bool rest_as_before = std::exchange(resting_, k_none) == resting && resting == stand_as_before;
    wholes_.find(bodies_, box_.cell_size, rest_as_before);
    detail::make_room(thickness_of_, bodies_.size());
    thickness_of_.resize(bodies_.size());
    if (!rest_as_before || resting < bodies_.size())
        sort_by_place();
    for (std::size_t n = 0; n < bodies_.size(); ++n) {
        // Bodies at rest have the neighbours that they had, if each stood there before and none has gone.
        const bool as_before = rest_as_before && kept_[n] != 0;
        const bool tile = tile_of_[n] != k_none, looks = !as_before && !tile;
        if (tile && draws_[tile_of_[n]] == 0) {
            leave_out(n);
            continue;
        }
        if (looks)
            find_beside(n);
        const bool as_thick = tile ? tiles_are_drawn && kept_[n] != 0 && drawings_[n].thickness != k_unknown &&
                                         !any_changed_near(n, k_farthest_row * box_.coarsest())
                                   : as_before;
        thickness_of_[n] = as_thick ? drawings_[n].thickness : find_thickness(n);
        const bool tight = is_tight(n, thickness_of_[n]);
        if (kept_[n] != 0) {
            drawings_[n].body = bodies_[n];
            const bool as_tight = tight == is_tight(n, drawings_[n].thickness);
            drawings_[n].thickness = thickness_of_[n];
            if (as_tight && wholes_.is_same(wholes_.part(n), drawings_[n].part) && (!tile || tiles_are_drawn) &&
                (still_holds(n, looks) || draw_rest(n)))
                continue;
        } else {
            take_room(drawings_[n], bodies_[n]);
        }
        drawings_[n].body = bodies_[n];
        drawings_[n].draws = true;
        drawings_[n].thickness = thickness_of_[n];
        drawings_[n].part = wholes_.part(n);
        if (looks && !bodies_[n].moves())
            drawings_[n].beside.assign(beside_.begin(), beside_.end()); // beside_ keeps its room for bodies that move
        draw(n);
        ++drawn_;
    }
    resting_ = resting;
    tiles_are_drawn_ = true;
    for (std::size_t n = bodies_.size(); n < drawings_.size(); ++n)
        drawings_[n].body.position.x = std::numeric_limits<float>::quiet_NaN();
    count_thicknesses();
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
    add_end_faces();
    find_facing();
    collect_open_sides();
    collect_surface();
    find_sealed();
    collect_ghosts();
    collect_thin();
    make_room_for_motion();
}

// Cells whose centre, corner or line to a neighbour a body may touch, within the box and `beyond` it.
Solids::Reach Solids::reach_of(const PlacedObstacle& obstacle, glm::ivec3 beyond) const {
    const detail::Extent extent = detail::extent_of(obstacle);
    const float h = box_.cell_size;
    const glm::vec3 least(-beyond), most(box_.cells + beyond);
    const auto place = [&](glm::vec3 metres) {
        glm::vec3 cells = metres / h;
        if (box_.rows)
            cells.y = static_cast<float>(box_.rows->place(static_cast<double>(metres.y)));
        return cells;
    };
    return {glm::ivec3(glm::clamp(glm::floor(place(obstacle.position + extent.low)) - 1.0f, least, most)),
            glm::ivec3(glm::clamp(glm::ceil(place(obstacle.position + extent.high)) + 1.0f, least, most))};
}

bool Solids::is_drawing_of(const Drawing& drawing, const PlacedObstacle& obstacle) const {
    const PlacedObstacle& drawn = drawing.body;
    if (drawn.moves() || obstacle.moves() || !detail::same(drawn.shape, obstacle.shape) || drawn.axes != obstacle.axes)
        return false;
    const glm::vec3 apart = glm::abs(drawn.position - obstacle.position);
    return std::max({apart.x, apart.y, apart.z}) < k_touch * box_.cell_size; // not where it was taken
}

// Whether the drawing of a body has all cells that the box has now, beside the same bodies.
bool Solids::still_holds(std::size_t number, bool looked_beside) const {
    const Drawing& drawing = drawings_[number];
    if (tile_of_[number] != k_none && any_changed_near(number, beside_margin()))
        return false;
    const Reach needed = reach_of(drawing.body, needed_beyond());
    return glm::all(glm::lessThanEqual(drawing.low, needed.low)) && glm::all(glm::greaterThanEqual(drawing.high, needed.high)) &&
           (!looked_beside || (drawing.beside.size() == beside_.size() && are_same(beside_, drawing.beside)));
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

void Solids::draw(std::size_t number) {
    Drawing& drawing = drawings_[number];
    clear_drawn();
    const glm::ivec3 images = 1 - needed_beyond();
    const glm::ivec3 beyond = k_beyond * needed_beyond();
    const glm::vec3 size = glm::vec3(box_.cells) * box_.cell_size;
    const Reach whole = reach_of(drawing.body, beyond);
    drawing.low = glm::mix(whole.low, glm::ivec3(0), glm::equal(images, glm::ivec3(1)));
    drawing.high = glm::mix(whole.high, box_.cells, glm::equal(images, glm::ivec3(1)));
    for (int z = -images.z; z <= images.z; ++z)
        for (int y = -images.y; y <= images.y; ++y)
            for (int x = -images.x; x <= images.x; ++x) {
                PlacedObstacle image = drawing.body;
                image.position += glm::vec3(x, y, z) * size;
                draw_image(number, reach_of(image, beyond), glm::ivec3(x, y, z) * box_.cells);
            }
    if (images != glm::ivec3(0)) { // images of one body may overlap: they close a face once
        const auto order = [](const Drawing::Face& face) {
            return std::tuple(face.cell.z, face.cell.y, face.cell.x, face.axis, -face.closed);
        };
        const auto same = [](const Drawing::Face& a, const Drawing::Face& b) { return a.cell == b.cell && a.axis == b.axis; };
        std::sort(drawn_faces_.begin(), drawn_faces_.end(), [&](const auto& a, const auto& b) { return order(a) < order(b); });
        drawn_faces_.erase(std::unique(drawn_faces_.begin(), drawn_faces_.end(), same), drawn_faces_.end());
    }
    drawing.faces.clear();
    drawing.inside.clear();
    drawing.sides.clear();
    drawing.near.clear();
    add_drawn(drawing);
}

// Draws what a kept drawing of an upright ground lacks: columns that came into reach, and those near tiles that came or went. So a box
// that moves draws a strip, and a tile that comes late no more than itself. False: all is to be drawn.
bool Solids::draw_rest(std::size_t number) {
    Drawing& drawing = drawings_[number];
    const PlacedObstacle& body = bodies_[number];
    const Reach needed = reach_of(body, needed_beyond());
    if (!TiledGround::is_upright_ground(body) || box_.boundaries.periodic(0) || box_.boundaries.periodic(1) ||
        box_.boundaries.periodic(2) || drawing.low.y > needed.low.y || drawing.high.y < needed.high.y ||
        is_tight(number, thickness_of_[number])) // a tile beside it changes all of it
        return false;
    const Reach most = reach_of(body, glm::ivec3(k_beyond));
    const Reach kept{glm::max(drawing.low, most.low), glm::min(drawing.high, most.high)};
    Reach whole{glm::min(kept.low, needed.low), glm::max(kept.high, needed.high)};
    whole.low.y = drawing.low.y;
    whole.high.y = drawing.high.y;
    if (kept.count() == 0)
        return false;

    const auto columns = [&](Reach reach, std::uint8_t lack) {
        reach = {glm::max(reach.low, kept.low), glm::min(reach.high, kept.high)};
        for (int k = reach.low.z; k < reach.high.z; ++k)
            for (int i = reach.low.x; i < reach.high.x; ++i)
                lacks_[whole.column({i, 0, k})] = lack;
    };
    const glm::ivec3 size = whole.high - whole.low;
    lacks_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.z), 1);
    columns(kept, 0);
    for (const PlacedObstacle& tile : changed_tiles_) {
        if (tile_of_[number] == k_none || !changed_near(body, tile, beside_margin()))
            continue;
        const Reach reach = reach_of(tile, glm::ivec3(k_beyond)); // a cell more than the tile
        const int margin = static_cast<int>(std::ceil(View::k_far * box_.coarsest() / box_.cell_size)) + 1;
        columns({reach.low - margin, reach.high + margin}, 1);
    }

    drawing.body.position.x = std::numeric_limits<float>::quiet_NaN(); // none until it is whole: memory may end
    keep_columns(drawing, whole);
    drawing.low = whole.low;
    drawing.high = whole.high;
    clear_drawn();
    for (int k = 0; k < size.z; ++k)
        for (int i = 0; i < size.x; ++i) {
            const auto lacks = [&](int x, int z) { return lacks_[static_cast<std::size_t>(z * size.x + x)] != 0; };
            if (!lacks(i, k))
                continue;
            int end = i, last = k;
            while (end < size.x && lacks(end, k))
                ++end;
            const auto row_lacks = [&](int z) {
                bool all = true;
                for (int x = i; x < end; ++x)
                    all = all && lacks(x, z);
                return all;
            };
            while (last < size.z && row_lacks(last))
                ++last;
            for (int z = k; z < last; ++z)
                std::fill_n(lacks_.begin() + z * size.x + i, end - i, std::uint8_t{0});
            draw_image(number, {whole.low + glm::ivec3(i, 0, k), {whole.low.x + end, whole.high.y, whole.low.z + last}},
                       glm::ivec3(0));
        }
    add_drawn(drawing);
    drawing.body = body;
    return true;
}

// Drops what is in columns that are to be drawn, or that are not in reach any more.
void Solids::keep_columns(Drawing& drawing, const Reach& whole) {
    const auto is_kept = [&](glm::ivec3 cell) { return whole.holds(cell) && lacks_[whole.column(cell)] == 0; };
    std::erase_if(drawing.faces, [&](const Drawing::Face& face) { return !is_kept(face.cell); });
    std::erase_if(drawing.near, [&](const Drawing::Near& near) { return !is_kept(near.cell); });
    std::size_t count = 0;
    std::uint32_t sides = 0;
    for (Drawing::Inside inside : drawing.inside) {
        if (!is_kept(inside.cell))
            continue;
        std::copy_n(drawing.sides.begin() + inside.first_side, inside.sides, drawing.sides.begin() + sides);
        inside.first_side = sides;
        sides += inside.sides;
        drawing.inside[count++] = inside;
    }
    drawing.inside.resize(count);
    drawing.sides.resize(sides);
}

void Solids::clear_drawn() {
    drawn_faces_.clear();
    drawn_inside_.clear();
    drawn_sides_.clear();
    drawn_near_.clear();
}

// Adds what was drawn. The cells beside a surface stay in order.
void Solids::add_drawn(Drawing& drawing) {
    const auto first_side = static_cast<std::uint32_t>(drawing.sides.size());
    for (Drawing::Inside& inside : drawn_inside_)
        inside.first_side += first_side;
    const auto append = [](auto& list, const auto& drawn) {
        detail::make_room(list, list.size() + drawn.size());
        list.insert(list.end(), drawn.begin(), drawn.end());
    };
    append(drawing.faces, drawn_faces_);
    append(drawing.inside, drawn_inside_);
    append(drawing.sides, drawn_sides_);
    const auto in_order = [](const Drawing::Near& a, const Drawing::Near& b) {
        return std::tuple(a.cell.z, a.cell.y, a.cell.x) < std::tuple(b.cell.z, b.cell.y, b.cell.x);
    };
    if (!std::is_sorted(drawn_near_.begin(), drawn_near_.end(), in_order))
        std::sort(drawn_near_.begin(), drawn_near_.end(), in_order);
    detail::make_room(drawn_near_, drawn_near_.size() + drawing.near.size());
    detail::make_room(drawing.near, drawn_near_.size() + drawing.near.size());
    const auto drawn = static_cast<std::ptrdiff_t>(drawn_near_.size());
    drawn_near_.insert(drawn_near_.end(), drawing.near.begin(), drawing.near.end());
    drawing.near.resize(drawn_near_.size());
    std::merge(drawn_near_.begin(), drawn_near_.begin() + drawn, drawn_near_.begin() + drawn, drawn_near_.end(),
               drawing.near.begin(), in_order);
}

float Solids::height_over(std::size_t number, glm::ivec3 cell) const {
    const glm::vec3 centre = glm::vec3(cell) + 0.5f;
    const glm::ivec3 images(box_.boundaries.periodic(0), box_.boundaries.periodic(1), box_.boundaries.periodic(2));
    float nearest = std::numeric_limits<float>::max();
    const auto visit = [&](const PlacedObstacle& body, bool only_within) {
        for (int z = -images.z; z <= images.z; ++z)
            for (int y = -images.y; y <= images.y; ++y)
                for (int x = -images.x; x <= images.x; ++x) {
                    const View view(body, glm::ivec3(x, y, z) * box_.cells, box_);
                    const glm::vec3 own = view.own_place(centre);
                    if (!only_within || detail::holds(std::get<Ground>(body.shape), {own.x, own.z}))
                        nearest = std::min(nearest, view.distance(centre));
                }
    };
    visit(bodies_[number], false);
    if (tile_of_[number] != k_none) { // of one surface
        const glm::vec3 place = centre * box_.cell_size;
        for (const std::uint32_t n : tiles_at_.at({place.x, place.z}))
            visit(*tile_places_[n].body, true);
    }
    return nearest;
}

void Solids::name_faces(std::vector<std::uint32_t>& names) const {
    detail::make_room(names, faces_.size());
    names.clear();
    for (const ClosedFace& face : faces().first(first_end_))
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
    for (std::size_t n = 0; n < first_end_; ++n) { // those behind have no slope
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
