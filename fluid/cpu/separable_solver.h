// Direct solution of (L - shift) x = d on a box by fast diagonalisation.
//
// L is the dimensionless 7-point Laplacian (sum of second differences, h = 1) with a closed-form basis along x and z
// (basis.h). Transform along x, transform along z, one tridiagonal system in y for each pair of modes, transform back:
//   1 (planes)  X: rows times the x basis
//   2 (blocks)  Z, tridiagonal, Z back on k_lanes columns at a time, all in one task's cache
//   3 (planes)  X back
// Three parallel loops; about 4 n floating operations a cell and axis (half of it where the ends of an axis are alike). Where L
// is singular (no end fixes the value) the mean of d is dropped and x has mean 0.
//
// Based on: Lynch, Rice & Thomas 1964, "Direct solution of partial difference equations by tensor product methods",
// Numerische Mathematik 6; Sherman & Morrison 1950 for periodic y.
//
// Memory of `data` and of the scratch, in floats (x fastest):
//   data     [cells.z][cells.y][pitch]                        rows padded to k_lanes; modes in place of cells after stage 1
//   scratch  [pitch / k_lanes][block_size]                    blocks of modes; split rows of a plane in stages 1 and 3
//   block    [cells.z][cells.y + 1][k_lanes], then one line of each mode: [cells.z][k_lanes]
#pragma once

#include "fluid/api.h"
#include "fluid/cpu/aligned.h"
#include "fluid/cpu/kernels/kernels.h"
#include "fluid/grid/columns.h"
#include "fluid/parallel.h"

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace windrow::cpu {

class SeparableSolver {
  public:
    using Ends = std::array<std::array<EndRule, 2>, 3>;

    SeparableSolver(glm::ivec3 cells, const Ends& ends, const Kernels& kernels, ColumnRows rows = {});

    /// Floats from row to row of `data`.
    [[nodiscard]] int pitch() const { return pitch_; }
    /// Floats that `data` must hold.
    [[nodiscard]] std::size_t buffer_size() const;
    /// Floats that the scratch must hold; more than buffer_size().
    [[nodiscard]] std::size_t scratch_size() const;
    /// True where L has no inverse.
    [[nodiscard]] bool singular() const { return singular_; }

    /// Recomputes the pivots for another shift >= 0; no-op for the same one. Allocates nothing.
    void set_shift(double shift, const ParallelFor& parallel_for);
    /// Solves in place; values beyond a row's cells are ignored and overwritten.
    void solve(float* data, float* scratch, const ParallelFor& parallel_for) const;

    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    /// One axis' basis as the products read it: [mode][cell] and transposed, each row padded to k_lanes.
    struct Matrix {
        Matrix(const std::vector<double>& values, int size);
        Buffer<float> forward, backward; ///< forward [cell][mode] for rows, backward [mode][cell]
        int size = 0, stride = 0;
    };

    [[nodiscard]] std::ptrdiff_t mode_stride() const; ///< floats from mode to mode of a block
    [[nodiscard]] std::ptrdiff_t block_size() const;
    void factor_block(int block);
    void solve_block(int block, float* data, float* scratch) const;
    void rows_to_modes(int plane, float* data, float* scratch) const;
    void modes_to_rows(int plane, float* data, float* scratch) const;
    [[nodiscard]] double eigenvalue_x(int lane) const;

    glm::ivec3 cells_;
    Ends ends_;
    const Kernels* kernels_;
    AxisBasis basis_x_, basis_z_;
    Matrix x_even_, x_odd_, z_even_, z_odd_;
    int odd_offset_ = 0; ///< lane of the first odd mode of x
    int pitch_ = 0;
    ColumnRows rows_;
    std::vector<float> scale_in_, scale_out_; ///< by row: s e, s; empty where all rows are equal
    bool cyclic_ = false;                     ///< periodic y
    bool singular_ = false;
    double shift_ = -1.0;
    Buffer<float> pivots_;         ///< [pitch / k_lanes][cells.z][cells.y][k_lanes]
    Buffer<float> cyclic_vectors_; ///< the same; periodic y only
    Buffer<float> cyclic_factors_; ///< [blocks][cells.z][2][k_lanes]
};

} // namespace windrow::cpu
