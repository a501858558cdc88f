// Closed and open cells of a grid: the form of a body, made once and shared by any number of obstacles. A building of a voxel game.
//
//     auto tower = windrow::VoxelGrid::create({.cells = {16, 40, 16}, .closed = bytes});
//     if (!tower) std::fprintf(stderr, "%s\n", tower.error().c_str());
//     else (void)wind.obstacles().add({.position = here, .shape = windrow::VoxelShape{*tower, 0.5f}});
//
// Lengths and places are in the grid's cells here, from its low corner. Distances are exact: to the nearest closed cell from
// outside, to the nearest open cell, or out of the grid, from inside.
#pragma once

#include "../api.h"
#include "../result.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <vector>

namespace windrow {

/// Cells along x, y and z, and for each 0 (open) or another number (closed): x fastest, z slowest.
struct VoxelData {
    glm::ivec3 cells{0};
    std::vector<std::uint8_t> closed{};
    friend bool operator==(const VoxelData&, const VoxelData&) = default;
};

class WINDROW_API VoxelGrid {
  public:
    using Data = VoxelData;

    /// 256^3, the largest model of the usual editors; it takes 20 MB.
    static constexpr std::size_t k_max_cells = std::size_t{1} << 24;
    static constexpr int k_max_axis_cells = 4096;

    /// Rejects sizes beyond these, another number of cells than the size says, a grid without a closed cell, and memory that is
    /// short.
    [[nodiscard]] static Result<std::shared_ptr<const VoxelGrid>> create(VoxelData data);

    /// What it was made of; closed cells are 1.
    [[nodiscard]] const VoxelData& data() const { return data_; }
    [[nodiscard]] bool closed(glm::ivec3 cell) const { return data_.closed[index(data_.cells, cell)] != 0; }
    /// From a point to the surface, negative inside. Beyond `most` it may be any value from `most` on, of the right sign.
    [[nodiscard]] float distance_to(glm::vec3 point, float most = std::numeric_limits<float>::infinity()) const;
    /// Whether the segment between two points passes through a closed cell.
    [[nodiscard]] bool crosses(glm::vec3 from, glm::vec3 to) const;
    /// Least number of closed cells in a row along an axis, between open ones.
    [[nodiscard]] int thickness() const { return thickness_; }

    [[nodiscard]] std::size_t memory_bytes() const;
    /// Equal for equal data.
    [[nodiscard]] std::uint64_t content_hash() const { return hash_; }
    /// By what they hold, not by where they are in memory.
    friend bool operator==(const VoxelGrid& a, const VoxelGrid& b) { return (a <=> b) == 0; }
    friend std::strong_ordering operator<=>(const VoxelGrid& a, const VoxelGrid& b);

  private:
    /// Blocks of 2^n cells a side: what they hold.
    struct Level {
        glm::ivec3 count;
        std::vector<std::uint8_t> holds;
    };
    static constexpr std::uint8_t k_open = 1, k_closed = 2;

    explicit VoxelGrid(VoxelData data); ///< throws std::bad_alloc

    static std::size_t index(glm::ivec3 count, glm::ivec3 at) {
        return (static_cast<std::size_t>(at.z) * count.y + at.y) * count.x + at.x;
    }
    [[nodiscard]] std::uint8_t holds(int level, glm::ivec3 block) const {
        if (level == 0)
            return closed(block) ? k_closed : k_open;
        const Level& blocks = levels_[static_cast<std::size_t>(level - 1)];
        return blocks.holds[index(blocks.count, block)];
    }
    /// To the nearest cell of this kind, or `most` where none is nearer.
    [[nodiscard]] float distance(glm::vec3 point, std::uint8_t kind, float most) const;
    [[nodiscard]] int least_row() const;

    VoxelData data_;
    std::uint64_t hash_;
    std::vector<Level> levels_; ///< from blocks of 2 cells a side to one block
    int thickness_;
};

} // namespace windrow
