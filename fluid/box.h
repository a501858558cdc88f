// The box of cells that the solver works on: size, cell size, boundary conditions.
//
// Cell (i, j, k) has its centre at ((i, j, k) + 1/2) h from the box's low corner, or its row's height where the box has rows of its
// own (rows.h). Fields are arrays of cells.x * cells.y *
// cells.z values, x fastest, then y, then z: index = (k * cells.y + j) * cells.x + i.
#pragma once

#include "api.h"
#include "boundaries.h"
#include "result.h"
#include "rows.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <tuple>

namespace windrow {

/// Largest number of cells along an axis: the direct solve holds an n x n table an axis.
inline constexpr int k_max_axis_cells = 2048;
/// Largest number of cells of a box (about 7 GB of state and scratch).
inline constexpr std::size_t k_max_cells = std::size_t{1} << 26;

/// The cells of a wind, without their place in the world.
struct Box {
    static constexpr Range k_cells_range{1.0, k_max_axis_cells, "cells"};
    static constexpr Range k_cell_size_range{1e-6, 1e6, "m"};

    /// [cells] Each component 1 to 2048, default (32, 16, 32). Cells along x, y, z; odd sizes too. Wind is mostly horizontal.
    glm::ivec3 cells{32, 16, 32};
    /// [m] 1e-6 to 1e6, default 1. Edge of a cell.
    float cell_size = 1.0f;
    /// Boundary conditions of the six faces.
    Boundaries boundaries{};
    /// Heights of rows of unequal thickness; null: all are cell_size thick.
    std::shared_ptr<const RowTable> rows{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("cells", &Box::cells, k_cells_range, "Cells along x, y, z; odd sizes too. Wind is mostly horizontal."),
            Setting("cell_size", &Box::cell_size, k_cell_size_range, "Edge of a cell."),
            Setting("boundaries", &Box::boundaries, "Boundary conditions of the six faces."),
            Setting("rows", &Box::rows, "Heights of rows of unequal thickness; null: all are cell_size thick.", k_not_stored),
        };
    }

    /// [m] From the low corner to the high one.
    [[nodiscard]] glm::vec3 size() const {
        const glm::vec3 size = cell_size * glm::vec3(cells);
        return rows ? glm::vec3(size.x, static_cast<float>(rows->top()), size.z) : size;
    }
    /// [m] Of a cell's centre from the low corner. Cells beyond the box too.
    [[nodiscard]] glm::vec3 centre(int i, int j, int k) const {
        glm::vec3 centre = cell_size * (glm::vec3(i, j, k) + 0.5f);
        if (rows)
            centre.y = static_cast<float>(rows->height(j));
        return centre;
    }
    /// [m] Of a place in cells, (i, j, k) + 1/2 at a cell's centre, from the low corner.
    [[nodiscard]] glm::vec3 metres(glm::vec3 place) const {
        const glm::vec3 metres = cell_size * place;
        return rows ? glm::vec3(metres.x, static_cast<float>(rows->height_at(static_cast<double>(place.y))), metres.z) : metres;
    }
    /// Cell size over the thickness of a row.
    [[nodiscard]] float row_scale(int j) const { return rows ? rows->scales()[static_cast<std::size_t>(j)] : 1.0f; }
    /// Volume of a cell in cubes of its size.
    [[nodiscard]] float volume(int j) const { return 1.0f / row_scale(j); }
    /// [m] Largest distance between two cells along an axis.
    [[nodiscard]] float coarsest() const { return rows && rows->coarsest() > cell_size ? rows->coarsest() : cell_size; }
    /// [m] Least distance between two cells, which bounds an explicit diffusion.
    [[nodiscard]] float finest() const { return rows && rows->finest() < cell_size ? rows->finest() : cell_size; }

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
[[nodiscard]] WINDROW_API Result<void> validate(const Box& box);
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Box& box);

} // namespace windrow
