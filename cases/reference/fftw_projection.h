// The pressure equation by fast transforms of FFTW: exact as the solver's direct solve is, and what most texts would take.
//
//   L phi = rhs,  L the 7-point Laplacian [1/m^2],  phi = 0 at the ghosts of open boundaries,  d phi/dy = 0 on the floor (y low)
//
// Open at both ends (x, z), the eigenvectors are sin(pi (k + 1) (i + 1) / (n + 1)), FFTW's RODFT00, its own inverse. Floor below
// and open above (y) FFTW has no transform for: a tridiagonal system of each pair of modes.
//
// Based on: Swarztrauber 1977, The Methods of Cyclic Reduction, Fourier Analysis and the FACR Algorithm, SIAM Review 19;
// Frigo & Johnson 2005, The Design and Implementation of FFTW3, Proceedings of the IEEE 93.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

namespace windrow::reference {

/// One thread. Not to be created in two threads at once: FFTW's planner is shared.
class FftwProjection {
  public:
    /// Plans with FFTW_MEASURE, which takes up to some seconds. `cells` each >= 1; `cell_size` [m] > 0. Null in a program that does
    /// not link windrow_fftw: FFTW is under the GPL, and what is installed is not.
    [[nodiscard]] static std::unique_ptr<FftwProjection> create(glm::ivec3 cells, float cell_size);
    virtual ~FftwProjection() = default;

    /// Dense, x fastest, aligned as FFTW wishes: write the right-hand side here, call solve, read phi.
    [[nodiscard]] virtual std::span<float> values() = 0;
    virtual void solve() = 0;
};

} // namespace windrow::reference
