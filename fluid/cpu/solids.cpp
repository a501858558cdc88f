#include "fluid/cpu/solids.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <utility>

namespace windrow::cpu {
namespace {

// Distances below this fraction of a cell count as 0: a body along the cells' faces has these faces closed, whatever rounding does.
constexpr float k_touch = 1e-4f;
constexpr float k_open_at_most = 6e-3f; // open fractions of a shut cell, all faces together
constexpr int k_farthest_reach = 6;     // [cells] beyond it every cell counts as beside a thin body
constexpr int k_beyond = 8;             // [cells] drawn beyond the box, so that not every shift draws a large body again

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
    : box_(box), pitch_(pitch), flags_(box.cell_count()), body_of_(box.cell_count()), surface_of_(box.cell_count()),
      layers_(box.cell_count()), face_of_(3 * box.cell_count(), k_none) {}

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

template <class Visit>
void Solids::for_each_neighbour(const InsideCell& cell, const Visit& visit) const {
    const std::uint32_t strides[3] = {1, static_cast<std::uint32_t>(box_.cells.x),
                                      static_cast<std::uint32_t>(box_.cells.x * box_.cells.y)};
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1}) {
            std::uint32_t other = 0;
            const int at = cell.place[axis] + side;
            if (at >= 0 && at < box_.cells[axis]) {
                other = side < 0 ? cell.cell - strides[axis] : cell.cell + strides[axis];
            } else {
                glm::ivec3 next;
                if (!neighbour(cell.place, axis, side, next))
                    continue;
                other = index(next);
            }
            visit(other, axis, face(side < 0 ? other : cell.cell, axis));
        }
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

    bodies_.assign(obstacles.begin(), obstacles.end());
    drawings_.swap(drawings_before_);
    for (Drawing& drawing : drawings_before_) {
        drawing.body.position -= glm::vec3(shift) * box_.cell_size;
        drawing.low -= shift;
        drawing.high -= shift;
        for (Drawing::Face& face : drawing.faces)
            face.cell -= shift;
        for (glm::ivec3& cell : drawing.inside)
            cell -= shift;
    }
    // Both lists have about the same order, so that what is looked for is mostly the next.
    drawn_ = 0;
    drawings_.resize(bodies_.size());
    std::size_t from = 0;
    for (std::size_t n = 0; n < bodies_.size(); ++n) {
        std::size_t tries = 0;
        while (tries < drawings_before_.size() && !still_holds(drawings_before_[from], bodies_[n])) {
            from = from + 1 < drawings_before_.size() ? from + 1 : 0;
            ++tries;
        }
        if (tries < drawings_before_.size()) {
            std::swap(drawings_[n], drawings_before_[from]);
            drawings_before_[from].body.position.x = std::numeric_limits<float>::quiet_NaN(); // taken
            from = from + 1 < drawings_before_.size() ? from + 1 : 0;
        } else {
            drawings_[n].body = bodies_[n];
            draw(drawings_[n]);
            ++drawn_;
        }
    }
    find_thin_bodies();
    collect_faces();
    find_shut_cells();
    collect_surface();
    collect_ghosts();
    collect_thin();
}

// Cells whose centre, corner or line to a neighbour a body may touch, within the box and `beyond` it.
Solids::Reach Solids::reach_of(const PlacedObstacle& obstacle, glm::ivec3 beyond) const {
    const glm::vec3 own = detail::half_extent(obstacle.shape);
    glm::vec3 half(0.0f);
    for (int axis = 0; axis < 3; ++axis)
        half += glm::abs(obstacle.axes[axis]) * own[axis];
    const float h = box_.cell_size;
    const glm::vec3 least(-beyond), most(box_.cells + beyond);
    return {glm::ivec3(glm::clamp(glm::floor((obstacle.position - half) / h) - 1.0f, least, most)),
            glm::ivec3(glm::clamp(glm::ceil((obstacle.position + half) / h) + 1.0f, least, most))};
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

void Solids::draw(Drawing& drawing) {
    drawing.faces.clear();
    drawing.inside.clear();
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
                draw_image(drawing, reach_of(image, beyond), glm::ivec3(x, y, z) * box_.cells);
            }
}

