#include "fluid/cpu/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace windrow::cpu {
namespace {

// Distances below this fraction of a cell count as 0: a body along the cells' faces has these faces closed, whatever rounding does.
constexpr float k_touch = 1e-4f;
constexpr float k_closed = 1.0f - 1e-3f; // fraction from which a face counts as closed
constexpr int k_farthest_reach = 6;      // [cells] beyond it every cell counts as beside a thin body

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
    const float middle = 0.25f * (a + b + c + d);
    return 0.25f * (negative_fraction(a, b, middle) + negative_fraction(b, c, middle) + negative_fraction(c, d, middle) +
                    negative_fraction(d, a, middle));
}

} // namespace

Solids::Solids(const Box& box, int pitch) : box_(box), pitch_(pitch), flags_(box.cell_count()) {}

glm::ivec3 Solids::place_of(std::uint32_t cell) const {
    const auto x = static_cast<std::uint32_t>(box_.cells.x), y = static_cast<std::uint32_t>(box_.cells.y);
    return {static_cast<int>(cell % x), static_cast<int>(cell / x % y), static_cast<int>(cell / x / y)};
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

std::ptrdiff_t Solids::to_neighbour(const SurfaceCell& cell, int slot, const Strides& strides) const {
    const int axis = slot / 2, side = slot % 2 == 0 ? -1 : 1;
    const std::ptrdiff_t stride = axis == 0 ? 1 : axis == 1 ? strides.row : strides.plane;
    if (cell.at_edge) {
        const int at = place_of(cell.cell)[axis], last = box_.cells[axis] - 1;
        if (at == (side < 0 ? 0 : last))
            return -side * last * stride;
    }
    return side * stride;
}

void Solids::rasterise(std::span<const PlacedObstacle> obstacles) {
    std::fill(flags_.begin(), flags_.end(), std::uint8_t{0});
    bodies_.assign(obstacles.begin(), obstacles.end());
    find_thin_bodies();
    faces_.clear();
    inside_.clear();
    const glm::vec3 size = glm::vec3(box_.cells) * box_.cell_size;
    const glm::ivec3 images(box_.boundaries.periodic(0), box_.boundaries.periodic(1), box_.boundaries.periodic(2));
    for (std::size_t body = 0; body < bodies_.size(); ++body)
        for (int z = -images.z; z <= images.z; ++z)
            for (int y = -images.y; y <= images.y; ++y)
                for (int x = -images.x; x <= images.x; ++x)
                    draw(bodies_[body], static_cast<std::uint16_t>(body), glm::vec3(x, y, z) * size);
    merge_faces();
    find_shut_cells();
    collect_surface();
    collect_ghosts();
    collect_thin();
}

// Adds the closed faces and the inside cells of one obstacle.
void Solids::draw(const PlacedObstacle& obstacle, std::uint16_t body, glm::vec3 offset) {
    const float h = box_.cell_size;
    const glm::vec3 position = obstacle.position + offset, own = detail::half_extent(obstacle.shape);
    glm::vec3 reach(0.0f);
    for (int axis = 0; axis < 3; ++axis)
        reach += glm::abs(obstacle.axes[axis]) * own[axis];
    // Cells whose centre, corner or line to a neighbour it may touch.
    const glm::vec3 cells(box_.cells);
    const glm::ivec3 low(glm::clamp(glm::floor((position - reach) / h) - 1.0f, glm::vec3(0.0f), cells));
    const glm::ivec3 high(glm::clamp(glm::ceil((position + reach) / h) + 1.0f, glm::vec3(0.0f), cells));
    const glm::ivec3 count = high - low;
    if (count.x <= 0 || count.y <= 0 || count.z <= 0)
        return;
    const glm::mat3 to_own = glm::transpose(obstacle.axes);
    const auto own_place = [&](glm::vec3 cell) { return to_own * (cell * h - position); };
    const glm::ivec3 corners = count + 1;
    distances_.resize(static_cast<std::size_t>(corners.x) * corners.y * corners.z);
    const auto corner = [&](int i, int j, int k) {
        return (static_cast<std::size_t>(k - low.z) * corners.y + (j - low.y)) * corners.x + (i - low.x);
    };
    const bool flat = std::holds_alternative<Plate>(obstacle.shape);
    if (!flat)
        for (int k = low.z; k <= high.z; ++k)
            for (int j = low.y; j <= high.y; ++j)
                for (int i = low.x; i <= high.x; ++i)
                    distances_[corner(i, j, k)] = detail::distance_to(obstacle.shape, own_place({i, j, k})) / h - k_touch;
    for (int k = low.z; k < high.z; ++k)
        for (int j = low.y; j < high.y; ++j)
            for (int i = low.x; i < high.x; ++i) {
                const glm::ivec3 cell(i, j, k);
                const glm::vec3 centre = glm::vec3(cell) + 0.5f, here = own_place(centre);
                const float away = detail::distance_to(obstacle.shape, here) / h;
                const bool in = !flat && away <= 0.0f;
                const auto n = static_cast<std::uint32_t>(box_.index(i, j, k));
                if (in)
                    inside_.push_back({n, potential_of(cell), body, false});
                if (away > 2.0f || away < -2.0f)
                    continue;
                for (int axis = 0; axis < 3; ++axis) {
                    glm::ivec3 next;
                    if (!neighbour(cell, axis, 1, next))
                        continue;
                    glm::vec3 step(0.0f);
                    step[axis] = 1.0f;
                    float closed = 0.0f;
                    if (!flat) {
                        const int a = (axis + 1) % 3, b = (axis + 2) % 3;
                        glm::ivec3 base = cell, one(0), other(0);
                        ++base[axis];
                        one[a] = other[b] = 1;
                        const auto at = [&](glm::ivec3 place) { return distances_[corner(place.x, place.y, place.z)]; };
                        closed = negative_fraction(at(base), at(base + one), at(base + one + other), at(base + other));
                    }
                    const glm::vec3 beyond = own_place(centre + step);
                    const bool both_outside = !in && (flat || detail::distance_to(obstacle.shape, beyond) > 0.0f);
                    if (closed < 1.0f && both_outside && away < 1.0f && detail::blocks(obstacle.shape, here, beyond))
                        closed = 1.0f;
                    if (closed <= 0.0f)
                        continue;
                    const glm::vec3 face = (centre + 0.5f * step) * h - offset;
                    faces_.push_back(
                        {4 * n + static_cast<std::uint32_t>(axis), closed, closed * obstacle.velocity_at(face)[axis], body});
                }
            }
}

// Bodies that close parts of one face close their sum.
void Solids::merge_faces() {
    std::stable_sort(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) { return a.key < b.key; });
    std::size_t kept = 0;
    for (std::size_t n = 0; n < faces_.size(); ++n) {
        if (kept == 0 || faces_[kept - 1].key != faces_[n].key) {
            faces_[kept++] = faces_[n];
            continue;
        }
        Face& whole = faces_[kept - 1];
        const float sum = whole.closed + faces_[n].closed, scale = sum > 1.0f ? 1.0f / sum : 1.0f;
        whole = {whole.key, scale * sum, scale * (whole.wall + faces_[n].wall), whole.body};
    }
    faces_.resize(kept);
    std::stable_sort(inside_.begin(), inside_.end(), [](const InsideCell& a, const InsideCell& b) { return a.cell < b.cell; });
    inside_.erase(std::unique(inside_.begin(), inside_.end(), [](const auto& a, const auto& b) { return a.cell == b.cell; }),
                  inside_.end());
    for (const InsideCell& cell : inside_)
        flags_[cell.cell] |= k_inside;
    for (const Face& face : faces_)
        if (face.closed >= 0.5f)
            flags_[face.key / 4] |= static_cast<std::uint8_t>(1u << (face.key % 4));
}

