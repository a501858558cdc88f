// Drag deposits over the cells of a box.
//
// A cell of volume V that holds the part p of a deposit of drag area A takes c = A p / V [1/m]. Parts are overlaps of boxes, exact
// to rounding, so that they add up to 1 where all of a deposit is in the box. They are found from the number of a cell in the world:
// a box that moves by whole cells finds the same.
#pragma once

#include "api.h"
#include "drag_deposit.h"
#include "window.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow::detail {

/// Cells low <= i < high of a box, along each axis.
struct CellRange {
    glm::ivec3 low{0}, high{0};
    [[nodiscard]] bool empty() const { return low.x >= high.x || low.y >= high.y || low.z >= high.z; }
    /// Grows to hold another one.
    void add(const CellRange& other);
};

/// Sum of c over deposits, in units of 2^-32 / m: integers add up to the same in any order, and what was added can be taken out.
using DragSum = std::int64_t;
/// [1/m] Most that one deposit adds to a cell: air is at rest there within millimetres.
inline constexpr double k_most_drag = 1000.0;
inline constexpr double k_drag_unit = 1.0 / 4294967296.0;

/// Where cells are: the box, and the axes along which it is periodic. There a deposit stands in each period.
struct DragLattice {
    Window window{};
    glm::bvec3 repeats{false};
};

/// [m] Square around a deposit along x and z, no smaller than the cells that it is spread over: its middle, and half of its width.
struct DragSquare {
    glm::dvec3 centre{0.0};
    double half = 0.0;
};
[[nodiscard]] DragSquare square_around(const DragDeposit& deposit, float cell_size);

/// Adds c of a deposit, or takes it out, in the cells of a range; the sums are those of the whole box. Returns the cells that it meets.
CellRange add_drag(const DragDeposit& deposit, const DragLattice& lattice, const CellRange& in, bool out,
                   std::span<DragSum> sums);
/// `velocity`: of all cells of the box [m/s].
[[nodiscard]] DragForce drag_force(const DragDeposit& deposit, const DragLattice& lattice, std::span<const glm::vec4> velocity);

} // namespace windrow::detail
