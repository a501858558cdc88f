// One SIMD level: every kernel compiled into the namespace of its level, and the table of these kernels.
#include "fluid/cpu/kernels/kernels.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace windrow::cpu::WINDROW_LEVEL {
namespace {
#include "fluid/cpu/kernels/lanes.inl"
// Formulas of shaders;
#include "fluid/cpu/kernels/shader_text.inl"
// All others use the lanes.
#include "fluid/cpu/kernels/advect.inl"
#include "fluid/cpu/kernels/advect_scalar.inl"
#include "fluid/cpu/kernels/fold.inl"
#include "fluid/cpu/kernels/pad.inl"
#include "fluid/cpu/kernels/product.inl"
#include "fluid/cpu/kernels/stencils.inl"
#include "fluid/cpu/kernels/stress.inl"
#include "fluid/cpu/kernels/survey.inl"
#include "fluid/cpu/kernels/tridiagonal.inl"
// Rows are those of the stress;
#include "fluid/cpu/kernels/drag.inl"
// Queries of points: remainders;
#include "fluid/cpu/kernels/wrap.inl"
// groups of points;
#include "fluid/cpu/kernels/points.inl"
// what is asked of them; and textures.
#include "fluid/cpu/kernels/ambient_points.inl"
#include "fluid/cpu/kernels/box_points.inl"
#include "fluid/cpu/kernels/halves.inl"
} // namespace

const Kernels k_kernels = {
    WINDROW_LEVEL_NAME,
    pad_plane,
    {advect_plane<Linear>, advect_plane<Cubic>, advect_plane<Cubic32>},
    {advect_scalar_plane<Linear>, advect_scalar_plane<Cubic>, advect_scalar_plane<Cubic32>},
    divergence_plane,
    divergence_squares,
    gradient_plane,
    diffuse_plane,
    stress_plane,
    deepen_lee,
    drag_departs,
    drag_arrives,
    multiply,
    tridiagonal,
    fold_lines,
    unfold_lines,
    fold_row,
    unfold_row,
    survey,
    point_list,
    ambient_list,
    felt_list,
    place_point,
    blend_corners,
    halve_vectors,
    halve_axis,
};

} // namespace windrow::cpu::WINDROW_LEVEL