float Solids::wall_speed(std::uint32_t low_cell, int axis) const {
    const Face* const face = face_between(low_cell, 0, 2 * axis + 1);
    return face != nullptr && face->closed > 0.0f ? face->wall / face->closed : 0.0f;
}

// The face of a cell in a slot, to its neighbour there; null: open.
const Solids::Face* Solids::face_between(std::uint32_t cell, std::uint32_t next, int slot) const {
    const std::uint32_t key = 4 * (slot % 2 == 0 ? next : cell) + static_cast<std::uint32_t>(slot / 2);
    const auto found = std::lower_bound(faces_.begin(), faces_.end(), key,
                                        [](const Face& face, std::uint32_t wanted) { return face.key < wanted; });
    return found != faces_.end() && found->key == key ? &*found : nullptr;
}

// An inside cell is shut where each of its faces is closed, or leads to another cell inside and has no entry (deep in a body).
void Solids::find_shut_cells() {
    const auto open_fraction = [&](glm::ivec3 cell, std::uint32_t n) {
        float open = 0.0f;
        for (int slot = 0; slot < 6; ++slot) {
            glm::ivec3 next;
            const int axis = slot / 2;
            if (!neighbour(cell, axis, slot % 2 == 0 ? -1 : 1, next))
                continue;
            const auto other = static_cast<std::uint32_t>(box_.index(next.x, next.y, next.z));
            if (const Face* const face = face_between(n, other, slot))
                open += 1.0f - face->closed;
            else if (!inside(other))
                open += 1.0f;
        }
        return open;
    };
    for (InsideCell& cell : inside_)
        if (open_fraction(place_of(cell.cell), cell.cell) <= 6.0f * (1.0f - k_closed))
            flags_[cell.cell] |= k_shut;
    std::erase_if(faces_, [&](const Face& face) {
        const glm::ivec3 cell = place_of(face.key / 4);
        glm::ivec3 next;
        (void)neighbour(cell, static_cast<int>(face.key % 4), 1, next);
        const bool both = (flags_[face.key / 4] & k_shut) != 0 && (flags_[box_.index(next.x, next.y, next.z)] & k_shut) != 0;
        return both;
    });
}

