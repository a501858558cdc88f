// Which parts of a mesh's box are inside and which outside, on a grid: a point far from the surface needs no winding number.
//
// A cell that no triangle meets is wholly inside or wholly outside, as are all such cells that touch by a face. A few cells alone are
// left to the winding number of each point.
// Based on: Jacobson, Kavan & Sorkine-Hornung 2013, ACM Transactions on Graphics 32 (inside by the winding number).
#pragma once

#include "fluid/solids/mesh_tree.h"

namespace windrow::detail {

class MeshSigns {
  public:
    /// Throws std::bad_alloc.
    /// Of what bounds a body (surface_of_union), and all of its triangles.
    MeshSigns(const MeshData& surface, const MeshTree& tree, glm::vec3 low, glm::vec3 high);

    MeshSigns() = default; ///< empty, for `pass`
    /// As MeshTree's.
    static void pass(auto& archive, auto& signs) {
        archive.value(signs.low_);
        archive.value(signs.high_);
        archive.value(signs.width_);
        archive.value(signs.count_);
        archive.list(signs.cells_);
    }
    /// Whether each point of the box has a cell.
    [[nodiscard]] bool is_sound() const;

    /// Whether a point is inside.
    [[nodiscard]] bool inside(glm::vec3 point, const MeshTree& tree) const;

    [[nodiscard]] std::size_t memory_bytes() const { return cells_.capacity() * sizeof(Sign); }

  private:
    enum class Sign : std::uint8_t { unknown, near, outside, inside };

    void mark_near(const MeshData& data);
    void collect(std::size_t first, std::vector<std::size_t>& part);
    [[nodiscard]] std::size_t index(glm::ivec3 cell) const {
        return (static_cast<std::size_t>(cell.z) * count_.y + cell.y) * count_.x + cell.x;
    }
    [[nodiscard]] glm::ivec3 place_of(std::size_t cell) const;
    [[nodiscard]] glm::ivec3 cell_of(glm::vec3 point) const;

    glm::vec3 low_{0.0f}, high_{0.0f};
    float width_ = 0.0f; ///< [m] of a cell
    glm::ivec3 count_{0};
    std::vector<Sign> cells_;
};

/// Whether a winding number is one of an inside.
[[nodiscard]] inline bool winds_around(double winding_number) {
    return winding_number > 0.5 || winding_number < -0.5;
}

} // namespace windrow::detail
