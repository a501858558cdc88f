// Lists of the faces and cells at obstacles (solids.h), made from the drawings of the bodies.
// Based on: Guendelman, Selle, Losasso & Fedkiw 2005, ACM Transactions on Graphics 24 (which cells need one-sided reads).
#include "fluid/solids/body_view.h"
#include "fluid/solids/solids.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <tuple>
#include <utility>

namespace windrow {
namespace {

constexpr float k_open_at_most = 6e-3f; // open fractions of a shut cell, all faces together
constexpr int k_farthest_reach = 6;     // [cells] beyond it every cell counts as beside a sub-grid body

struct ByCell {
    bool operator()(const ClosedFace& face, std::uint32_t cell) const { return face.cell[0] < cell; }
    bool operator()(std::uint32_t cell, const ClosedFace& face) const { return cell < face.cell[0]; }
};

// Bodies that close parts of one face close their sum, at most the whole.
void add_part(ClosedFace& face, float closed, float wall) {
    const float sum = face.closed + closed, scale = sum > 1.0f ? 1.0f / sum : 1.0f;
    face.closed = scale * sum;
    face.wall = scale * (face.wall + wall);
}

} // namespace

template <class Visit>
void Solids::for_each_flagged(std::uint8_t flags, const Visit& visit) const {
    std::uint32_t n = 0;
    for (int k = 0; k < box_.cells.z; ++k)
        for (int j = 0; j < box_.cells.y; ++j) {
            const std::uint8_t* const row = &flags_[n];
            for (int i = 0; i < box_.cells.x;) {
                std::uint64_t eight = 1;
                if (i + 8 <= box_.cells.x)
                    std::memcpy(&eight, row + i, sizeof(eight));
                if (eight == 0) {
                    i += 8;
                    continue;
                }
                for (const int end = std::min(i + 8, box_.cells.x); i < end; ++i)
                    if ((row[i] & flags) != 0)
                        visit(n + static_cast<std::uint32_t>(i), glm::ivec3(i, j, k));
            }
            n += static_cast<std::uint32_t>(box_.cells.x);
        }
}

// --- Lists -------------------------------------------------------------------------------------------------------------------

// All drawings' faces and inside cells in the box.
void Solids::gather_faces() {
    unsorted_.clear();
    largest_parts_.clear();
    at_open_ends_.clear();
    ends_.clear();
    filling_ = 0;
    const auto in_box = [&](glm::ivec3 cell) {
        return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThan(cell, box_.cells));
    };
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
        const auto number = static_cast<std::uint16_t>(body);
        for (const Drawing::Face& drawn : drawings_[body].faces) {
            glm::ivec3 next;
            if (!in_box(drawn.cell) || !neighbour(drawn.cell, drawn.axis, 1, next)) {
                const int end = in_box(drawn.cell) ? 1 : 0;
                glm::ivec3 cell = drawn.cell;
                cell[drawn.axis] += 1 - end;
                if (in_box(cell) && cell[drawn.axis] == end * (box_.cells[drawn.axis] - 1) && is_open_end(drawn.axis, end))
                    ends_.push_back(end_face(cell, drawn, end, number));
                continue;
            }
            ClosedFace& face = gathered(drawn.cell, next, drawn.axis, number);
            add_part(face, drawn.closed, drawn.wall);
            const glm::vec2 part(drawn.closed, std::abs(drawn.wall));
            glm::vec2& largest = largest_parts_[static_cast<std::size_t>(&face - unsorted_.data())];
            if (part.x > largest.x + k_touch || (part.x > largest.x - k_touch && part.y < largest.y)) {
                largest = part;
                face.body = number;
            }
        }
        std::uint32_t drawn = 0;
        std::size_t in_body = 0;
        for (const Drawing::Inside& inside : drawings_[body].inside) {
            const std::uint32_t which = drawn++;
            if (!in_box(inside.cell))
                continue;
            ++in_body;
            const std::uint32_t n = index(inside.cell);
            // What a body that moves has in common with one at rest stays the latter's, as its faces do, whichever comes first.
            if ((flags_[n] & k_inside) == 0 || (bodies_[body_of_[n]].moves() && !bodies_[body].moves())) {
                body_of_[n] = number;
                drawn_of_[n] = which;
            }
            flags_[n] |= k_inside;
            if (at_open_end(inside.cell))
                at_open_ends_.push_back(inside.cell);
        }
        if (2 * in_body > box_.cell_count() && !std::holds_alternative<Ground>(bodies_[body].shape))
            ++filling_;
    }
    std::sort(ends_.begin(), ends_.end(), [](const ClosedFace& a, const ClosedFace& b) {
        return std::tuple(a.cell[0], a.axis, a.shut[1], -a.closed, std::abs(a.wall), a.body) <
               std::tuple(b.cell[0], b.axis, b.shut[1], -b.closed, std::abs(b.wall), b.body);
    });
    close_at_open_ends();
}