void Solids::collect_surface() {
    struct Side {
        std::uint32_t cell, face;
        int slot;
    };
    std::vector<Side> sides;
    sides.reserve(2 * faces_.size());
    for (std::size_t n = 0; n < faces_.size(); ++n) {
        const std::uint32_t cell = faces_[n].key / 4;
        const int axis = static_cast<int>(faces_[n].key % 4);
        glm::ivec3 next;
        (void)neighbour(place_of(cell), axis, 1, next);
        sides.push_back({cell, static_cast<std::uint32_t>(n), 2 * axis + 1});
        sides.push_back(
            {static_cast<std::uint32_t>(box_.index(next.x, next.y, next.z)), static_cast<std::uint32_t>(n), 2 * axis});
    }
    std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.cell < b.cell; });
    surface_.clear();
    for (const Side& side : sides) {
        if (surface_.empty() || surface_.back().cell != side.cell) {
            const glm::ivec3 place = place_of(side.cell);
            SurfaceCell cell{.cell = side.cell, .potential = potential_of(place), .shut = (flags_[side.cell] & k_shut) != 0};
            for (int axis = 0; axis < 3; ++axis)
                cell.at_edge = cell.at_edge || place[axis] == 0 || place[axis] == box_.cells[axis] - 1;
            surface_.push_back(cell);
        }
        SurfaceCell& cell = surface_.back();
        const Face& face = faces_[side.face];
        cell.closed[side.slot] = face.closed;
        cell.body[side.slot] = face.body;
        cell.wall += side.slot % 2 == 0 ? -face.wall : face.wall;
    }
    std::size_t next = 0;
    for (InsideCell& cell : inside_) {
        while (next < surface_.size() && surface_[next].cell < cell.cell)
            ++next;
        cell.deep = next == surface_.size() || surface_[next].cell != cell.cell;
    }
}

