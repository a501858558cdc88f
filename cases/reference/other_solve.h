// Solves of the pressure that a wind on the CPU can take in place of its direct one, for comparison: the rest of its step stays as it
// is. Iterations begin at zero in each step.
#pragma once

#include "cases/reference/jacobi.h"
#include "cases/reference/multigrid.h"
#include "fluid/cpu/workspace.h"
#include "fluid/wind.h"

#include <cstdint>

namespace windrow::reference {

enum class Pressure : std::uint8_t { direct, multigrid, jacobi80, jacobi40, jacobi20 };

/// Of Pressure::jacobi20 to jacobi80.
[[nodiscard]] inline int sweeps_of(Pressure pressure) {
    return pressure == Pressure::jacobi20 ? 20 : pressure == Pressure::jacobi40 ? 40 : 80;
}

/// V(2,2) cycles of Pressure::multigrid in a step.
inline constexpr int k_multigrid_cycles = 2;

class OtherSolve {
  public:
    /// For a wind without obstacles and volume sources.
    explicit OtherSolve(const Wind& wind);
    OtherSolve(const OtherSolve&) = delete;
    OtherSolve& operator=(const OtherSolve&) = delete;

    /// From the next step on, of the wind of the constructor. This outlives its last step. Wind::write_pressure knows only the direct
    /// solve.
    void exchange(Wind& wind, Pressure pressure);

  private:
    ParallelFor parallel_for_;
    Jacobi jacobi_;
    Multigrid multigrid_;
    cpu::Buffer<float> rhs_; ///< of Jacobi, dense
    cpu::PressureSolve by_jacobi_{}, by_multigrid_{};
    int sweeps_ = 0;
};

} // namespace windrow::reference
