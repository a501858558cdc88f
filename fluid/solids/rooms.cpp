// Closed rooms: air that no open face joins to the air at an open boundary of the box; in a box without one, to the largest part
// of the air.
//
// Rows of x are cut into runs of air, and runs that share an open face are joined (union-find). A row without a body is one run,
// so the search costs little beside the bodies themselves.
// Based on: Tarjan & van Leeuwen 1984, Journal of the ACM 31 (union-find with path halving).
#include "fluid/solids/body_view.h"
#include "fluid/solids/solids.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

namespace windrow {

void Solids::find_rooms() {
    rooms_.clear();
    room_ends_.clear();
    constexpr std::size_t k_fewest = 6; // faces around one cell; a floor may be one of them
    if (faces_.size() < k_fewest - 1)
        return;
    const glm::ivec3 cells = box_.cells;
    const auto open = [&](std::uint32_t low, int axis) {
        const ClosedFace* const between = face(low, axis);
        return between == nullptr || between->closed < k_tight;
    };
    const auto root_of = [&](std::uint32_t run) {
        while (runs_[run].root != run)
            run = runs_[run].root = runs_[runs_[run].root].root;
        return run;
    };
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        a = root_of(a), b = root_of(b);
        runs_[std::max(a, b)].root = std::min(a, b);
    };

    runs_.clear();
    row_runs_.clear();
    const auto add_run = [&](int first, int end) {
        runs_.push_back(
            {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end), static_cast<std::uint32_t>(runs_.size())});
    };
    const auto row_of = [&](int j, int k) { return static_cast<std::size_t>(k) * static_cast<std::size_t>(cells.y) + j; };
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j) {
            row_runs_.push_back(static_cast<std::uint32_t>(runs_.size()));
            const std::uint32_t row = index({0, j, k});
            const std::uint8_t* const flags = &flags_[row];
            if (std::all_of(flags, flags + cells.x, [](std::uint8_t cell) { return cell == 0; })) {
                add_run(0, cells.x);
                continue;
            }
            for (int i = 0; i < cells.x;) {
                if (inside(row + static_cast<std::uint32_t>(i))) {
                    ++i;
                    continue;
                }
                const int first = i++;
                while (i < cells.x && !inside(row + static_cast<std::uint32_t>(i)) &&
                       open(row + static_cast<std::uint32_t>(i - 1), 0))
                    ++i;
                add_run(first, i);
            }
            const std::uint32_t begin = row_runs_.back(), last = static_cast<std::uint32_t>(runs_.size());
            const auto end = static_cast<std::uint32_t>(cells.x);
            if (box_.boundaries.periodic(0) && last > begin + 1 && runs_[begin].first == 0 && runs_[last - 1].end == end &&
                open(row + end - 1, 0))
                join(begin, last - 1);
        }
    row_runs_.push_back(static_cast<std::uint32_t>(runs_.size()));

    const auto join_rows = [&](glm::ivec3 low_row, glm::ivec3 high_row, int axis) {
        const std::size_t low = row_of(low_row.y, low_row.z), high = row_of(high_row.y, high_row.z);
        const std::uint32_t row = index(low_row);
        std::uint32_t a = row_runs_[low], b = row_runs_[high];
        while (a < row_runs_[low + 1] && b < row_runs_[high + 1]) {
            const std::uint32_t end = std::min(runs_[a].end, runs_[b].end);
            std::uint32_t i = std::max(runs_[a].first, runs_[b].first);
            while (i < end && !open(row + i, axis))
                ++i;
            if (i < end)
                join(a, b);
            (runs_[a].end < runs_[b].end ? a : b) += 1;
        }
    };
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int axis = 1; axis < 3; ++axis)
                if (glm::ivec3 next; neighbour({0, j, k}, axis, 1, next))
                    join_rows({0, j, k}, next, axis);

    // The size of each part of the air, 0 where it is not a closed room.
    auto& sizes = part_sizes_;
    sizes.assign(runs_.size(), 0);
    std::size_t row = 0;
    bool any_open = false;
    const auto for_each_run = [&](const auto& visit) {
        row = 0;
        for (std::uint32_t n = 0; n < runs_.size(); ++n) {
            while (row_runs_[row + 1] <= n)
                ++row;
            visit(n, glm::ivec3(0, static_cast<int>(row) % cells.y, static_cast<int>(row) / cells.y));
        }
    };
    for_each_run([&](std::uint32_t n, glm::ivec3) { sizes[root_of(n)] += runs_[n].end - runs_[n].first; });
    const auto is_open = [&](int axis, int end) { return box_.boundaries.at(axis, end).kind == BoundaryKind::open; };
    for_each_run([&](std::uint32_t n, glm::ivec3 place) {
        bool outside =
            (runs_[n].first == 0 && is_open(0, 0)) || (runs_[n].end == static_cast<std::uint32_t>(cells.x) && is_open(0, 1));
        for (int axis = 1; axis < 3; ++axis)
            outside = outside || (place[axis] == 0 && is_open(axis, 0)) || (place[axis] == cells[axis] - 1 && is_open(axis, 1));
        if (outside)
            sizes[root_of(n)] = 0;
        any_open = any_open || outside;
    });
    if (!any_open && !sizes.empty()) // no air at all where a body fills the box
        *std::max_element(sizes.begin(), sizes.end()) = 0;
    std::uint32_t total = 0;
    for (std::uint32_t n = 0; n < runs_.size(); ++n)
        if (const std::uint32_t size = sizes[n]; size > 0) {
            sizes[n] = total + 1; // one more than where its next cell is written
            total += size;
            room_ends_.push_back(total);
        }
    rooms_.resize(total);
    if (total == 0)
        return;
    for_each_run([&](std::uint32_t n, glm::ivec3 place) {
        std::uint32_t& next = sizes[root_of(n)];
        if (next == 0)
            return;
        const std::uint32_t first = index(place);
        for (std::uint32_t cell = first + runs_[n].first; cell < first + runs_[n].end; ++cell) {
            rooms_[next++ - 1] = cell;
            layers_[cell] = k_room;
        }
    });
}

