#include "fluid/solids/mesh_signs.h"

#include "fluid/portable_math.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace windrow::detail {
namespace {

constexpr float k_most_cells = 64.0f; // along the longest edge: a quarter of a megabyte in all

} // namespace

MeshSigns::MeshSigns(const MeshData& data, const MeshTree& tree, glm::vec3 low, glm::vec3 high) : low_(low), high_(high) {
    const glm::vec3 size = high - low;
    const float longest = std::max({size.x, size.y, size.z});
    width_ = longest / std::clamp(4.0f * numerics::cbrt(static_cast<float>(data.triangles.size())), 8.0f, k_most_cells);
    count_ = glm::ivec3(size / width_) + 1;
    cells_.resize(static_cast<std::size_t>(count_.x) * count_.y * count_.z);
    mark_near(data);
    std::vector<std::size_t> open;
    open.reserve(cells_.size());
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
        if (cells_[cell] == Sign::unknown) {
            const glm::vec3 middle = low_ + (glm::vec3(place_of(cell)) + 0.5f) * width_;
            fill(cell, winds_around(tree.winding_number(middle)) ? Sign::inside : Sign::outside, open);
        }
}

// Cells that the plane of a triangle meets within the triangle's box, grown by what rounding may move.
void MeshSigns::mark_near(const MeshData& data) {
    const float touch = 1e-3f * width_;
    for (const glm::uvec3& t : data.triangles) {
        const glm::vec3 a = data.vertices[t.x], b = data.vertices[t.y], c = data.vertices[t.z];
        const glm::vec3 normal(glm::cross(glm::dvec3(b - a), glm::dvec3(c - a)));
        const float size = glm::length(normal), near = 0.5f * width_ * glm::dot(glm::abs(normal), glm::vec3(1.0f)) + touch * size;
        const glm::ivec3 first = cell_of(glm::min(a, glm::min(b, c)) - touch),
                         last = cell_of(glm::max(a, glm::max(b, c)) + touch);
        for (int k = first.z; k <= last.z; ++k)
            for (int j = first.y; j <= last.y; ++j)
                for (int i = first.x; i <= last.x; ++i)
                    if (std::abs(glm::dot(normal, low_ + (glm::vec3(i, j, k) + 0.5f) * width_ - a)) <= near)
                        cells_[index({i, j, k})] = Sign::near;
    }
}

void MeshSigns::fill(std::size_t first, Sign sign, std::vector<std::size_t>& open) {
    cells_[first] = sign;
    open.assign(1, first);
    while (!open.empty()) {
        const glm::ivec3 cell = place_of(open.back());
        open.pop_back();
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                glm::ivec3 next = cell;
                next[axis] += side;
                if (next[axis] < 0 || next[axis] >= count_[axis] || cells_[index(next)] != Sign::unknown)
                    continue;
                cells_[index(next)] = sign;
                open.push_back(index(next));
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

bool MeshSigns::inside(glm::vec3 point, const MeshTree& tree) const {
    if (!(glm::all(glm::lessThanEqual(low_, point)) && glm::all(glm::lessThanEqual(point, high_))))
        return false;
    const Sign sign = cells_[index(cell_of(point))];
    return sign == Sign::inside || (sign == Sign::near && winds_around(tree.winding_number(point)));
}

} // namespace windrow::detail
