// Balls in the world, found by place: a hash grid with a level for each power of two of their size.
//
// A ball is in one cell, that of its centre, on the level whose cells are wider than the ball. So a search looks at the cells in
// reach of a box on each level in use, whatever else is in the world.
#pragma once

#include "api.h"
#include "window.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace windrow::detail {

class WINDROW_API ObstacleGrid {
  public:
    /// `finest` [m]: width of the cells of the finest level. Default: a quarter of a usual box; finer cells make a search longer.
    explicit ObstacleGrid(double finest = 8.0) : finest_(finest) {}
    /// Makes room for the items 0 to count - 1. Throws std::bad_alloc, and nothing has changed then.
    void reserve(std::size_t count);
    /// Adds an item that is not in the grid: a ball [m].
    void insert(std::uint32_t item, glm::dvec3 centre, double radius);
    void erase(std::uint32_t item);

    /// Calls visit(item) for each item whose ball may meet the box [m], in no particular order.
    template <class Visit>
    void find(glm::dvec3 low, glm::dvec3 high, const Visit& visit) const {
        if (cells_in(low, high) > static_cast<double>(count_)) { // one by one is faster
            for (std::uint32_t item = 0; item < nodes_.size(); ++item)
                if (nodes_[item].level >= 0)
                    visit(item);
            return;
        }
        for (int level = 0; level < k_levels; ++level) {
            if (on_level_[static_cast<std::size_t>(level)] == 0)
                continue;
            const CellIndex first = cell_of(low, level, -0.5), last = cell_of(high, level, 0.5);
            for (std::int64_t z = first.z; z <= last.z; ++z)
                for (std::int64_t y = first.y; y <= last.y; ++y)
                    for (std::int64_t x = first.x; x <= last.x; ++x) {
                        const CellIndex cell(x, y, z);
                        for (std::uint32_t n = heads_[bucket_of(cell, level)]; n != k_none; n = nodes_[n].next)
                            if (nodes_[n].level == level && nodes_[n].cell == cell) // others are in the same bucket
                                visit(n);
                    }
        }
    }

    [[nodiscard]] std::size_t memory_bytes() const {
        return nodes_.capacity() * sizeof(Node) + heads_.capacity() * sizeof(std::uint32_t);
    }

  private:
    static constexpr std::uint32_t k_none = ~std::uint32_t{0};
    static constexpr int k_levels = 32;

    struct Node {
        CellIndex cell{0};
        int level = -1; ///< -1: not in the grid
        std::uint32_t next = k_none, before = k_none;
    };

    [[nodiscard]] double width(int level) const { return std::ldexp(finest_, level); }
    /// The cell of a place that is moved by `shift` cells.
    [[nodiscard]] CellIndex cell_of(glm::dvec3 place, int level, double shift) const {
        return CellIndex(glm::floor(place / width(level) + shift));
    }
    [[nodiscard]] std::size_t bucket_of(CellIndex cell, int level) const;
    /// Number of cells that a search looks at.
    [[nodiscard]] double cells_in(glm::dvec3 low, glm::dvec3 high) const;
    void link(std::uint32_t item);

    std::vector<Node> nodes_;          ///< one an item
    std::vector<std::uint32_t> heads_; ///< first item of each bucket; a power of two of them
    std::array<std::uint32_t, k_levels> on_level_{};
    std::size_t count_ = 0;
    double finest_;
};

} // namespace windrow::detail