// Closes faces between sheltered cells and the cells of bodies that the other air reaches, whole.
void Solids::close_rooms() {
    sheltered_.assign(rooms_.begin(), rooms_.end());
    for (const InsideCell& cell : layered_)
        if (is_sheltered(cell.cell))
            sheltered_.push_back(cell.cell);
    bool added = false;
    for (const std::uint32_t cell : sheltered_) {
        const InsideCell here{.cell = cell, .place = place_of(cell)};
        for_each_neighbour(here, [&](std::uint32_t other, int axis, std::uint32_t low) {
            if (!inside(other) || layers_[other] == 0 || is_sheltered(other))
                return;
            std::uint32_t& at = face_of_[3 * static_cast<std::size_t>(low) + static_cast<std::size_t>(axis)];
            if (at != k_none) {
                ClosedFace& between = faces_[at];
                between.wall /= between.closed;
                between.closed = 1.0f;
                return;
            }
            const std::uint32_t high = low == cell ? other : cell;
            const PlacedObstacle& body = bodies_[body_of_[other]];
            const glm::ivec3 low_place = place_of(low);
            glm::vec3 place = glm::vec3(low_place) + 0.5f;
            place[axis] += 0.5f;
            at = static_cast<std::uint32_t>(faces_.size());
            faces_.push_back({.cell = {low, high},
                              .potential = {potential_of(low_place), potential_of(place_of(high))},
                              .closed = 1.0f,
                              .wall = body.moves() ? body.velocity_at(box_.metres(place))[axis] : 0.0f,
                              .body = body_of_[other],
                              .place = {static_cast<std::uint16_t>(low_place.x), static_cast<std::uint16_t>(low_place.y),
                                        static_cast<std::uint16_t>(low_place.z)},
                              .axis = static_cast<std::uint8_t>(axis)});
            added = true;
        });
    }
    if (!added)
        return;
    std::sort(faces_.begin(), faces_.end(), [](const ClosedFace& a, const ClosedFace& b) {
        return a.cell[0] != b.cell[0] ? a.cell[0] < b.cell[0] : a.axis < b.axis;
    });
    for (std::size_t n = 0; n < faces_.size(); ++n)
        face_of_[3 * static_cast<std::size_t>(faces_[n].cell[0]) + faces_[n].axis] = static_cast<std::uint32_t>(n);
}