void Solids::collect_ghosts() {
    ghosts_.clear();
    ghost_sources_.clear();
    layer_ends_.clear();
    std::vector<std::uint8_t> layer_of(inside_.size(), 0);
    const auto index_of = [&](std::uint32_t cell) {
        const auto found = std::lower_bound(inside_.begin(), inside_.end(), cell,
                                            [](const InsideCell& a, std::uint32_t wanted) { return a.cell < wanted; });
        return static_cast<std::size_t>(found - inside_.begin());
    };
    for (int layer = 1; layer <= k_ghost_layers; ++layer) {
        for (std::size_t n = 0; n < inside_.size(); ++n) {
            if (layer_of[n] != 0)
                continue;
            const glm::ivec3 place = place_of(inside_[n].cell);
            const auto first = static_cast<std::uint32_t>(ghost_sources_.size());
            for (int slot = 0; slot < 6; ++slot) {
                glm::ivec3 next;
                if (!neighbour(place, slot / 2, slot % 2 == 0 ? -1 : 1, next))
                    continue;
                const auto other = static_cast<std::uint32_t>(box_.index(next.x, next.y, next.z));
                const bool air = !inside(other);
                if (layer == 1 ? !air : air || layer_of[index_of(other)] != layer - 1)
                    continue;
                GhostSource source{.cell = other, .axis = static_cast<std::uint8_t>(slot / 2), .high = slot % 2 != 0};
                if (const Face* const face = air ? face_between(inside_[n].cell, other, slot) : nullptr)
                    source.closed = face->closed, source.body = face->body;
                ghost_sources_.push_back(source);
            }
            const auto count = static_cast<std::uint32_t>(ghost_sources_.size()) - first;
            if (count > 0)
                ghosts_.push_back({inside_[n].cell, first, count});
        }
        for (std::size_t n = layer_ends_.empty() ? 0 : layer_ends_.back(); n < ghosts_.size(); ++n)
            layer_of[index_of(ghosts_[n].cell)] = static_cast<std::uint8_t>(layer);
        layer_ends_.push_back(static_cast<std::uint32_t>(ghosts_.size()));
    }
}

void Solids::reach_past_thin(float cells) {
    constexpr int k_node = 2; // of a cubic read, beyond the point
    const int wanted = std::max(k_least_reach, static_cast<int>(std::min(std::ceil(cells), 1000.0f)) + k_node);
    if (wanted == reach_ || (wanted < reach_ && wanted > k_least_reach))
        return;
    reach_ = wanted;
    find_thin_bodies();
    for (std::uint8_t& flags : flags_)
        flags &= static_cast<std::uint8_t>(~k_thin);
    collect_thin();
}

void Solids::find_thin_bodies() {
    thin_bodies_.clear();
    thinnest_ = k_farthest_thin;
    for (const PlacedObstacle& body : bodies_)
        thinnest_ = std::min(thinnest_, detail::thickness(body.shape) / box_.cell_size);
    for (const PlacedObstacle& body : bodies_)
        thin_bodies_.push_back(detail::thickness(body.shape) < static_cast<float>(reach_) * box_.cell_size);
}

// A body is thin where a read from its one side reaches the other.
void Solids::collect_thin() {
    thin_.clear();
    if (std::none_of(thin_bodies_.begin(), thin_bodies_.end(), [](std::uint8_t thin) { return thin != 0; }))
        return;
    thin_.reserve(flags_.size());
    if (reach_ > k_farthest_reach) {
        for (std::uint32_t n = 0; n < flags_.size(); ++n)
            if (!inside(n))
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
                    if (!here)
                        continue;
                    const auto n = static_cast<std::uint32_t>(box_.index(at.x, at.y, at.z));
                    if ((flags_[n] & (k_thin | k_inside)) != 0)
                        continue;
                    flags_[n] |= k_thin;
                    thin_.push_back(n);
                }
    };
    for (const SurfaceCell& cell : surface_) {
        bool is_thin = false;
        for (int slot = 0; slot < 6; ++slot)
            is_thin = is_thin || (cell.closed[slot] > 0.0f && thin_bodies_[cell.body[slot]] != 0);
        if (!inside(cell.cell) && is_thin)
            mark_around(place_of(cell.cell));
    }
    std::sort(thin_.begin(), thin_.end());
}

std::size_t Solids::memory_bytes() const {
    const auto bytes = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    return bytes(bodies_) + bytes(faces_) + bytes(inside_) + bytes(surface_) + bytes(ghosts_) + bytes(ghost_sources_) +
           bytes(layer_ends_) + bytes(thin_) + bytes(flags_) + bytes(distances_);
}

} // namespace windrow::cpu
