// A wind with another solve of the pressure, as `windrow pareto` compares them.
#include "cases/reference/other_solve.h"
#include "fluid/thread_pool.h"
#include "fluid/wind.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace windrow::reference {
namespace {

constexpr glm::ivec3 k_wavy_cells{20, 9, 17};
constexpr float k_cell = 0.5f;
constexpr double k_wavy_dt = 0.04;

struct WavyBox {
    Boundaries boundaries;
    float viscosity;
    bool moved;
};

std::vector<WavyBox> cases() {
    return {{Boundaries::all(BoundaryKind::periodic), 0.0f, false},
            {Boundaries::all(BoundaryKind::periodic), 0.05f, false},
            {Boundaries::open_over_floor(), 0.0f, true},
            {Boundaries::all(BoundaryKind::open), 0.3f, true},
            {Boundaries::all(BoundaryKind::no_slip), 2.0f, true}};
}

// A jet that drives and a fan that pushes: both laws. Exchanged before each step.
std::vector<glm::vec4> after(const WavyBox& one, const std::vector<Pressure>& steps, const ParallelFor& loop = {}) {
    const glm::vec3 ambient(3.0f, 0.0f, 1.0f);
    Wind wind = *Wind::create({.cells = k_wavy_cells,
                               .cell_size = k_cell,
                               .boundaries = one.boundaries,
                               .centre = 0.5 * k_cell * glm::dvec3(k_wavy_cells),
                               .ambient = ambient,
                               .viscosity = one.viscosity,
                               .relaxation_time = 0.0f,
                               .max_cfl = 1e5f,
                               .parallel_for = loop});
    wind.set_velocity([&](glm::dvec3 p) {
        const glm::vec3 at = 2.0f * std::numbers::pi_v<float> * glm::vec3(p) / (k_cell * glm::vec3(k_wavy_cells));
        return ambient + 3.0f * glm::vec3(std::sin(at.z) * std::cos(at.y), 0.4f * std::sin(at.x), std::cos(at.x + at.y));
    });
    if (one.moved) {
        EXPECT_TRUE(wind.motors().add(JetMotor{
            .position = {2.0, 2.0, 3.0}, .direction = {1.0f, 0.2f, 0.4f}, .length = 4.0f, .envelope = {.attack = 0.1f}}));
        EXPECT_TRUE(wind.motors().add(DirectionalMotor{
            .position = {6.0, 2.0, 5.0}, .direction = {0.0f, 0.0f, 1.0f}, .region = Sphere{1.8f}, .law = Force{6.0f}}));
    }
    OtherSolve solve(wind);
    for (const Pressure pressure : steps) {
        solve.exchange(wind, pressure);
        EXPECT_EQ(wind.step(k_wavy_dt).substeps, 1);
    }
    return {wind.field().begin(), wind.field().end()};
}

bool same_bits(std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

double rms_difference(std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
    double squares = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
        for (int axis = 0; axis < 3; ++axis)
            squares += std::pow(static_cast<double>(a[n][axis]) - b[n][axis], 2);
    return std::sqrt(squares / static_cast<double>(a.size()));
}

// A solve that is not done to the end leaves something, the less the more it does.
TEST(OtherSolve, ComesToTheDirectOne) {
    for (const WavyBox& one : cases()) {
        const auto by = [&](Pressure pressure) { return after(one, std::vector(4, pressure)); };
        const auto direct = by(Pressure::direct);
        double last = INFINITY, twenty_sweeps = 0.0;
        for (const Pressure pressure : {Pressure::jacobi20, Pressure::jacobi40, Pressure::jacobi80}) {
            const double off = rms_difference(by(pressure), direct);
            EXPECT_LT(off, last);
            EXPECT_GT(off, 0.0);
            last = off;
            if (pressure == Pressure::jacobi20)
                twenty_sweeps = off;
        }
        const double multigrid = rms_difference(by(Pressure::multigrid), direct);
        EXPECT_GT(multigrid, 0.0);
        EXPECT_LT(multigrid, 0.5 * twenty_sweeps);
    }
}

TEST(OtherSolve, DoesNotDependOnTheThreads) {
    ThreadPool pool(3);
    const WavyBox one{Boundaries::open_over_floor(), 0.0f, true};
    for (const Pressure pressure : {Pressure::multigrid, Pressure::jacobi20})
        EXPECT_TRUE(same_bits(after(one, {pressure, pressure}), after(one, {pressure, pressure}, pool.parallel_for())));
}

} // namespace
} // namespace windrow::reference
