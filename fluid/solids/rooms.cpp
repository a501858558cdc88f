// Closed rooms: air that no open face joins to the air at an open boundary of the box; in a box without one, to the largest part
// of the air.
//
// Rows of x are cut into runs of air, and runs that share an open face are joined (union-find). A row without a body is one run,
// so the search costs little beside the bodies themselves.
// Based on: Tarjan & van Leeuwen 1984, Journal of the ACM 31 (union-find with path halving).
#include "fluid/solids/solids.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <numeric>

namespace windrow {
namespace {

constexpr float k_tight = 0.999f; // closed fraction of a face that joins nothing

} // namespace

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

} // namespace windrow
