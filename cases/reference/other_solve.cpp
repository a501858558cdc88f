#include "cases/reference/other_solve.h"

#include "fluid/wind_state.h"

namespace windrow::reference {

OtherSolve::OtherSolve(const Wind& wind)
    : parallel_for_(wind.config().parallel_for), jacobi_(wind.box(), wind.config().simd),
      multigrid_(wind.box(), wind.config().simd), rhs_(wind.box().cell_count()) {
    by_jacobi_ = {.rhs = rhs_.data(), .pitch = wind.box().cells.x, .solve = [this]() -> cpu::Potential {
                      jacobi_.solve(rhs_, sweeps_, parallel_for_);
                      return {jacobi_.row(0, 0), static_cast<int>(jacobi_.pitch())};
                  }};
    const int pitch = static_cast<int>(multigrid_.pitch());
    by_multigrid_ = {.rhs = multigrid_.source_row(0, 0), .pitch = pitch, .solve = [this, pitch]() -> cpu::Potential {
                         multigrid_.solve(k_multigrid_cycles, parallel_for_);
                         return {multigrid_.row(0, 0), pitch};
                     }};
}

void OtherSolve::exchange(Wind& wind, Pressure pressure) {
    sweeps_ = sweeps_of(pressure);
    wind.state().cells.work.state().other_solve = pressure == Pressure::direct      ? nullptr
                                                  : pressure == Pressure::multigrid ? &by_multigrid_
                                                                                    : &by_jacobi_;
}

} // namespace windrow::reference
