// One SIMD level: every kernel compiled into the namespace of its level, and the table that names them.
#include "cases/reference/kernels.h"

namespace windrow::reference::WINDROW_LEVEL {
namespace {
#include "cases/reference/jacobi_planes.inl"
#include "cases/reference/multigrid_planes.inl"
#include "cases/reference/stam_planes.inl"

void solve_columns(float* plane, const float* pivots, float scale, int row, int rows) {
    for (int i = 0; i < row; ++i)
        plane[i] *= scale * pivots[i];
    for (int j = 1; j < rows; ++j) {
        float* const x = plane + j * row;
        const float *const before = x - row, *const pivot = pivots + j * row;
        WINDROW_INDEPENDENT
        for (int i = 0; i < row; ++i)
            x[i] = pivot[i] * (scale * x[i] - before[i]);
    }
    for (int j = rows - 2; j >= 0; --j) {
        float* const x = plane + j * row;
        const float *const after = x + row, *const pivot = pivots + j * row;
        WINDROW_INDEPENDENT
        for (int i = 0; i < row; ++i)
            x[i] -= pivot[i] * after[i];
    }
}
} // namespace

const Kernels k_kernels = {jacobi_plane, jacobi_plane_any_sides, multigrid_smooth, multigrid_restrict, multigrid_prolong,
                           advect_plane, divergence_plane,       gradient_plane,   mirror_floor,       solve_columns};

} // namespace windrow::reference::WINDROW_LEVEL
