// The step that `windrow pareto` takes apart is the library's where nothing is exchanged.
#include "cases/reference/composed_step.h"
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

constexpr glm::ivec3 k_cells{20, 9, 17};
constexpr float k_cell = 0.5f;
constexpr double k_dt = 0.04;

std::vector<glm::vec4> waves(const Box& box, glm::vec3 mean) {
    std::vector<glm::vec4> field(box.cell_count());
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i) {
                const glm::vec3 at = 2.0f * std::numbers::pi_v<float> * (glm::vec3(i, j, k) + 0.5f) / glm::vec3(box.cells);
                const glm::vec3 wave(std::sin(at.z) * std::cos(at.y), 0.4f * std::sin(at.x), std::cos(at.x + at.y));
                field[box.index(i, j, k)] = glm::vec4(mean + 3.0f * wave, 0.0f);
            }
    return field;
}

/// A jet that drives and a fan that pushes: both laws.
std::vector<Motor> motors() {
    return {JetMotor{.position = {2.0, 2.0, 3.0}, .direction = {1.0f, 0.2f, 0.4f}, .length = 4.0f, .envelope = {.attack = 0.1f}},
            DirectionalMotor{
                .position = {6.0, 2.0, 5.0}, .direction = {0.0f, 0.0f, 1.0f}, .region = Sphere{1.8f}, .law = Force{6.0f}}};
}

struct ComposedBox {
    Boundaries boundaries;
    float viscosity;
    bool moved;
};

std::vector<ComposedBox> cases() {
    return {{Boundaries::all(BoundaryKind::periodic), 0.0f, false},
            {Boundaries::all(BoundaryKind::periodic), 0.05f, false},
            {Boundaries::open_over_floor(), 0.0f, true},
            {Boundaries::all(BoundaryKind::open), 0.3f, true},
            {Boundaries::all(BoundaryKind::no_slip), 2.0f, true}};
}

ComposedStep composed(const ComposedBox& one, glm::vec3 ambient, const ParallelFor& loop = {}) {
    return *ComposedStep::create({.box = {k_cells, k_cell, one.boundaries},
                                  .ambient = ambient,
                                  .viscosity = one.viscosity,
                                  .motors = one.moved ? motors() : std::vector<Motor>{},
                                  .parallel_for = loop});
}

bool same_bits(std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

TEST(ComposedStep, WithTheDirectSolveIsTheWindsStepToTheBit) {
    const glm::vec3 ambient(3.0f, 0.0f, 1.0f);
    for (const ComposedBox& one : cases())
        for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids})
            for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubic}) {
                auto wind = Wind::create({.cells = k_cells,
                                          .cell_size = k_cell,
                                          .boundaries = one.boundaries,
                                          .centre = 0.5 * k_cell * glm::dvec3(k_cells),
                                          .ambient = ambient,
                                          .viscosity = one.viscosity,
                                          .relaxation_time = 0.0f,
                                          .scheme = scheme,
                                          .interpolation = interpolation,
                                          .max_cfl = 1e5f});
                ASSERT_TRUE(wind);
                ComposedStep step = composed(one, ambient);
                const auto start = waves(wind->box(), ambient);
                ASSERT_TRUE(wind->set_velocity(start));
                ASSERT_TRUE(step.start(start));
                for (const Motor& motor : one.moved ? motors() : std::vector<Motor>{})
                    ASSERT_TRUE(wind->motors().add(motor));
                for (int n = 0; n < 6; ++n) {
                    const double dt = n == 3 ? 0.6 * k_dt : k_dt; // another step between
                    const Diagnostics report = wind->step(dt);
                    step.step({scheme, interpolation, Pressure::direct}, dt);
                    EXPECT_EQ(report.substeps, 1);
                    EXPECT_TRUE(same_bits(step.velocity(), wind->field())) << "step " << n;
                    EXPECT_EQ(step.largest_speed(), report.max_speed);
                }
                EXPECT_FALSE(same_bits(step.velocity(), start));
            }
}

double rms_difference(std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
    double squares = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
        for (int axis = 0; axis < 3; ++axis)
            squares += std::pow(static_cast<double>(a[n][axis]) - b[n][axis], 2);
    return std::sqrt(squares / static_cast<double>(a.size()));
}

// A solve that is not done to the end leaves something, the less the more it does.
TEST(ComposedStep, OtherSolvesComeToTheDirectOne) {
    const glm::vec3 ambient(3.0f, 0.0f, 1.0f);
    for (const ComposedBox& one : cases()) {
        const auto after = [&](Pressure pressure) {
            ComposedStep step = composed(one, ambient);
            EXPECT_TRUE(step.start(waves({k_cells, k_cell, one.boundaries}, ambient)));
            for (int n = 0; n < 4; ++n)
                step.step({.pressure = pressure}, k_dt);
            return std::vector<glm::vec4>(step.velocity().begin(), step.velocity().end());
        };
        const auto direct = after(Pressure::direct);
        double last = INFINITY, twenty_sweeps = 0.0;
        for (const Pressure pressure : {Pressure::jacobi20, Pressure::jacobi40, Pressure::jacobi80}) {
            const double off = rms_difference(after(pressure), direct);
            EXPECT_LT(off, last);
            EXPECT_GT(off, 0.0);
            last = off;
            if (pressure == Pressure::jacobi20)
                twenty_sweeps = off;
        }
        EXPECT_LT(rms_difference(after(Pressure::multigrid), direct), 0.5 * twenty_sweeps);
    }
}

TEST(ComposedStep, DoesNotDependOnTheThreads) {
    ThreadPool pool(3);
    const ComposedBox one{Boundaries::open_over_floor(), 0.0f, true};
    for (const Pressure pressure : {Pressure::multigrid, Pressure::jacobi20}) {
        ComposedStep alone = composed(one, glm::vec3(2.0f, 0.0f, 0.0f));
        ComposedStep together = composed(one, glm::vec3(2.0f, 0.0f, 0.0f), pool.parallel_for());
        for (ComposedStep* step : {&alone, &together}) {
            ASSERT_TRUE(step->start(waves({k_cells, k_cell, one.boundaries}, glm::vec3(2.0f, 0.0f, 0.0f))));
            step->step({.pressure = pressure}, k_dt);
            step->step({.pressure = pressure}, k_dt);
        }
        EXPECT_TRUE(same_bits(alone.velocity(), together.velocity()));
    }
}

TEST(ComposedStep, StartsAnew) {
    ComposedStep step = composed({Boundaries::open_over_floor(), 0.0f, true}, glm::vec3(0.0f));
    const auto start = waves({k_cells, k_cell, Boundaries::open_over_floor()}, glm::vec3(0.0f));
    std::vector<glm::vec4> first;
    for (int turn = 0; turn < 2; ++turn) {
        ASSERT_TRUE(step.start(start));
        for (int n = 0; n < 3; ++n)
            step.step({}, k_dt);
        if (turn == 0)
            first.assign(step.velocity().begin(), step.velocity().end());
    }
    EXPECT_TRUE(same_bits(step.velocity(), first));
}

TEST(ComposedStep, RejectsWhatTheLibraryRejects) {
    EXPECT_FALSE(ComposedStep::create({.box = {.cells = {0, 4, 4}}}));
    auto step = ComposedStep::create({.box = {.cells = {8, 8, 8}}, .motors = {JetMotor{.length = -1.0f}}});
    ASSERT_TRUE(step);
    EXPECT_FALSE(step->start(std::vector<glm::vec4>(512)));
}

} // namespace
} // namespace windrow::reference