// The face of two cells in the list of those gathered, open where it was not there. It is of the body that closes most of it, else of
// the one that is slower across it: in a mirrored scene the bodies have another order.
ClosedFace& Solids::gathered(glm::ivec3 low, glm::ivec3 high, int axis, std::uint16_t body) {
    const std::uint32_t n = index(low);
    std::uint32_t& at = face_of_[3 * static_cast<std::size_t>(n) + static_cast<std::size_t>(axis)];
    if (at == k_none) {
        at = static_cast<std::uint32_t>(unsorted_.size());
        flags_[n] |= k_low;
        largest_parts_.emplace_back(0.0f);
        unsorted_.push_back(
            {.cell = {n, index(high)},
             .potential = {potential_of(low), potential_of(high)},
             .body = body,
             .place = {static_cast<std::uint16_t>(low.x), static_cast<std::uint16_t>(low.y), static_cast<std::uint16_t>(low.z)},
             .axis = static_cast<std::uint8_t>(axis)});
    }
    return unsorted_[at];
}

ClosedFace Solids::end_face(glm::ivec3 cell, const Drawing::Face& drawn, int end, std::uint16_t body) const {
    const std::uint32_t n = index(cell), potential = potential_of(cell);
    return {.cell = {n, n},
            .potential = {potential, potential},
            .closed = drawn.closed,
            .wall = drawn.wall,
            .body = body,
            .place = {static_cast<std::uint16_t>(cell.x), static_cast<std::uint16_t>(cell.y), static_cast<std::uint16_t>(cell.z)},
            .axis = static_cast<std::uint8_t>(drawn.axis),
            .shut = {end == 0, end == 1}};
}

// Cells inside whose face at an open boundary of the box is closed: the pressure would drive air through it. They close all their faces.
void Solids::close_at_open_ends() {
    const auto is_closed = [&](glm::ivec3 cell) {
        const auto [from, to] = std::equal_range(ends_.begin(), ends_.end(), index(cell), ByCell{});
        return std::any_of(from, to, [](const ClosedFace& face) { return face.closed >= k_tight; });
    };
    for (const glm::ivec3& cell : at_open_ends_) {
        if (!is_closed(cell))
            continue;
        const std::uint16_t number = body_of_[index(cell)];
        const PlacedObstacle& body = bodies_[number];
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                glm::ivec3 next;
                if (!neighbour(cell, axis, side, next))
                    continue;
                ClosedFace& face = side < 0 ? gathered(next, cell, axis, number) : gathered(cell, next, axis, number);
                glm::vec3 middle = glm::vec3(cell) + 0.5f;
                middle[axis] += 0.5f * static_cast<float>(side);
                face.wall = face.closed > 0.0f ? face.wall / face.closed
                            : body.moves()     ? body.velocity_at(box_.metres(middle))[axis]
                                               : 0.0f;
                face.closed = 1.0f;
            }
    }
}