// Adds the closed faces and the inside cells of one image of a body.
void Solids::draw_image(Drawing& drawing, const Reach& reach, glm::ivec3 offset) {
    const glm::ivec3 low = reach.low, high = reach.high, corners = high - low + 1;
    if (corners.x <= 1 || corners.y <= 1 || corners.z <= 1)
        return;
    const PlacedObstacle& body = drawing.body;
    const float h = box_.cell_size;
    const glm::mat3 to_own = glm::transpose(body.axes);
    // From the cell that holds the middle, so that a body has the same cells wherever the box is.
    const glm::dvec3 middle = glm::dvec3(body.position) / static_cast<double>(h) + glm::dvec3(offset);
    const glm::dvec3 base = glm::floor(middle);
    const glm::vec3 part = glm::vec3(glm::round((middle - base) * k_parts) / k_parts);
    const auto from_middle = [&](glm::vec3 cell) { return ((cell - glm::vec3(base)) - part) * h; };
    const auto own_place = [&](glm::vec3 cell) { return to_own * from_middle(cell); };
    const auto corner = [&](glm::ivec3 at) {
        at -= low;
        return (static_cast<std::size_t>(at.z) * corners.y + at.y) * corners.x + at.x;
    };
    const bool flat = std::holds_alternative<Plate>(body.shape), moves = body.moves();
    if (!flat) {
        distances_.resize(static_cast<std::size_t>(corners.x) * corners.y * corners.z);
        for (int k = low.z; k <= high.z; ++k)
            for (int j = low.y; j <= high.y; ++j)
                for (int i = low.x; i <= high.x; ++i)
                    distances_[corner({i, j, k})] = detail::distance_to(body.shape, own_place({i, j, k})) / h - k_touch;
    }
    for (int k = low.z; k < high.z; ++k)
        for (int j = low.y; j < high.y; ++j)
            for (int i = low.x; i < high.x; ++i) {
                const glm::ivec3 cell(i, j, k);
                const glm::vec3 centre = glm::vec3(cell) + 0.5f, here = own_place(centre);
                const float away = detail::distance_to(body.shape, here) / h;
                const bool in = !flat && away <= 0.0f;
                if (in)
                    drawing.inside.push_back(cell);
                if (away > 2.0f || away < -2.0f)
                    continue;
                for (int axis = 0; axis < 3; ++axis) {
                    glm::vec3 step(0.0f);
                    step[axis] = 1.0f;
                    float closed = 0.0f;
                    if (!flat) {
                        glm::ivec3 face = cell, one(0), other(0);
                        ++face[axis];
                        one[(axis + 1) % 3] = other[(axis + 2) % 3] = 1;
                        closed = negative_fraction(distances_[corner(face)], distances_[corner(face + one)],
                                                   distances_[corner(face + one + other)], distances_[corner(face + other)]);
                    }
                    if (closed < 1.0f && !in && away < 1.0f) {
                        const glm::vec3 beyond = own_place(centre + step);
                        if ((flat || detail::distance_to(body.shape, beyond) > 0.0f) && detail::blocks(body.shape, here, beyond))
                            closed = 1.0f;
                    }
                    if (!(closed > 0.0f))
                        continue;
                    const float wall =
                        moves ? closed * (body.velocity + glm::cross(body.spin, from_middle(centre + 0.5f * step)))[axis] : 0.0f;
                    drawing.faces.push_back({cell, axis, closed, wall});
                }
            }
}

// --- Lists -------------------------------------------------------------------------------------------------------------------

// All drawings' faces and inside cells in the box, sorted by cell. Bodies that close parts of one face close their sum.
void Solids::collect_faces() {
    unsorted_.clear();
    const auto in_box = [&](glm::ivec3 cell) {
        return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThan(cell, box_.cells));
    };
    for (std::size_t body = 0; body < drawings_.size(); ++body) {
        const auto number = static_cast<std::uint16_t>(body);
        for (const Drawing::Face& drawn : drawings_[body].faces) {
            glm::ivec3 next;
            if (!in_box(drawn.cell) || !neighbour(drawn.cell, drawn.axis, 1, next))
                continue;
            const std::uint32_t low = index(drawn.cell);
            std::uint32_t& at = face_of_[3 * static_cast<std::size_t>(low) + static_cast<std::size_t>(drawn.axis)];
            if (at != k_none) {
                ClosedFace& face = unsorted_[at];
                const float sum = face.closed + drawn.closed, scale = sum > 1.0f ? 1.0f / sum : 1.0f;
                face.closed = scale * sum;
                face.wall = scale * (face.wall + drawn.wall);
                continue;
            }
            at = static_cast<std::uint32_t>(unsorted_.size());
            flags_[low] |= k_low;
            unsorted_.push_back({.cell = {low, index(next)},
                                 .potential = {potential_of(drawn.cell), potential_of(next)},
                                 .closed = drawn.closed,
                                 .wall = drawn.wall,
                                 .body = number,
                                 .axis = static_cast<std::uint8_t>(drawn.axis)});
        }
        for (const glm::ivec3& cell : drawings_[body].inside) {
            if (!in_box(cell))
                continue;
            const std::uint32_t n = index(cell);
            if ((flags_[n] & k_inside) == 0)
                body_of_[n] = number;
            flags_[n] |= k_inside;
        }
    }
    inside_.clear();
    faces_.clear();
    for_each_flagged(k_inside | k_low, [&](std::uint32_t n, glm::ivec3 place) {
        if ((flags_[n] & k_inside) != 0)
            inside_.push_back({n, potential_of(place), place, body_of_[n], false});
        if ((flags_[n] & k_low) == 0)
            return;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (std::uint32_t& at = face_of_[3 * static_cast<std::size_t>(n) + axis]; at != k_none) {
                faces_.push_back(unsorted_[at]);
                at = static_cast<std::uint32_t>(faces_.size() - 1);
            }
    });
    for (const ClosedFace& face : faces_)
        if (face.closed >= 0.5f)
            flags_[face.cell[0]] |= static_cast<std::uint8_t>(1u << face.axis);
}

