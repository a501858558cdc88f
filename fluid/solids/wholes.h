// Blocks at rest that together are one block: a house, a tower or a wall of pieces is drawn as the whole, each piece its own cells. Drawn
// one by one, faces across a seam would stay open in part, since distances near it are those from a piece's edge, and each piece would
// be as thin as itself.
#pragma once

#include "fluid/obstacle.h"

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

namespace windrow {

class Wholes {
  public:
    static constexpr float k_seam = 1e-3f; ///< [cells] between bodies that touch: places are rounded to a fourth of it

    /// How a body is a part of its whole.
    struct Part {
        glm::vec3 half{0.0f}; ///< [m] half the size of the whole; 0: there is none
        glm::vec3 from{0.0f}; ///< [m] from the body's middle to the whole's, along the world's axes
    };

    /// Among bodies in a box of such cells [m]: those whose axes are the same and whose sides are the same along two of them, in rows
    /// along the third, and so on with what these make. The bodies must stay until the next call. `rest_as_before`: those at rest are
    /// the same as in the last call, in one order.
    void find(std::span<const PlacedObstacle> bodies, float cell, bool rest_as_before);

    /// The whole that a body is a part of, or the body itself.
    [[nodiscard]] const PlacedObstacle& of(std::size_t body) const {
        return whole_of_[body] == k_none ? bodies_[body] : wholes_[whole_of_[body]];
    }
    [[nodiscard]] bool is_part(std::size_t body) const { return whole_of_[body] != k_none; }
    [[nodiscard]] bool are_of_one(std::size_t a, std::size_t b) const { return is_part(a) && whole_of_[a] == whole_of_[b]; }
    [[nodiscard]] Part part(std::size_t body) const;
    /// Whether a part is the same as before; rounding may have moved it a little.
    [[nodiscard]] bool is_same(const Part& a, const Part& b) const;
    /// Whether a place [m], in the whole's own axes from its middle, is another part's: that one's which holds the place of the whole
    /// nearest to it, the first where several do.
    [[nodiscard]] bool is_anothers(std::size_t body, glm::vec3 place) const;

  private:
    static constexpr std::uint32_t k_none = ~std::uint32_t{0};
    struct Row {
        glm::vec3 low, high;       ///< [m] along its own axes
        std::uint32_t first, last; ///< of its bodies at rest, each with the next
        std::uint32_t kind;        ///< equal where axes and surface are
        std::array<int, 4> sides;  ///< rounded, across
    };
    void join();
    [[nodiscard]] bool join_along(int axis);

    std::span<const PlacedObstacle> bodies_;
    float cell_ = 1.0f;
    std::vector<PlacedObstacle> wholes_;
    std::vector<std::uint32_t> whole_of_; ///< of a body
    std::vector<detail::Extent> part_;    ///< [m] of a body, along its whole's own axes from its middle
    std::vector<std::uint32_t> at_rest_;  ///< bodies
    // By the number of a body in that list.
    std::vector<std::uint32_t> whole_at_rest_;
    std::vector<std::pair<std::uint32_t, Part>> firsts_; ///< of each whole, a body of it and how that is a part
    std::vector<Row> rows_;                              ///< scratch
    std::vector<std::uint32_t> next_;                    ///< scratch: of a body
};

} // namespace windrow
