// One SIMD level: every kernel compiled into the namespace of its level, and the table that names them.
#include "tests/bench/reference/kernels.h"

namespace windrow::bench::WINDROW_LEVEL {
namespace {
#include "tests/bench/reference/jacobi_plane.inl"
#include "tests/bench/reference/jacobi_sides.inl"
#include "tests/bench/reference/multigrid_planes.inl"
#include "tests/bench/reference/stam_planes.inl"

void multiply(float* values, const float* factors, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n)
        values[n] *= factors[n];
}
} // namespace

const Kernels k_kernels = {jacobi_plane, jacobi_plane_any_sides, multigrid_smooth, multigrid_restrict, multigrid_prolong,
                           advect_plane, divergence_plane,       gradient_plane,   mirror_floor,       multiply};

} // namespace windrow::bench::WINDROW_LEVEL
