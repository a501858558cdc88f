// The box of cells that the solver works on: size, cell size, boundary conditions.
//
// Cell (i, j, k) has its centre at ((i, j, k) + 1/2) h from the box's low corner. Fields are arrays of cells.x * cells.y *
// cells.z values, x fastest, then y, then z: index = (k * cells.y + j) * cells.x + i.
#pragma once

#include "fluid/boundaries.h"
#include "fluid/result.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <tuple>

namespace windrow {

/// Largest number of cells along an axis: the direct solve holds an n x n table an axis.
inline constexpr int k_max_axis_cells = 2048;
/// Largest number of cells of a box (about 7 GB of state and scratch).
inline constexpr std::size_t k_max_cells = std::size_t{1} << 26;

struct Box {
    static constexpr Range k_cells_range{1.0, k_max_axis_cells, "cells"};
    static constexpr Range k_cell_size_range{1e-6, 1e6, "m"};

    glm::ivec3 cells{32, 16, 32};
    float cell_size = 1.0f;
    Boundaries boundaries{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("cells", &Box::cells, k_cells_range, "Cells along x, y, z; odd sizes too. Wind is mostly horizontal."),
            Setting("cell_size", &Box::cell_size, k_cell_size_range, "Edge of a cell."),
            Setting("boundaries", &Box::boundaries, "Boundary conditions of the six faces."),
        };
    }

    [[nodiscard]] std::size_t cell_count() const {
        return static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z);
    }
    [[nodiscard]] std::size_t index(int i, int j, int k) const {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(cells.y) + static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(cells.x) +
               static_cast<std::size_t>(i);
    }
};

/// All reasons why the box is invalid, one per line.
[[nodiscard]] Result<void> validate(const Box& box);
void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Box& box);

} // namespace windrow