// --- Sealed air --------------------------------------------------------------------------------------------------------------

void Solids::find_sealed() {
    for (const std::uint32_t cell : sealed_cells_)
        part_of_[cell] = 0;
    sealed_.clear();
    sealed_cells_.clear();
    sealed_surface_.clear();
    other_change_ = 0.0f;
    squeezed_ = 0;
    if (!rooms_.empty())
        join_rooms();
    const Boundaries& boundaries = box_.boundaries;
    const bool closed = !boundaries.has_open(0) && !boundaries.has_open(1) && !boundaries.has_open(2);
    if ((closed || !sealed_.empty()) &&
        std::any_of(bodies_.begin(), bodies_.end(), [](const auto& body) { return body.moves(); }))
        find_changes(closed);
}

// Rooms and the cells inside bodies that are open to them, as the pressure's operator joins them: a wall may be open in part to two.
void Solids::join_rooms() {
    if (part_of_.empty())
        part_of_.resize(box_.cell_count(), 0);
    const auto root_of = [&](std::uint32_t node) {
        while (nodes_[node] != node)
            node = nodes_[node] = nodes_[nodes_[node]];
        return node;
    };
    const auto for_each_open_inside = [&](const auto& visit) {
        for (const InsideCell& cell : inside_)
            if (!cell.shut)
                visit(cell);
    };
    // Nodes: the other air, the rooms, the cells.
    nodes_.assign(1, 0);
    const auto add_node = [&] {
        nodes_.push_back(static_cast<std::uint32_t>(nodes_.size()));
        return nodes_.back();
    };
    std::size_t first = 0;
    for (const std::uint32_t end : room_ends_) {
        const std::uint32_t node = add_node();
        for (; first < end; ++first)
            part_of_[rooms_[first]] = node;
    }
    for_each_open_inside([&](const InsideCell& cell) { part_of_[cell.cell] = add_node(); });
    for_each_open_inside([&](const InsideCell& cell) {
        for_each_neighbour(cell, [&](std::uint32_t other, int axis, std::uint32_t low) {
            const ClosedFace* const between = face(low, axis);
            if ((between != nullptr && between->closed >= k_tight) || (flags_[other] & k_shut) != 0)
                return;
            const std::uint32_t a = root_of(part_of_[cell.cell]), b = root_of(part_of_[other]);
            nodes_[std::max(a, b)] = std::min(a, b);
        });
    });

    node_parts_.assign(nodes_.size(), 0);
    for (std::uint32_t node = 1; node <= room_ends_.size(); ++node)
        if (const std::uint32_t root = root_of(node); root != 0 && node_parts_[root] == 0) {
            sealed_.push_back({});
            node_parts_[root] = static_cast<std::uint32_t>(sealed_.size());
        }
    const auto for_each_cell = [&](const auto& visit) {
        for (const std::uint32_t cell : rooms_)
            visit(cell);
        for_each_open_inside([&](const InsideCell& cell) { visit(cell.cell); });
    };
    for_each_cell([&](std::uint32_t cell) {
        std::uint32_t& part = part_of_[cell];
        part = node_parts_[root_of(part)];
        if (part > 0)
            ++sealed_[part - 1].end;
    });
    for (const SurfaceCell& cell : surface_)
        if (const std::uint32_t part = part_of_[cell.cell]; part > 0)
            ++sealed_[part - 1].surface_end;
    std::uint32_t total = 0, total_surface = 0;
    for (SealedPart& part : sealed_) { // where its next cell is written, and after the last that of its end
        total += std::exchange(part.end, total);
        total_surface += std::exchange(part.surface_end, total_surface);
    }
    sealed_cells_.resize(total);
    for_each_cell([&](std::uint32_t cell) {
        if (const std::uint32_t part = part_of_[cell]; part > 0)
            sealed_cells_[sealed_[part - 1].end++] = cell;
    });
    sealed_surface_.resize(total_surface);
    for (std::uint32_t n = 0; n < surface_.size(); ++n)
        if (const std::uint32_t part = part_of_[surface_[n].cell]; part > 0)
            sealed_surface_[sealed_[part - 1].surface_end++] = n;
}

