// Multigrid for L phi = rhs on a box with any sides: the iteration that converges at a rate which does not depend on the size of
// the grid, and so the fairest rival of the direct solve.
//
//   V(2,2) from zero: two sweeps, the mean of the residual over 2 x 2 x 2 cells goes to the coarser grid, what comes back is
//   interpolated trilinearly and added, two sweeps; down to a single cell. Sweeps are Jacobi's, with the two weights of the
//   Chebyshev polynomial that is smallest over the waves which the coarser grid cannot hold, 1/d to 2 times the diagonal in d
//   dimensions: they damp those waves to 0.34 in a pair where two sweeps of the best single weight leave 0.51.
//
// Values at cell centres. Coarse operators are finite volumes on the coarse cells; the last coarse cell of an odd axis holds
// three cells, so that no cell ever is twice as wide as another along its axis. phi = 0 at the ghosts' centres beyond open boundaries, d phi/dn = 0 on walls.
// Where no side is open, the mean of phi is what it comes to be.
//
// Based on: Brandt 1977, Mathematics of Computation 31; Trottenberg, Oosterlee & Schueller 2001, Multigrid, chapter 2; Adams,
// Brezina, Hu & Tuminaro 2003, Journal of Computational Physics 188 (Chebyshev smoothing).
#pragma once

#include "cases/reference/kernels.h"
#include "fluid/box.h"
#include "fluid/cpu/aligned.h"
#include "fluid/parallel.h"
#include "fluid/simd.h"

#include <array>
#include <cstddef>
#include <vector>

namespace windrow::reference {

class Multigrid {
  public:
    explicit Multigrid(const Box& box, Simd simd = Simd::best);

    /// Row (j, k) of the right-hand side, to be written before solve; in units of h = 1.
    [[nodiscard]] float* source_row(int j, int k) { return levels_[0].source.data() + place(j, k); }
    /// phi after `cycles` from zero.
    void solve(int cycles, const ParallelFor& parallel_for);
    [[nodiscard]] const float* row(int j, int k) const { return levels_[0].now.data() + place(j, k); }
    /// [floats] From one row to the next.
    [[nodiscard]] std::ptrdiff_t pitch() const { return levels_[0].pitch; }
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    /// One axis of a level. Widths are in cells of the finest level.
    struct Axis {
        std::vector<double> width, diagonal_parts;
        std::vector<float> low, high; ///< weights of the neighbours
        std::vector<int> kind;        ///< place among diagonal_parts
        // To the next coarser level, a cell each.
        std::vector<float> share;             ///< in the mean of the coarse cell that holds it
        std::vector<float> parent, neighbour; ///< weights of that coarse cell and of the one beside
        std::vector<int> neighbour_cell;      ///< which that is
    };
    struct Level {
        int cells[3];
        bool periodic[3];
        std::ptrdiff_t pitch;
        std::array<Axis, 3> axes;
        cpu::Buffer<float> source, now, next;
        std::vector<float> diagonal, inverse;
        std::array<float, 2> weights; ///< of a pair of sweeps

        [[nodiscard]] MultigridLevel task() const;
    };

    static Axis make_axis(std::vector<double> width, const Boundaries& boundaries, int axis);
    static void connect(Axis& fine, const Axis& coarse, const Boundaries& boundaries, int axis);
    static Level make_level(std::array<Axis, 3> axes, const Boundaries& boundaries);
    [[nodiscard]] std::size_t place(int j, int k) const;

    void cycle(std::size_t level, bool from_zero, const ParallelFor& parallel_for);
    void sweep(Level& level, bool from_zero, float weight, const ParallelFor& parallel_for);
    void restrict_residual(const Level& fine, Level& coarse, const ParallelFor& parallel_for);
    void add_correction(Level& fine, const Level& coarse, const ParallelFor& parallel_for);

    const Kernels& kernels_;
    std::vector<Level> levels_; ///< fine to coarse
};

} // namespace windrow::reference
