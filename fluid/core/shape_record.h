// Data of meshes, voxel grids and heights as fields of an archive: lists by their length, closed cells as bits.
#pragma once

#include "fluid/core/archive.h"

namespace windrow::detail {

/// Items of so many bytes each, behind their count.
void pass_list(auto& archive, auto& items, std::size_t bytes_each) {
    auto count = static_cast<std::uint32_t>(items.size());
    archive(count);
    if constexpr (Reading<decltype(archive)>) {
        if (!archive.can_hold(count, bytes_each))
            return;
        items.resize(count);
    }
    for (auto& item : items)
        archive(item);
}

/// So many flags as bits; `beyond` is what is wrong where the last byte has more.
void pass_bits(auto& archive, auto& flags, std::uint64_t count, const char* beyond) {
    if constexpr (Reading<decltype(archive)>) {
        if (!archive.can_hold((count + 7) / 8, 1))
            return;
        flags.resize(count);
    }
    for (std::size_t first = 0; first < flags.size(); first += 8) {
        std::uint8_t bits = 0;
        const std::size_t here = std::min<std::size_t>(flags.size() - first, 8);
        if constexpr (Reading<decltype(archive)>) {
            archive(bits);
            archive.require(bits >> here == 0, beyond);
            for (std::size_t n = 0; n < here; ++n)
                flags[first + n] = bits >> n & 1;
        } else {
            for (std::size_t n = 0; n < here; ++n)
                bits = static_cast<std::uint8_t>(bits | (flags[first + n] != 0 ? 1u : 0u) << n);
            archive(bits);
        }
    }
}

void fields(auto& archive, Like<MeshData> auto& mesh) {
    auto& [vertices, triangles] = mesh;
    pass_list(archive, vertices, sizeof(glm::vec3));
    pass_list(archive, triangles, sizeof(glm::uvec3));
}

void fields(auto& archive, Like<HeightData> auto& ground) {
    auto& [corners, spacing, heights, holes] = ground;
    archive(corners, spacing);
    pass_list(archive, heights, sizeof(float));
    archive(holes.cells);
    if constexpr (Reading<decltype(archive)>) {
        const glm::ivec2 cells = holes.cells;
        const bool none = cells == glm::ivec2(0), some = std::min(cells.x, cells.y) >= 1;
        archive.require((none || some) && std::max(cells.x, cells.y) <= HeightMap::k_max_corners,
                        "a mask of holes has a size that is out of range.");
        pass_bits(archive, holes.open, some ? static_cast<std::uint64_t>(cells.x) * static_cast<std::uint64_t>(cells.y) : 0,
                  "a mask of holes has cells beyond its last.");
    } else {
        pass_bits(archive, holes.open, holes.open.size(), "");
    }
}

void fields(auto& archive, Like<VoxelData> auto& grid) {
    auto& [cells, closed] = grid;
    archive(cells);
    if constexpr (Reading<decltype(archive)>) {
        std::uint64_t count = 1;
        for (int axis = 0; axis < 3; ++axis) {
            archive.require(cells[axis] >= 1 && cells[axis] <= VoxelGrid::k_max_axis_cells,
                            "a voxel grid's size is out of range.");
            count *= static_cast<std::uint64_t>(cells[axis]);
        }
        archive.require(count <= VoxelGrid::k_max_cells, "a voxel grid's size is out of range.");
        pass_bits(archive, closed, count, "a voxel grid has cells beyond its last.");
    } else {
        pass_bits(archive, closed, closed.size(), "");
    }
}

} // namespace windrow::detail