void Solids::sort_faces() {
    inside_.clear();
    faces_.clear();
    for_each_flagged(k_inside | k_low, [&](std::uint32_t n, glm::ivec3 place) {
        if ((flags_[n] & k_inside) != 0)
            inside_.push_back({n, potential_of(place), place, body_of_[n], false, drawn_of_[n]});
        if ((flags_[n] & k_low) == 0)
            return;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (std::uint32_t& at = face_of_[3 * static_cast<std::size_t>(n) + axis]; at != k_none) {
                faces_.push_back(unsorted_[at]);
                at = static_cast<std::uint32_t>(faces_.size() - 1);
            }
    });
}

// An inside cell is shut where no face of it is open: each is closed, or leads to another cell inside. Cells that are open to each
// other alone, between a body and what it is pushed against, are shut too: no air could leave them.
void Solids::find_shut_cells() {
    unreached_.clear();
    for (std::uint32_t n = 0; n < inside_.size(); ++n) {
        InsideCell& cell = inside_[n];
        float open = 0.0f;
        bool reached = false;
        for_each_neighbour(cell, [&](std::uint32_t other, int axis, std::uint32_t low) {
            const ClosedFace* const between = face(low, axis);
            const float part = between != nullptr ? 1.0f - between->closed : inside(other) ? 0.0f : 1.0f;
            open += part;
            reached = reached || (part > 1.0f - k_tight && !inside(other));
        });
        const bool has_opening = open > k_open_at_most;
        cell.shut = !has_opening || !reached;
        if (cell.shut)
            flags_[cell.cell] |= k_shut;
        if (has_opening && !reached)
            unreached_.push_back(n);
    }
    open_reached_cells();
    const auto shut = [&](std::uint32_t cell) { return (flags_[cell] & k_shut) != 0; };
    std::size_t kept = 0;
    for (ClosedFace face : faces_) {
        face.shut[0] = shut(face.cell[0]);
        face.shut[1] = shut(face.cell[1]);
        const bool both = face.shut[0] && face.shut[1];
        face_of_[3 * static_cast<std::size_t>(face.cell[0]) + face.axis] = both ? k_none : static_cast<std::uint32_t>(kept);
        if (!both)
            faces_[kept++] = face;
    }
    faces_.resize(kept);
}

// Behind the other faces, what bodies close of the open boundaries of the box, where they go on into it. Without them a wind along a
// ground or a wall would come in through all of a cell that they cut and go on through a part.
void Solids::add_end_faces() {
    first_end_ = faces_.size();
    for (const ClosedFace& end : ends_) {
        const std::uint32_t n = end.cell[0];
        std::uint32_t low = n;
        const bool goes_on = inside(n) || ((end.shut[0] || low_neighbour(n, end.axis, low)) && face(low, end.axis) != nullptr);
        if ((flags_[n] & k_shut) != 0 || !goes_on)
            continue;
        if (faces_.size() > first_end_ && faces_.back().cell[0] == n && faces_.back().axis == end.axis &&
            faces_.back().shut[0] == end.shut[0]) { // of several bodies
            add_part(faces_.back(), end.closed, end.wall);
            continue;
        }
        faces_.push_back(end);
    }
}

// Of the face on the other side of the cell at an end of a face.
float Solids::closed_beyond(const ClosedFace& between, int end) const {
    const std::uint32_t cell = between.cell[end];
    std::uint32_t low = cell;
    if (end == 1 || low_neighbour(cell, between.axis, low))
        if (const ClosedFace* const other = face(low, between.axis))
            return other->closed;
    const auto [from, to] = std::equal_range(end_faces().begin(), end_faces().end(), cell, ByCell{});
    const auto at = std::find_if(from, to, [&](const ClosedFace& other) {
        return other.axis == between.axis && other.shut[end]; // beyond the same end
    });
    return at == to ? 0.0f : at->closed;
}

