// The pressure equation by OpenVDB's own solver: conjugate gradients with incomplete Cholesky, on a sparse tree, in double.
//
// Based on: openvdb/tools/PoissonSolver.h (Hill & Cucka); Meijerink & van der Vorst 1977, Mathematics of Computation 31.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

namespace windrow::reference {

/// What lies outside the box.
enum class VdbOutside : std::uint8_t {
    zero_cells,     ///< phi = 0 in the first cells outside, on all six sides: `openvdb::tools::poisson::solve` as it comes.
    open_and_floor, ///< phi = 0 at the ghosts' centres, d phi/dy = 0 on the floor (y low): the equation of windrow::solve_poisson.
};

struct VdbOutcome {
    double seconds = 0.0;        ///< [s] of poisson::solve alone: its index tree and matrix, the iterations, the result's tree.
    double relative_error = 0.0; ///< max |rhs - L phi| / max |rhs|, as OpenVDB sees it
    int iterations = 0;
    bool converged = false;
};

/// Built where WINDROW_CASES_OPENVDB is 1. A dense box as a tree of leaves of 8^3 cells. OpenVDB's solver uses at most `threads`.
class VdbPoisson {
  public:
    VdbPoisson(glm::ivec3 cells, float cell_size, int threads = 1);
    ~VdbPoisson();
    VdbPoisson(const VdbPoisson&) = delete;
    VdbPoisson& operator=(const VdbPoisson&) = delete;

    /// Solves L phi = rhs [1/m^2 each], from zero, until max |rhs - L phi| <= tolerance * max |rhs|. Both dense, x fastest; they
    /// may be the same array. Only the solve is timed, not the copies into the tree and out of it.
    VdbOutcome solve(std::span<const float> rhs, std::span<float> phi, VdbOutside outside, double tolerance = 1e-3);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace windrow::reference
