// The hot loops of the reference methods as a table of function pointers, one table a SIMD level: the same text (level.inl and
// what it includes) compiled once a level and chosen at run time, as the solver's own kernels are. So the yardstick runs on the
// instructions that the solver runs on, and a program that holds it starts on any machine.
//
// Everything here is plain data, and the texts call no inline function of the standard library or of GLM: the linker could hand
// one that was compiled for AVX-512 to the rest of the program.
#pragma once

#include "fluid/simd.h"

#include <cstddef>
#include <cstdint>

/// Before a loop: no iteration reads what another writes, so that it may be vectorised without a check.
#if defined(__clang__)
#define WINDROW_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define WINDROW_INDEPENDENT _Pragma("GCC ivdep")
#endif

namespace windrow::reference {

/// Most cells of a row, as k_max_axis_cells of fluid/box.h, which a level's file must not include.
inline constexpr int k_longest_row = 2048;

/// One sweep of jacobi.h. Rows of `now` and `next` have a ghost at each end.
struct JacobiTask {
    int cells[3];
    std::size_t pitch;   ///< [floats] from one row of `now` and `next` to the next
    const float* source; ///< dense, in units of h = 1
    const float* now;    ///< cell (0, 0, 0); so is `next`
    float* next;
    // Read by jacobi_plane_any_sides alone; else the sides are open over a floor.
    bool periodic[3];
    float ghost[3][2]; ///< [axis][end]: what lies beyond an end is this times the cell inside; not where the axis is periodic
    float weight;      ///< of the sum of neighbours
};

/// The operator of one level of multigrid.h: L p = sum over the axes of low (p_below - p) + high (p_above - p), and what open
/// ends add to the diagonal. Rows have a ghost at each end, which only periodic rows read.
struct MultigridLevel {
    int cells[3];
    bool periodic[3];
    std::ptrdiff_t pitch;     ///< [floats] from row to row of all fields of the level
    const float* source;      ///< right-hand side, cell (0, 0, 0)
    const float* low[3];      ///< [axis][cell] weight of the neighbour below
    const float* high[3];     ///< and of that above
    const float* diagonal;    ///< sum of the weights: rows for each kind of (y, z)
    const float* inverse;     ///< 1 / diagonal, the same shape; 0 where that is 0
    const int* kind[2];       ///< [y or z][cell] which kind a cell is of
    int kinds_of_z;           ///< row of kinds (a, b) is a * kinds_of_z + b
    std::ptrdiff_t row_pitch; ///< [floats] from kind to kind
};

/// next = now + weight / diagonal * (L now - source)
struct MultigridSmooth {
    MultigridLevel level;
    const float* now; ///< null: zero
    float* next;
    float weight;
};

/// coarse = mean of source - L now over the cells that a coarse cell holds: two along each axis, the last one three or one where
/// the number is odd.
struct MultigridRestrict {
    MultigridLevel fine;
    const float* now;
    int coarse_cells[3];
    std::ptrdiff_t coarse_pitch;
    float* coarse;
    const float* share[3]; ///< [axis][fine cell] in the mean
};

/// now += the coarse field, interpolated
struct MultigridProlong {
    int cells[3];
    bool periodic_x;
    std::ptrdiff_t pitch;
    float* now;
    int coarse_cells[3];
    std::ptrdiff_t coarse_pitch;
    const float* coarse;
    const float* parent[3];    ///< [axis][fine cell] weight of the coarse cell that holds it
    const float* neighbour[3]; ///< and of the one beside that
    const int* neighbour_cell[3];
};

/// The arrays of stam.h; pointers at cell (0, 0, 0).
struct StamTask {
    int cells[3];
    std::ptrdiff_t row_stride, plane_stride; ///< [floats] of velocity and advected
    float* velocity;                         ///< four floats a cell, with halo
    float* advected;                         ///< the same shape
    float* divergence;                       ///< dense, in units of h = 1
    const float* pressure;                   ///< as JacobiTask::now
    std::ptrdiff_t pressure_pitch;           ///< [floats]
    float cells_per_speed;                   ///< [s/m] dt / h
};

struct Kernels {
    void (*jacobi_plane)(const JacobiTask&, int plane);
    void (*jacobi_plane_any_sides)(const JacobiTask&, int plane);
    void (*multigrid_smooth)(const MultigridSmooth&, int plane);
    void (*multigrid_restrict)(const MultigridRestrict&, int coarse_plane);
    void (*multigrid_prolong)(const MultigridProlong&, int plane);
    void (*advect_plane)(const StamTask&, int plane);
    void (*divergence_plane)(const StamTask&, int plane);
    void (*gradient_plane)(const StamTask&, int plane); ///< the floor's ghost row included
    void (*mirror_floor)(const StamTask&, int plane);
    /// Solves x[j-1] + b[j] x[j] + x[j+1] = scale d[j] for all `row` columns of a plane, in place; pivots 1 / (b[j] - pivot[j-1]).
    void (*solve_columns)(float* plane, const float* pivots, float scale, int row, int rows);
};

/// The kernels of a level that this machine runs (windrow::runs).
[[nodiscard]] const Kernels& kernels_for(Simd level);

namespace baseline {
extern const Kernels k_kernels;
}
namespace avx2 {
extern const Kernels k_kernels;
}
namespace avx512 {
extern const Kernels k_kernels;
}

} // namespace windrow::reference