// A body that cuts two opposite faces of a cell passes along: its wall is across by what one has more than the other. Two that are
// closed whole are two walls.
void Solids::find_facing() {
    for (ClosedFace& between : faces_)
        for (int end = 0; end < 2 && !between.ends_box(); ++end) {
            const float beyond = closed_beyond(between, end);
            between.facing[end] =
                std::min(between.closed, beyond) >= k_tight ? between.closed : std::max(between.closed - beyond, 0.0f);
        }
}

// Those that others, which are not shut, reach.
void Solids::open_reached_cells() {
    for (bool found = true; found;) {
        found = false;
        for (const std::uint32_t n : unreached_) {
            InsideCell& cell = inside_[n];
            bool reached = false;
            for_each_neighbour(cell, [&](std::uint32_t other, int axis, std::uint32_t low) {
                const ClosedFace* const between = face(low, axis);
                reached = reached ||
                          (inside(other) && (flags_[other] & k_shut) == 0 && between != nullptr && between->closed < k_tight);
            });
            if (!cell.shut || !reached)
                continue;
            cell.shut = false;
            flags_[cell.cell] &= static_cast<std::uint8_t>(~k_shut);
            found = true;
        }
    }
}

void Solids::collect_open_sides() {
    open_sides_.clear();
    for (const InsideCell& cell : inside_) {
        if (cell.shut)
            continue;
        for_each_neighbour(cell, [&](std::uint32_t other, int axis, std::uint32_t low) {
            const ClosedFace* const between = face(low, axis);
            const float open = between != nullptr ? 1.0f - between->closed : 1.0f;
            if (!(open > 0.0f))
                return;
            const std::uint32_t potential = potential_of(place_of(other));
            OpenSide side{.cell = {cell.cell, other}, .potential = {cell.potential, potential}, .inside = cell.cell};
            if (low == other) {
                std::swap(side.cell[0], side.cell[1]);
                std::swap(side.potential[0], side.potential[1]);
            }
            side.weight = 0.5f * open * (axis == 1 ? 1.0f : box_.volume(cell.place.y));
            side.body = cell.body;
            side.axis = static_cast<std::uint8_t>(axis);
            open_sides_.push_back(side);
        });
    }
}

void Solids::collect_surface() {
    for (const ClosedFace& face : faces_)
        for (const std::uint32_t cell : face.cell)
            flags_[cell] |= k_surface;
    surface_.clear();
    for_each_flagged(k_surface, [&](std::uint32_t n, glm::ivec3 place) {
        const bool edge = glm::any(glm::equal(place, glm::ivec3(0))) || glm::any(glm::equal(place, box_.cells - 1));
        surface_of_[n] = static_cast<std::uint32_t>(surface_.size());
        surface_.push_back({n, potential_of(place), box_.volume(place.y), (flags_[n] & k_shut) != 0, edge});
    });
    for (ClosedFace& face : faces_)
        for (int end = 0; end < 2; ++end)
            face.surface[end] = surface_of_[face.cell[end]];
}

// Layers of cells inside bodies, counted from the air of closed rooms or from the other air: k_ghost_layers each.
void Solids::layer_inside(bool of_rooms) {
    const std::uint8_t base = of_rooms ? k_ghost_layers : 0;
    std::size_t begin = layered_.size();
    for (const InsideCell& cell : inside_) {
        bool beside = false;
        for_each_neighbour(cell, [&](std::uint32_t other, int, std::uint32_t) {
            beside = beside || (!inside(other) && in_room(other) == of_rooms);
        });
        if (beside && layers_[cell.cell] == 0)
            layered_.push_back(cell);
    }
    for (std::uint8_t layer = 1; layer <= k_ghost_layers; ++layer) {
        const std::size_t end = layered_.size();
        layer_ends_.push_back(static_cast<std::uint32_t>(end));
        for (std::size_t n = begin; n < end; ++n)
            layers_[layered_[n].cell] = static_cast<std::uint8_t>(base + layer);
        if (layer == k_ghost_layers)
            break;
        for (std::size_t n = begin; n < end; ++n) {
            const InsideCell cell = layered_[n];
            for_each_neighbour(cell, [&](std::uint32_t other, int, std::uint32_t) {
                if (!inside(other) || layers_[other] != 0)
                    return;
                layers_[other] = static_cast<std::uint8_t>(base + layer + 1);
                layered_.push_back({.cell = other, .place = place_of(other)});
            });
        }
        std::sort(layered_.begin() + static_cast<std::ptrdiff_t>(end), layered_.end(),
                  [](const InsideCell& a, const InsideCell& b) { return a.cell < b.cell; });
        begin = end;
    }
}

