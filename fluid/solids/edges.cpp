#include "fluid/solids/edges.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace windrow::detail {
namespace {

float distance_to_line(glm::vec3 from, glm::vec3 to, glm::vec3 place) {
    const glm::vec3 way = to - from;
    const float part = glm::dot(place - from, way) / std::max(glm::dot(way, way), 1e-37f);
    return glm::distance(place, from + std::clamp(part, 0.0f, 1.0f) * way);
}

// Adds those that are near enough.
class Found {
  public:
    Found(glm::vec3 place, float most, std::span<SharpEdge> room) : place_(place), most_(most), room_(room) {}
    void add(const SharpEdge& edge) {
        if (count_ < room_.size() && distance_to_line(edge.from, edge.to, place_) < most_)
            room_[count_++] = edge;
    }
    [[nodiscard]] std::size_t count() const { return count_; }

  private:
    glm::vec3 place_;
    float most_;
    std::span<SharpEdge> room_;
    std::size_t count_ = 0;
};

glm::vec3 along(int axis, float way) {
    glm::vec3 result(0.0f);
    result[axis] = way;
    return result;
}

void find(const Block& block, glm::vec3 place, float most, Found& found) {
    const glm::vec3 before = block.half_size - glm::abs(place);
    if (int(before.x < most) + int(before.y < most) + int(before.z < most) < 2)
        return; // beside one face alone
    for (int axis = 0; axis < 3; ++axis)
        for (int n = 0; n < 4; ++n) {
            const int one = (axis + 1) % 3, other = (axis + 2) % 3;
            const float sides[2] = {n % 2 == 0 ? -1.0f : 1.0f, n / 2 == 0 ? -1.0f : 1.0f};
            glm::vec3 middle(0.0f);
            middle[one] = sides[0] * block.half_size[one];
            middle[other] = sides[1] * block.half_size[other];
            const glm::vec3 half = along(axis, block.half_size[axis]);
            found.add({middle - half, middle + half, along(one, sides[0]), along(other, sides[1])});
        }
}

void find(const MeshShape& shape, glm::vec3 place, float most, Found& found) {
    shape.mesh->for_each_edge_near(place / shape.scale, most / shape.scale, [&](const MeshEdge& edge) {
        found.add({shape.scale * edge.from, shape.scale * edge.to, edge.normal, edge.other});
    });
}

// Lines of the grid that a single closed one of their four cells touches.
void find(const VoxelShape& shape, glm::vec3 place, float most, Found& found) {
    const VoxelGrid& grid = *shape.grid;
    const glm::ivec3 cells = grid.data().cells;
    const glm::vec3 middle = 0.5f * glm::vec3(cells), at = place / shape.cell_size + middle;
    const float reach = most / shape.cell_size;
    const auto closed = [&](glm::ivec3 cell) {
        return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThan(cell, cells)) && grid.closed(cell);
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int one = (axis + 1) % 3, other = (axis + 2) % 3;
        glm::ivec3 first = glm::ivec3(glm::ceil(at - reach)), last = glm::ivec3(glm::floor(at + reach));
        first[axis] = static_cast<int>(std::floor(at[axis] - reach));
        first = glm::max(first, glm::ivec3(0));
        last = glm::min(last, cells);
        last[axis] = std::min(last[axis], cells[axis] - 1);
        for (int c = first[axis]; c <= last[axis]; ++c)
            for (int b = first[other]; b <= last[other]; ++b)
                for (int a = first[one]; a <= last[one]; ++a) {
                    int count = 0;
                    glm::vec2 out(0.0f);
                    for (int n = 0; n < 4; ++n) {
                        glm::ivec3 cell;
                        cell[axis] = c;
                        cell[one] = a - n % 2;
                        cell[other] = b - n / 2;
                        if (closed(cell)) {
                            ++count;
                            out = {n % 2 == 0 ? -1.0f : 1.0f, n / 2 == 0 ? -1.0f : 1.0f};
                        }
                    }
                    if (count != 1)
                        continue;
                    glm::vec3 from;
                    from[axis] = static_cast<float>(c);
                    from[one] = static_cast<float>(a);
                    from[other] = static_cast<float>(b);
                    found.add({shape.cell_size * (from - middle), shape.cell_size * (from + along(axis, 1.0f) - middle),
                               along(one, out.x), along(other, out.y)});
                }
    }
}

void find(const auto&, glm::vec3, float, Found&) {}

} // namespace

bool has_sharp_edges(const Shape& shape) {
    return std::holds_alternative<Block>(shape) || std::holds_alternative<MeshShape>(shape) ||
           std::holds_alternative<VoxelShape>(shape);
}

std::size_t sharp_edges_near(const Shape& shape, glm::vec3 place, float most, float cell, std::span<SharpEdge> found) {
    const auto* const voxels = std::get_if<VoxelShape>(&shape);
    if (voxels != nullptr && voxels->cell_size < 0.5f * cell)
        return 0;
    Found near(place, most, found);
    std::visit([&](const auto& kind) { find(kind, place, most, near); }, shape);
    return near.count();
}

} // namespace windrow::detail
