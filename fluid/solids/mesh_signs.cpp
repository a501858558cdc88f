#include "fluid/solids/mesh_signs.h"

#include "fluid/portable_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace windrow::detail {
namespace {

constexpr float k_most_cells = 64.0f; // along the longest edge: a quarter of a megabyte in all
constexpr int k_small = 64;           // cells in the box of a part: that of a long triangle holds all of the grid
constexpr std::size_t k_few = 32;     // cells that are not worth a winding number: between crowded triangles are many such parts

/// visit(corners) for parts of a triangle, halved across their longest edges until is_small(corners), or floats end.
template <class IsSmall, class Visit>
void cut_triangle(const std::array<glm::vec3, 3>& corner, const IsSmall& is_small, const Visit& visit) {
    if (is_small(corner))
        return visit(corner);
    const auto halves = halves_of(corner);
    if (!halves)
        return visit(corner);
    for (const auto& half : *halves)
        cut_triangle(half, is_small, visit);
}

} // namespace

MeshSigns::MeshSigns(const MeshData& surface, const MeshTree& tree, glm::vec3 low, glm::vec3 high) : low_(low), high_(high) {
    const glm::vec3 size = high - low;
    const float longest = std::max({size.x, size.y, size.z});
    width_ = longest / std::clamp(4.0f * numerics::cbrt(static_cast<float>(surface.triangles.size())), 8.0f, k_most_cells);
    count_ = glm::ivec3(size / width_) + 1;
    cells_.resize(static_cast<std::size_t>(count_.x) * count_.y * count_.z);
    mark_near(surface);
    std::vector<std::size_t> part;
    part.reserve(cells_.size());
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
        if (cells_[cell] == Sign::unknown) {
            collect(cell, part);
            const glm::vec3 middle = low_ + (glm::vec3(place_of(cell)) + 0.5f) * width_;
            const Sign sign = part.size() < k_few                         ? Sign::near
                              : winds_around(tree.winding_number(middle)) ? Sign::inside
                                                                          : Sign::outside;
            for (const std::size_t one : part)
                cells_[one] = sign;
        }
}

// Cells that the plane of a triangle meets within the boxes of its parts, grown by what rounding may move.
void MeshSigns::mark_near(const MeshData& data) {
    const float touch = 1e-3f * width_;
    for (const glm::uvec3& t : data.triangles) {
        const glm::vec3 a = data.vertices[t.x], b = data.vertices[t.y], c = data.vertices[t.z];
        const glm::vec3 normal(glm::cross(glm::dvec3(b - a), glm::dvec3(c - a)));
        const float size = glm::length(normal), near = 0.5f * width_ * glm::dot(glm::abs(normal), glm::vec3(1.0f)) + touch * size;
        const auto first = [&](const auto& part) { return cell_of(glm::min(part[0], glm::min(part[1], part[2])) - touch); };
        const auto last = [&](const auto& part) { return cell_of(glm::max(part[0], glm::max(part[1], part[2])) + touch); };
        const auto is_small = [&](const auto& part) {
            const glm::ivec3 cells = last(part) - first(part) + 1;
            return cells.x * cells.y * cells.z <= k_small;
        };
        cut_triangle(std::array{a, b, c}, is_small, [&](const auto& part) {
            const glm::ivec3 from = first(part), to = last(part);
            for (int k = from.z; k <= to.z; ++k)
                for (int j = from.y; j <= to.y; ++j)
                    for (int i = from.x; i <= to.x; ++i)
                        if (std::abs(glm::dot(normal, low_ + (glm::vec3(i, j, k) + 0.5f) * width_ - a)) <= near)
                            cells_[index({i, j, k})] = Sign::near;
        });
    }
}

// All unknown cells that touch this one by faces, through others.
void MeshSigns::collect(std::size_t first, std::vector<std::size_t>& part) {
    cells_[first] = Sign::outside; // for now
    part.assign(1, first);
    for (std::size_t n = 0; n < part.size(); ++n) {
        const glm::ivec3 cell = place_of(part[n]);
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                glm::ivec3 next = cell;
                next[axis] += side;
                if (next[axis] < 0 || next[axis] >= count_[axis] || cells_[index(next)] != Sign::unknown)
                    continue;
                cells_[index(next)] = Sign::outside;
                part.push_back(index(next));
            }
    }
}

glm::ivec3 MeshSigns::place_of(std::size_t cell) const {
    const auto x = static_cast<std::size_t>(count_.x), y = static_cast<std::size_t>(count_.y);
    return {static_cast<int>(cell % x), static_cast<int>(cell / x % y), static_cast<int>(cell / x / y)};
}

glm::ivec3 MeshSigns::cell_of(glm::vec3 point) const {
    return glm::clamp(glm::ivec3((point - low_) / width_), glm::ivec3(0), count_ - 1);
}

bool MeshSigns::is_sound() const {
    constexpr int k_most_count = static_cast<int>(k_most_cells) + 2;
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(low_[axis]) || !std::isfinite(high_[axis]) || count_[axis] < 1 || count_[axis] > k_most_count ||
            !((high_[axis] - low_[axis]) / width_ < 1e6f))
            return false;
    return width_ > 0.0f && cells_.size() == static_cast<std::size_t>(count_.x) * count_.y * count_.z &&
           std::all_of(cells_.begin(), cells_.end(), [](Sign sign) { return sign <= Sign::inside; });
}

bool MeshSigns::inside(glm::vec3 point, const MeshTree& tree) const {
    if (!(glm::all(glm::lessThanEqual(low_, point)) && glm::all(glm::lessThanEqual(point, high_))))
        return false;
    const Sign sign = cells_[index(cell_of(point))];
    return sign == Sign::inside || (sign == Sign::near && winds_around(tree.winding_number(point)));
}

} // namespace windrow::detail