void Solids::collect_ghosts() {
    ghosts_.clear();
    ghost_sources_.clear();
    for (const InsideCell& cell : layered_) {
        const std::uint8_t layer = layers_[cell.cell];
        const bool of_rooms = layer > k_ghost_layers, first_layer = layer == 1 || layer == k_ghost_layers + 1;
        const auto first = static_cast<std::uint32_t>(ghost_sources_.size());
        for_each_neighbour(cell, [&](std::uint32_t other, int axis, std::uint32_t low) {
            const bool air = !inside(other);
            if (first_layer ? !air || in_room(other) != of_rooms : air || layers_[other] != layer - 1)
                return;
            GhostSource source{.cell = other};
            if (air) {
                const Drawing::Side* const side = side_of(cell, 2 * axis + (low == cell.cell ? 1 : 0));
                if (side != nullptr)
                    source.normal = side->normal, source.wall = side->wall;
            }
            ghost_sources_.push_back(source);
        });
        ghosts_.push_back({cell.cell, first, static_cast<std::uint32_t>(ghost_sources_.size()) - first});
    }
}

const Solids::Drawing::Side* Solids::side_of(const InsideCell& cell, int direction) const {
    const Drawing& drawing = drawings_[cell.body];
    const Drawing::Inside& inside = drawing.inside[cell.drawn];
    for (std::uint32_t n = inside.first_side; n < inside.first_side + inside.sides; ++n)
        if (static_cast<int>(drawing.sides[n].direction) == direction)
            return &drawing.sides[n];
    return nullptr;
}

// --- Sub-grid bodies ---------------------------------------------------------------------------------------------------------

void Solids::reach_past_thin(float cells) {
    constexpr int k_node = 2; // of a cubic read, beyond the point
    const int wanted = static_cast<int>(std::min(std::ceil(std::max(cells, 0.5f)), 1000.0f)) + k_node;
    if (wanted == reach_) // of this step alone, or what is read would depend on what came before
        return;
    reach_ = wanted;
    collect_thin();
}

void Solids::count_thicknesses() {
    thicknesses_.clear();
    thinnest_ = k_farthest_thin;
    for (std::size_t n = 0; n < bodies_.size(); ++n) {
        float coarsest = box_.cell_size;
        if (box_.rows) {
            const Reach reach = reach_of(bodies_[n], glm::ivec3(0));
            for (int face = reach.low.y; face <= reach.high.y; ++face)
                coarsest = std::max(coarsest, box_.cell_size / box_.rows->links()[static_cast<std::size_t>(face)]);
        }
        thicknesses_.push_back(thickness_of_[n] / coarsest);
        thinnest_ = std::min(thinnest_, thicknesses_.back());
    }
}

