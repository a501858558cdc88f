// The hot loops of the reference methods as a table of function pointers, one table a SIMD level: the same text (level.inl and
// what it includes) compiled once a level and chosen at run time, as the solver's own kernels are. So the yardstick runs on the
// instructions that the solver runs on, and a program that holds it starts on any machine.
//
// Everything here is plain data, and the texts call no inline function of the standard library or of GLM: the linker could hand
// one that was compiled for AVX-512 to the rest of the program.
#pragma once

#include "fluid/simd.h"

#include <cstddef>
#include <cstdint>

namespace windrow::bench {

/// One sweep of jacobi.h. Rows of `now` and `next` have a ghost at each end.
struct JacobiTask {
    int cells[3];
    std::size_t pitch;   ///< [floats] from one row of `now` and `next` to the next
    const float* source; ///< dense, in units of h = 1
    const float* now;    ///< cell (0, 0, 0); so is `next`
    float* next;
};

/// The arrays of stam.h; pointers at cell (0, 0, 0).
struct StamTask {
    int cells[3];
    std::ptrdiff_t row_stride, plane_stride; ///< [floats] of velocity and advected
    float* velocity;                         ///< four floats a cell, with halo
    float* advected;                         ///< the same shape
    float* divergence;                       ///< dense, in units of h = 1
    const float* pressure;                   ///< as JacobiTask::now
    std::ptrdiff_t pressure_pitch;           ///< [floats]
    float cells_per_speed;                   ///< [s/m] dt / h
};

struct Kernels {
    void (*jacobi_plane)(const JacobiTask&, int plane);
    void (*advect_plane)(const StamTask&, int plane);
    void (*divergence_plane)(const StamTask&, int plane);
    void (*gradient_plane)(const StamTask&, int plane); ///< the floor's ghost row included
    void (*mirror_floor)(const StamTask&, int plane);
    void (*multiply)(float* values, const float* factors, std::size_t count); ///< values *= factors
};

/// The kernels of a level that this machine runs (windrow::runs).
[[nodiscard]] const Kernels& kernels_for(Simd level);

namespace baseline {
extern const Kernels k_kernels;
}
namespace avx2 {
extern const Kernels k_kernels;
}
namespace avx512 {
extern const Kernels k_kernels;
}

} // namespace windrow::bench
