// The classic stable-fluids step as game code does it at its best: what the solver's whole step is compared with.
//
//   u* = u(x - dt u(x)) (trilinear),   L p = div u*  by N Jacobi sweeps from zero,   u = u* - grad p
//
// First order in time; the error of the pressure grows with the grid. Values at cell centres; open boundaries with p = 0 and
// beyond them the ambient wind; a free-slip floor (y low). A broken or far position is clamped as in the solver, so that no
// address leaves the array; nothing more guards against NaN.
//
// Based on: Stam 1999, Stable Fluids, SIGGRAPH; Stam 2003, Real-Time Fluid Dynamics for Games.
#pragma once

#include "cases/reference/jacobi.h"
#include "cases/reference/kernels.h"
#include "fluid/cpu/aligned.h"
#include "fluid/parallel.h"
#include "fluid/simd.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace windrow::reference {

class StamStep {
  public:
    /// `cells` each >= 1, below 2^31 cells with a halo of 3 an axis; `cell_size` [m] > 0; `sweeps` >= 0 (games: 20 to 80).
    StamStep(glm::ivec3 cells, float cell_size, int sweeps = 40, ParallelFor parallel_for = {}, Simd simd = Simd::best);

    /// dt [s] >= 0.
    void step(float dt);

    /// [m/s] The field, dense, x fastest as box.h says, w unused; to read and to write, until the next step: ask again after
    /// it. The state itself has a halo, so each call unpacks it and the next step packs it: not for a timed loop.
    [[nodiscard]] std::span<glm::vec4> velocity();

    /// [m/s] The wind beyond the open boundaries; its vertical part is dropped, since the floor holds it back. Default still air.
    void set_ambient(glm::vec3 ambient);

    [[nodiscard]] glm::ivec3 cells() const { return cells_; }
    /// Bytes of all arrays that a step reads or writes.
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    void pack_plane(int k);
    void unpack_plane(int k);
    [[nodiscard]] StamTask task(float dt);
    /// First float of cell (0, j, k) in a padded array.
    [[nodiscard]] std::ptrdiff_t row(int j, int k) const;

    const Kernels& kernels_;
    glm::ivec3 cells_;
    float cell_size_;
    int sweeps_;
    ParallelFor parallel_for_;
    std::ptrdiff_t row_stride_, plane_stride_; ///< [floats]
    cpu::Buffer<float> velocity_;              ///< four floats a cell, with halo
    cpu::Buffer<float> advected_;              ///< the same shape
    cpu::Buffer<float> divergence_;            ///< dense, in units of h = 1
    Jacobi jacobi_;
    std::vector<glm::vec4> dense_; ///< what the caller sees
    bool touched_ = false;         ///< the caller may have changed `dense_`
};

} // namespace windrow::reference