void Solids::collect_thin() {
    for (const std::uint32_t cell : thin_)
        flags_[cell] &= static_cast<std::uint8_t>(~k_thin);
    thin_.clear();
    if (thinnest_ >= static_cast<float>(reach_))
        return;
    thin_.reserve(flags_.size());
    if (reach_ > k_farthest_reach) {
        for (std::uint32_t n = 0; n < flags_.size(); ++n)
            if (!inside(n) && !in_room(n))
                thin_.push_back(n);
        return;
    }
    const auto mark_around = [&](glm::ivec3 place) {
        for (int z = -reach_; z <= reach_; ++z)
            for (int y = -reach_; y <= reach_; ++y)
                for (int x = -reach_; x <= reach_; ++x) {
                    glm::ivec3 at = place + glm::ivec3(x, y, z);
                    bool here = true;
                    for (int axis = 0; axis < 3; ++axis) {
                        if (box_.boundaries.periodic(axis))
                            at[axis] = (at[axis] % box_.cells[axis] + box_.cells[axis]) % box_.cells[axis];
                        here = here && at[axis] >= 0 && at[axis] < box_.cells[axis];
                    }
                    if (!here || (flags_[index(at)] & (k_thin | k_inside)) != 0 || in_room(index(at)))
                        continue;
                    flags_[index(at)] |= k_thin;
                    thin_.push_back(index(at));
                }
    };
    for (const ClosedFace& face : faces_)
        if (thicknesses_[face.body] < static_cast<float>(reach_))
            for (int end = 0; end < 2; ++end)
                if (!inside(face.cell[end]))
                    mark_around(place_of(face.cell[end]));
    std::sort(thin_.begin(), thin_.end());
}

// The lists that push_back grows have none to spare where they have just grown.
void Solids::make_room_for_motion() {
    const auto spare = [](auto&... lists) {
        (detail::make_room(lists, std::max(lists.size() + lists.size() / 4, std::size_t{32})), ...);
    };
    detail::make_room(ends_, faces_.size() / 3); // of a body that comes to the boundary
    detail::make_room(at_open_ends_, faces_.size() / 3);
    spare(faces_, unsorted_, largest_parts_, ends_, at_open_ends_, surface_, inside_, ghosts_, ghost_sources_, layered_, runs_,
          part_sizes_, rooms_, room_ends_, sheltered_, sealed_, sealed_cells_, sealed_surface_, unreached_, nodes_, node_parts_,
          changes_, thicknesses_, drawn_faces_, drawn_inside_, drawn_sides_, drawn_near_, distances_, depths_);
}

std::size_t Solids::memory_bytes() const {
    const auto bytes = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    std::size_t sum = bytes(bodies_) + bytes(faces_) + bytes(surface_) + bytes(inside_) + bytes(ghosts_) + bytes(ghost_sources_) +
                      bytes(layer_ends_) + bytes(thin_) + bytes(flags_) + bytes(body_of_) + bytes(surface_of_) +
                      bytes(unsorted_) + bytes(largest_parts_) + bytes(ends_) + bytes(at_open_ends_) + bytes(rooms_) +
                      bytes(room_ends_) + bytes(sheltered_) + bytes(sealed_) + bytes(sealed_cells_) + bytes(sealed_surface_) +
                      bytes(unreached_) + bytes(part_of_) + bytes(nodes_) + bytes(node_parts_) + bytes(changes_) + bytes(runs_) +
                      bytes(row_runs_) + bytes(part_sizes_) + bytes(layered_) + bytes(layers_) + bytes(face_of_) +
                      bytes(distances_) + bytes(depths_) + bytes(drawn_of_) + bytes(drawn_faces_) + bytes(drawn_inside_) +
                      bytes(drawn_sides_) + bytes(drawn_near_) + bytes(thicknesses_) + bytes(columns_) + bytes(levels_) +
                      bytes(corner_levels_) + bytes(owners_);
    for (const auto* drawings : {&drawings_, &drawings_before_})
        for (const Drawing& drawing : *drawings)
            sum += sizeof(Drawing) + bytes(drawing.faces) + bytes(drawing.inside) + bytes(drawing.sides) + bytes(drawing.near) +
                   bytes(drawing.beside);
    return sum;
}

} // namespace windrow