// The sum of the divergence over a part is what its walls push in: all other faces pass what they take. Walls of a body that close
// both ends of a line of cells cancel, so that a body within a part changes nothing.
void Solids::find_changes(bool closed) {
    constexpr double k_rounding = 1e-5, k_reported = 1e-2; // of the sum without signs; a shut cell may be open by half of that
    const auto volume_of = [&](std::uint32_t cell) { return static_cast<double>(box_.volume(place_of(cell).y)); };
    changes_.assign(sealed_.size() + 1, {});
    std::uint32_t first = 0;
    double inside_parts = 0.0;
    for (std::size_t part = 0; part < sealed_.size(); ++part) {
        for (; first < sealed_[part].end; ++first)
            changes_[part + 1].volume += volume_of(sealed_cells_[first]);
        inside_parts += changes_[part + 1].volume;
    }
    double shut = 0.0, whole = 0.0;
    for (const InsideCell& cell : inside_)
        shut += cell.shut ? static_cast<double>(box_.volume(cell.place.y)) : 0.0;
    for (int j = 0; j < box_.cells.y; ++j)
        whole += static_cast<double>(box_.volume(j)) * box_.cells.x * box_.cells.z;
    changes_[0].volume = closed ? whole - shut - inside_parts : 0.0;
    for (const ClosedFace& face : faces_) {
        if (face.wall == 0.0f)
            continue;
        const double area = face.axis == 1 ? 1.0 : static_cast<double>(box_.volume(face.place[1]));
        for (int end = 0; end < 2; ++end) {
            if (face.shut[end])
                continue;
            Change& change = changes_[part_of_.empty() ? 0 : part_of_[face.cell[end]]];
            const double pushed = (end == 0 ? area : -area) * static_cast<double>(face.wall);
            change.through += pushed;
            change.gross += std::abs(pushed);
        }
    }
    for (std::size_t part = 0; part <= sealed_.size(); ++part) {
        const auto [volume, through, gross] = changes_[part];
        if (!(std::abs(through) > k_rounding * gross) || !(volume > 0.0))
            continue;
        (part == 0 ? other_change_ : sealed_[part - 1].change) = static_cast<float>(through / volume);
        squeezed_ += std::abs(through) > k_reported * gross ? 1 : 0;
    }
}

bool Solids::low_neighbour(std::uint32_t cell, int axis, std::uint32_t& low) const {
    glm::ivec3 next;
    if (!neighbour(place_of(cell), axis, -1, next))
        return false;
    low = index(next);
    return true;
}

bool Solids::came_in(std::uint32_t cell, glm::ivec3 shift) const {
    const glm::ivec3 then = place_of(cell) + shift;
    return glm::any(glm::lessThanEqual(then, glm::ivec3(0)) && glm::lessThan(shift, glm::ivec3(0))) ||
           glm::any(glm::greaterThanEqual(then, box_.cells - 1) && glm::greaterThan(shift, glm::ivec3(0)));
}

bool Solids::beside_moving(std::uint32_t cell) const {
    bool moving = false;
    for_each_neighbour({.cell = cell, .place = place_of(cell)}, [&](std::uint32_t, int axis, std::uint32_t low) {
        const ClosedFace* const between = face(low, axis);
        moving = moving || (between != nullptr && between->wall != 0.0f);
    });
    return moving;
}

bool Solids::walls_move(std::span<const std::uint32_t> room) const {
    const std::uint32_t part = part_of_[room.front()];
    if (part == 0)
        return std::any_of(room.begin(), room.end(), [&](std::uint32_t cell) { return beside_moving(cell); });
    const auto first = sealed_surface_.begin() + (part > 1 ? sealed_[part - 2].surface_end : 0);
    return std::any_of(first, sealed_surface_.begin() + sealed_[part - 1].surface_end,
                       [&](std::uint32_t n) { return beside_moving(surface_[n].cell); });
}

} // namespace windrow
