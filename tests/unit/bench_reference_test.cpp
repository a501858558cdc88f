// The methods that the benchmarks compare with do what they claim: a yardstick that is wrong is worth nothing.
#include "cases/jets.h"
#include "cases/reference/copy.h"
#include "cases/reference/fftw_projection.h"
#include "cases/reference/jacobi.h"
#include "cases/reference/residual.h"
#include "cases/reference/stam.h"
#include "cases/reference/voxel_step.h"
#include "fluid/operators.h"
#include "fluid/thread_pool.h"
#include "fluid/wind.h"
#if WINDROW_CASES_OPENVDB
#include "cases/reference/vdb_poisson.h"
#endif

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace windrow::reference {
namespace {

constexpr glm::ivec3 k_cells{24, 16, 40}; // rows that end within a block of lanes
constexpr float k_dt = static_cast<float>(cases::k_bench_dt);

std::vector<Simd> levels() {
    std::vector<Simd> all;
    for (const Simd level : {Simd::baseline, Simd::avx2, Simd::avx512})
        if (runs(level))
            all.push_back(level);
    return all;
}

/// A smooth flow over the floor that goes over into the mean wind at the open boundaries.
std::vector<glm::vec4> waves(const Box& box) {
    constexpr float k_pi = std::numbers::pi_v<float>;
    std::vector<glm::vec4> velocity(box.cell_count());
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i) {
                const glm::vec3 at = k_pi * (glm::vec3(i, j, k) + 0.5f) / glm::vec3(box.cells);
                const float within = std::pow(std::sin(at.x) * std::cos(0.5f * at.y) * std::sin(at.z), 2.0f);
                const glm::vec3 wave(std::sin(2.0f * at.z), std::sin(at.y), std::cos(2.0f * at.x));
                velocity[box.index(i, j, k)] = glm::vec4(cases::k_bench_ambient + 8.0f * within * wave, 0.0f);
            }
    return velocity;
}

float largest_difference(std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
    float most = 0.0f;
    for (std::size_t n = 0; n < a.size(); ++n)
        for (int axis = 0; axis < 3; ++axis)
            most = std::max(most, std::abs(a[n][axis] - b[n][axis]));
    return most;
}

std::vector<glm::vec4> after_stam(const Box& box, std::span<const glm::vec4> flow, int sweeps, Simd level, ParallelFor loop = {},
                                  float dt = k_dt) {
    StamStep stam(box.cells, box.cell_size, sweeps, loop, level);
    stam.set_ambient(cases::k_bench_ambient);
    std::copy(flow.begin(), flow.end(), stam.velocity().begin());
    stam.step(dt);
    return {stam.velocity().begin(), stam.velocity().end()};
}

double divergence_rms(const Box& box, std::span<const glm::vec4> velocity) {
    auto work = Workspace::create({.box = box});
    std::vector<float> result(box.cell_count());
    divergence(*work, velocity, result);
    double sum = 0.0;
    for (const float value : result)
        sum += static_cast<double>(value) * value;
    return std::sqrt(sum / static_cast<double>(result.size()));
}

/// The direct solve and its right-hand side.
struct SolvedBox {
    std::vector<float> rhs, phi;
};
SolvedBox solve(const Box& box) {
    auto work = Workspace::create({.box = box, .ambient = cases::k_bench_ambient});
    SolvedBox solved{std::vector<float>(box.cell_count()), {}};
    divergence(*work, cases::jets(box), solved.rhs);
    solved.phi = solved.rhs;
    solve_poisson(*work, solved.phi);
    return solved;
}

float largest(std::span<const float> values) {
    float most = 0.0f;
    for (const float value : values)
        most = std::max(most, std::abs(value));
    return most;
}

[[maybe_unused]] float largest_difference(std::span<const float> a, std::span<const float> b) { // by FFTW's and OpenVDB's tests
    float most = 0.0f;
    for (std::size_t n = 0; n < a.size(); ++n)
        most = std::max(most, std::abs(a[n] - b[n]));
    return most;
}

// Without obstacles it is the tuned step, whose time pareto gives it.
TEST(BenchReference, VoxelStepWithoutSolidsIsStamsStep) {
    const Box box{.cells = k_cells, .cell_size = 0.5f, .boundaries = Boundaries::open_over_floor()};
    const auto flow = waves(box);
    VoxelStep plain(box.cells, box.cell_size, 20, cases::k_bench_ambient, [](glm::ivec3) { return false; });
    plain.set_velocity(flow);
    plain.step(k_dt);
    EXPECT_LE(largest_difference(plain.velocity(), after_stam(box, flow, 20, Simd::best)), 1e-5f);
    EXPECT_GT(largest_difference(plain.velocity(), flow), 0.5f);
}

// No air crosses a face to a solid cell, and a wind has to go around.
TEST(BenchReference, VoxelStepGoesAroundSolids) {
    const Box box{.cells = k_cells, .cell_size = 0.5f, .boundaries = Boundaries::open_over_floor()};
    const auto is_solid = [](glm::ivec3 cell) { return cell.x >= 9 && cell.x < 14 && cell.y < 7 && cell.z >= 16 && cell.z < 24; };
    VoxelStep step(box.cells, box.cell_size, 40, {6.0f, 0.0f, 0.0f}, is_solid);
    step.set_velocity(std::vector<glm::vec4>(box.cell_count(), {6.0f, 0.0f, 0.0f, 0.0f}));
    for (int n = 0; n < 10; ++n)
        step.step(k_dt);
    const auto at = [&](int x, int y, int z) { return step.velocity()[box.index(x, y, z)]; };
    EXPECT_EQ(at(8, 3, 20).x, 0.0f);
    EXPECT_EQ(at(11, 7, 20).y, 0.0f);
    EXPECT_EQ(at(11, 3, 20), glm::vec4(0.0f));
    EXPECT_GT(at(11, 8, 20).x, 6.5f);
    EXPECT_LT(at(8, 3, 15).z, -0.5f);
}

TEST(BenchReference, CopyCopies) {
    const Box box = cases::bench_box({5, 3, 7});
    const auto from = cases::jets(box);
    std::vector<glm::vec4> to(from.size());
    copy_cells(box.cells, from, to, {});
    EXPECT_EQ(largest_difference(from, to), 0.0f);
}

TEST(BenchReference, StamKeepsAUniformWindToTheBit) {
    for (const glm::ivec3 cells : {glm::ivec3(1), glm::ivec3(3, 2, 5), k_cells}) {
        const Box box = cases::bench_box(cells);
        const std::vector<glm::vec4> uniform(box.cell_count(), glm::vec4(cases::k_bench_ambient, 0.0f));
        for (const Simd level : levels())
            EXPECT_EQ(largest_difference(after_stam(box, uniform, 40, level), uniform), 0.0f) << name_of(level);
    }
}

TEST(BenchReference, StamLeavesLessDivergenceWithMoreSweeps) {
    const Box box = cases::bench_box(k_cells);
    const auto flow = waves(box);
    double last = divergence_rms(box, after_stam(box, flow, 0, Simd::best));
    for (const int sweeps : {5, 20, 80}) {
        const double now = divergence_rms(box, after_stam(box, flow, sweeps, Simd::best));
        EXPECT_LT(now, last) << sweeps;
        last = now;
    }
}

/// [m/s] How far Stam's step, its pressure iterated to the end, lies from the library's own scheme with the same interpolation.
float off_the_library(float dt, float& change) {
    const Box box = cases::bench_box(k_cells);
    const auto flow = waves(box);
    auto wind = Wind::create({.cells = box.cells,
                              .boundaries = box.boundaries,
                              .ambient = cases::k_bench_ambient,
                              .viscosity = 0.0f,
                              .relaxation_time = 0.0f,
                              .scheme = Scheme::stable_fluids,
                              .interpolation = Interpolation::linear});
    if (!wind || !wind->set_velocity(flow))
        return INFINITY;
    wind->step(dt);
    change = largest_difference(wind->field(), flow);
    return largest_difference(after_stam(box, flow, 3000, Simd::best, {}, dt), wind->field());
}

// What is left between the two is their backtrace, straight here and bent there: a difference of dt^2.
TEST(BenchReference, StamIsTheLibrarysStableFluidsButForTheBentBacktrace) {
    float change = 0.0f;
    const float off = off_the_library(k_dt, change);
    EXPECT_GT(change, 0.5f) << "the step does something [m/s]";
    EXPECT_LT(off, 5e-3f * change);
    EXPECT_LT(off_the_library(0.5f * k_dt, change), 0.35f * off);
}

TEST(BenchReference, StamIsTheSameOnAllThreadsAndLevels) {
    const Box box = cases::bench_box(k_cells);
    const auto flow = waves(box);
    ThreadPool pool(3);
    const auto one = after_stam(box, flow, 40, Simd::best);
    EXPECT_EQ(largest_difference(after_stam(box, flow, 40, Simd::best, pool.parallel_for()), one), 0.0f);
    for (const Simd level : levels())
        EXPECT_LT(largest_difference(after_stam(box, flow, 40, level), one), 1e-4f) << name_of(level);
}

TEST(BenchReference, StamKeepsBrokenAirInsideItsArrays) {
    const Box box = cases::bench_box(k_cells);
    auto flow = waves(box);
    flow[7].x = std::numeric_limits<float>::quiet_NaN();
    flow[99].y = std::numeric_limits<float>::infinity();
    flow[200].z = -1e30f;
    for (const Simd level : levels())
        static_cast<void>(after_stam(box, flow, 2, level)); // the sanitizers watch
}

TEST(BenchReference, JacobiComesToTheDirectSolve) {
    for (const glm::ivec3 cells : {glm::ivec3(1), glm::ivec3(3, 2, 5), glm::ivec3(20, 9, 17)}) {
        const Box box = cases::bench_box(cells);
        const SolvedBox solved = solve(box);
        for (const Simd level : levels()) {
            Jacobi jacobi(cells, level);
            jacobi.solve(solved.rhs, 4000, {});
            float off = 0.0f;
            for (int k = 0; k < cells.z; ++k)
                for (int j = 0; j < cells.y; ++j)
                    for (int i = 0; i < cells.x; ++i)
                        off = std::max(off, std::abs(jacobi.row(j, k)[i] - solved.phi[box.index(i, j, k)]));
            EXPECT_LE(off, 1e-4f * largest(solved.phi)) << name_of(level) << " " << cells.x;
        }
    }
}

TEST(BenchReference, ResidualIsThatOfTheSolution) {
    const Box box = cases::bench_box(k_cells);
    const SolvedBox solved = solve(box);
    const PressureAt exact = [&](int i, int j, int k) { return static_cast<double>(solved.phi[box.index(i, j, k)]); };
    const PressureAt none = [](int, int, int) { return 0.0; };
    EXPECT_LT(relative_residual(box, solved.rhs, exact), 1e-5);
    EXPECT_DOUBLE_EQ(relative_residual(box, solved.rhs, none), 1.0);
    EXPECT_DOUBLE_EQ(relative_gradient_error(box, none, exact), 1.0);
}

TEST(BenchReference, FftwIsTheDirectSolveButForRounding) {
    for (const glm::ivec3 cells : {glm::ivec3(1), glm::ivec3(3, 2, 5), k_cells}) {
        const Box box = cases::bench_box(cells);
        const SolvedBox solved = solve(box);
        const auto fftw = FftwProjection::create(cells, box.cell_size);
        if (!fftw)
            GTEST_SKIP() << "FFTW is not linked";
        std::copy(solved.rhs.begin(), solved.rhs.end(), fftw->values().begin());
        fftw->solve();
        EXPECT_LE(largest_difference(fftw->values(), solved.phi), 1e-5f * largest(solved.phi)) << cells.x;
    }
}

#if WINDROW_CASES_OPENVDB
TEST(BenchReference, OpenVdbIsTheDirectSolveWithinItsTolerance) {
    const Box box = cases::bench_box(k_cells);
    const SolvedBox solved = solve(box);
    VdbPoisson solver(k_cells, box.cell_size);
    std::vector<float> phi(solved.rhs.size());
    const VdbOutcome outcome = solver.solve(solved.rhs, phi, VdbOutside::open_and_floor, 1e-6);
    EXPECT_TRUE(outcome.converged);
    EXPECT_LT(largest_difference(phi, solved.phi), 1e-4f * largest(solved.phi));
}
#endif

} // namespace
} // namespace windrow::reference