// An inside cell is shut where no face of it is open: each is closed, or leads to another cell inside.
void Solids::find_shut_cells() {
    for (InsideCell& cell : inside_) {
        float open = 0.0f;
        for_each_neighbour(cell, [&](std::uint32_t other, int, const ClosedFace* face) {
            if (face != nullptr)
                open += 1.0f - face->closed;
            else if (!inside(other))
                open += 1.0f;
        });
        cell.shut = open <= k_open_at_most;
        if (cell.shut)
            flags_[cell.cell] |= k_shut;
    }
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

void Solids::collect_surface() {
    for (const ClosedFace& face : faces_)
        for (const std::uint32_t cell : face.cell)
            flags_[cell] |= k_surface;
    surface_.clear();
    for_each_flagged(k_surface, [&](std::uint32_t n, glm::ivec3 place) {
        const bool edge = glm::any(glm::equal(place, glm::ivec3(0))) || glm::any(glm::equal(place, box_.cells - 1));
        surface_of_[n] = static_cast<std::uint32_t>(surface_.size());
        surface_.push_back({n, potential_of(place), (flags_[n] & k_shut) != 0, edge});
    });
    for (ClosedFace& face : faces_)
        for (int end = 0; end < 2; ++end)
            face.surface[end] = surface_of_[face.cell[end]];
}

void Solids::collect_ghosts() {
    ghosts_.clear();
    ghost_sources_.clear();
    layer_ends_.clear();
    for (std::uint8_t layer = 1; layer <= k_ghost_layers; ++layer) {
        const std::size_t before = ghosts_.size();
        for (const InsideCell& cell : inside_) {
            if (layers_[cell.cell] != 0)
                continue;
            const auto first = static_cast<std::uint32_t>(ghost_sources_.size());
            for_each_neighbour(cell, [&](std::uint32_t other, int axis, const ClosedFace* face) {
                const bool air = !inside(other);
                if (layer == 1 ? !air : air || layers_[other] != layer - 1)
                    return;
                GhostSource source{.cell = other, .axis = static_cast<std::uint8_t>(axis)};
                if (air && face != nullptr)
                    source.closed = face->closed, source.wall = face->wall / face->closed;
                ghost_sources_.push_back(source);
            });
            if (const auto count = static_cast<std::uint32_t>(ghost_sources_.size()) - first; count > 0)
                ghosts_.push_back({cell.cell, first, count});
        }
        for (std::size_t n = before; n < ghosts_.size(); ++n)
            layers_[ghosts_[n].cell] = layer;
        layer_ends_.push_back(static_cast<std::uint32_t>(ghosts_.size()));
    }
}

// --- Thin bodies -------------------------------------------------------------------------------------------------------------

void Solids::reach_past_thin(float cells) {
    constexpr int k_node = 2; // of a cubic read, beyond the point
    const int wanted = std::max(k_least_reach, static_cast<int>(std::min(std::ceil(cells), 1000.0f)) + k_node);
    if (wanted == reach_ || (wanted < reach_ && wanted > k_least_reach))
        return;
    reach_ = wanted;
    find_thin_bodies();
    collect_thin();
}

// A body is thin where a read from its one side reaches the other.
void Solids::find_thin_bodies() {
    thin_bodies_.clear();
    thinnest_ = k_farthest_thin;
    for (const PlacedObstacle& body : bodies_) {
        const float thickness = detail::thickness(body.shape) / box_.cell_size;
        thinnest_ = std::min(thinnest_, thickness);
        thin_bodies_.push_back(thickness < static_cast<float>(reach_));
    }
}

void Solids::collect_thin() {
    for (const std::uint32_t cell : thin_)
        flags_[cell] &= static_cast<std::uint8_t>(~k_thin);
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
                    if (!here || (flags_[index(at)] & (k_thin | k_inside)) != 0)
                        continue;
                    flags_[index(at)] |= k_thin;
                    thin_.push_back(index(at));
                }
    };
    for (const ClosedFace& face : faces_)
        if (thin_bodies_[face.body] != 0)
            for (int end = 0; end < 2; ++end)
                if (!inside(face.cell[end]))
                    mark_around(place_of(face.cell[end]));
    std::sort(thin_.begin(), thin_.end());
}

std::size_t Solids::memory_bytes() const {
    const auto bytes = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    std::size_t sum = bytes(bodies_) + bytes(faces_) + bytes(surface_) + bytes(inside_) + bytes(ghosts_) + bytes(ghost_sources_) +
                      bytes(layer_ends_) + bytes(thin_) + bytes(flags_) + bytes(body_of_) + bytes(surface_of_) +
                      bytes(unsorted_) + bytes(layers_) + bytes(face_of_) + bytes(distances_);
    for (const auto* drawings : {&drawings_, &drawings_before_})
        for (const Drawing& drawing : *drawings)
            sum += sizeof(Drawing) + bytes(drawing.faces) + bytes(drawing.inside);
    return sum;
}

} // namespace windrow::cpu
