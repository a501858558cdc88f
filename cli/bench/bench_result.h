// The figures that `windrow bench` finds.
#pragma once

#include "cli/bench/contest.h"
#include "cli/timings.h"

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace windrow::cli {

struct SchemeResult {
    const char* name;
    Spread step_ms{};
    std::array<Spread, k_stages.size() - 1> stages_ms{}; ///< the stages of k_stages without the last, the whole
    int loops = 0;                                       ///< parallel loops a step, and so barriers
    double bytes_per_cell = 0.0;                         ///< held
    double vs_copy16 = 0.0, vs_stam40 = 0.0;             ///< time of a step over that of a copy, of Stam's step
    float largest_cfl = 0.0f;
    int most_substeps = 0;
    bool slept = false;
};

struct SolverResult {
    Spread ms{};
    double residual = 0.0; ///< relative_residual
};

struct GridResult {
    glm::ivec3 cells{0};
    std::size_t rounds = 0;
    std::vector<SchemeResult> schemes{};
    Spread copy16_ms{}, stam40_ms{};
    SolverResult jacobi40{}, direct{};
    double jacobi40_gradient_error = 0.0; ///< against the direct solve
    double direct_vs_jacobi40 = 0.0;
    /// FFTW's solve runs on one thread, and so does the direct solve that it is compared with.
    std::optional<SolverResult> direct_one_thread{}, fftw{};
    double direct_vs_fftw = 0.0;
    std::optional<SolverResult> vdb{};
    std::string left_out{}; ///< why a method is missing, a sentence each
};

struct VolumesResult {
    int volumes = 0;
    Spread round_ms{}; ///< one step of all volumes
    double volumes_per_s = 0.0, volumes_per_s_core = 0.0;
    std::size_t bytes_per_volume = 0;
};

struct BenchResult {
    std::string device, compiler, commit, simd;
    int threads = 1;
    std::vector<GridResult> grids;
    std::vector<VolumesResult> volumes;
};

} // namespace windrow::cli
