// Work groups of the passes: their sizes, and how many a box takes.
#pragma once

#include "fluid/vulkan/blocks.h"
#include "fluid/vulkan/passes.h"

#include <algorithm>
#include <bit>

namespace windrow::vulkan {

class Device;
using Groups = Passes::Groups;

inline std::uint32_t blocks(std::uint32_t count, std::uint32_t size) {
    return (count + size - 1) / size;
}

/// Cells of a group along each axis: long along x for memory access, but not longer than the box.
[[nodiscard]] Groups cell_group(glm::ivec3 cells);
[[nodiscard]] Groups groups_over(glm::ivec3 cells, const Groups& size);

/// Invocations of a group of the direct solve.
[[nodiscard]] std::uint32_t solve_group(const Device& device);

/// Division of planes for the transforms of x and z.
struct PlaneTiles {
    bool whole = true;
    std::uint32_t x = 1, z = 1;  ///< of a whole plane; else of the pass along x: all of x, some of z
    std::uint32_t between_x = 1; ///< of the pass along z: some of x, all of z
};
/// The same on all devices with work groups of 256: 16 KiB of shared memory, which each has, so that several groups run on a
/// multiprocessor at a time whatever it declares.
[[nodiscard]] PlaneTiles tiles_of(const Device& device, std::uint32_t group, glm::ivec3 cells);

/// Work groups of a solve in slabs. An invocation computes four neighbouring outputs of `each` lines.
struct SlabGroups {
    std::uint32_t lines = 8, lines_each = 1; ///< lines of x in a group
    std::uint32_t slab_each = 1;             ///< lines of z are those of a slab: one for each y
    std::uint32_t of_lines = 0, of_slab = 0; ///< invocations
};
[[nodiscard]] SlabGroups slab_groups(glm::ivec3 cells);

} // namespace windrow::vulkan
