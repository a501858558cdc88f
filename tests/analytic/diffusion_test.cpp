// Diffusion, du/dt = nu L u, over one step of ratio r = nu dt / h^2, where there are no sides or they can be mirrored away.
#include "case_check.h"
#include "flows.h"

#include <numbers>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_least;
using figures::expect_at_most;

// h = 1 and dt = 1, so that the viscosity is r.
Field diffused(Workspace& work, const Field& field, double r) {
    Field result(field.size());
    EXPECT_TRUE(diffuse(work, field, static_cast<float>(r), 1.0f, result));
    return result;
}

TEST(Diffusion, EachModeHasTheFactorOfItsMethod) {
    figures::expect_case("diffusion_modes", {16, 32, 64});
}

TEST(Diffusion, MethodsMeetTheirThresholds) {
    EXPECT_EQ(diffusion_method(9.9e-5f, 1.0f, 1.0f), DiffusionMethod::none);
    EXPECT_EQ(diffusion_method(1.1e-4f, 1.0f, 1.0f), DiffusionMethod::one_pass);
    EXPECT_EQ(diffusion_method(0.083f, 1.0f, 1.0f), DiffusionMethod::one_pass);
    EXPECT_EQ(diffusion_method(0.084f, 1.0f, 1.0f), DiffusionMethod::implicit);
    EXPECT_EQ(diffusion_method(1.5e-5f, 1.0f / 60.0f, 1.0f), DiffusionMethod::none); // air at 1 m
    EXPECT_EQ(diffusion_method(0.5f, 0.5f, 2.0f), DiffusionMethod::one_pass);        // r = 1/16
}

TEST(Diffusion, BelowTheLeastRatioItIsACopyToTheBit) {
    Random random(2);
    for (const Boundaries& boundaries :
         {Boundaries::all(BoundaryKind::periodic), Boundaries::open_over_floor(), Boundaries::all(BoundaryKind::no_slip)}) {
        const Box box{.cells = {7, 6, 5}, .boundaries = boundaries};
        Workspace work = workspace(box);
        const Field field = random_field(random, box, 10.0f);
        EXPECT_EQ(diffused(work, field, 9e-5), field);
    }
}

TEST(Diffusion, AGaussianSpreadsByTwoNuT) {
    for (const char* const name : {"gaussian_spreading_one_pass", "gaussian_spreading_implicit"})
        figures::expect_case(name, {24, 48});
}

// Every value is a mean of its neighbours' and its own: no ratio may let the largest grow. White noise holds the worst waves.
TEST(Diffusion, NothingGrowsAtAnyRatio) {
    Random random(4);
    double worst = 0.0, worst_squares = 0.0;
    for (const Boundaries& boundaries :
         {Boundaries::all(BoundaryKind::periodic), Boundaries::all(BoundaryKind::open), Boundaries::all(BoundaryKind::free_slip),
          Boundaries::all(BoundaryKind::no_slip), Boundaries::open_over_floor()})
        for (const glm::ivec3 cells : {glm::ivec3(32, 16, 32), glm::ivec3(17, 9, 23), glm::ivec3(24, 1, 3)}) {
            const Box box{.cells = cells, .boundaries = boundaries};
            Workspace work = workspace(box);
            for (const double r : {1e-4, 1e-3, 0.02, 1.0 / 12.0, 0.1, 0.2, 0.7, 10.0, 1e3, 1e4}) {
                const Field field = random_field(random, box);
                Field result = diffused(work, field, r);
                double largest = 0.0, largest_before = 0.0;
                for (std::size_t n = 0; n < field.size(); ++n)
                    for (int c = 0; c < 3; ++c) {
                        largest_before = std::max(largest_before, std::abs(static_cast<double>(field[n][c])));
                        largest = std::max(largest, std::abs(static_cast<double>(result[n][c])));
                    }
                worst = std::max(worst, largest / largest_before);
                worst_squares = std::max(worst_squares, rms(result) / rms(field));
            }
        }
    expect_at_most("diffusion.largest_value_ratio", worst, 1.0);
    expect_at_most("diffusion.rms_ratio", worst_squares, 1.0);
}

TEST(Diffusion, TheCheckerboardIsGoneAtOnceAtALargeRatio) {
    const Box box = periodic_box({32, 16, 32});
    Workspace work = workspace(box);
    const Field board = velocities_of(box, [](glm::dvec3 x) {
        return glm::dvec3((static_cast<int>(x.x) + static_cast<int>(x.y) + static_cast<int>(x.z)) % 2 == 0 ? 1.0 : -1.0);
    });
    expect_at_most("diffusion.checkerboard_left_at_1e4", rms(diffused(work, board, 1e4)) / rms(board), 1e-5);
}

// Momentum: all of it in a periodic box; between free-slip walls, the components along both walls. (A wall takes the component
// across it, and its neighbour's share of it is no loss of the method.)
TEST(Diffusion, TheSumOfAComponentThatNoWallTakesIsKept) {
    const BoundaryKind periodic = BoundaryKind::periodic, slip = BoundaryKind::free_slip;
    struct KeptMomentum {
        Boundaries boundaries;
        glm::bvec3 kept;
    };
    const KeptMomentum kept_in[] = {{Boundaries::all(periodic), {true, true, true}},
                                    {sides_of({periodic, periodic}, {slip, slip}, {slip, slip}), {true, false, false}},
                                    {sides_of({slip, slip}, {periodic, periodic}, {periodic, periodic}), {false, true, true}},
                                    {sides_of({slip, slip}, {slip, slip}, {periodic, periodic}), {false, false, true}}};
    Random random(6);
    double worst = 0.0, min_loss = 1.0;
    for (const KeptMomentum& box_case : kept_in)
        for (const glm::ivec3 cells : {glm::ivec3(32, 16, 32), glm::ivec3(17, 9, 23)})
            for (const double r : {1e-3, 0.05, 1.0 / 12.0, 0.2, 2.0, 50.0, 1e4}) {
                const Box box{.cells = cells, .boundaries = box_case.boundaries};
                Workspace work = workspace(box);
                Field field = random_field(random, box);
                for (glm::vec4& u : field)
                    u += glm::vec4(1.0f, 1.5f, -1.0f, 0.0f);
                const Field result = diffused(work, field, r);
                const glm::dvec3 before = test::sum_of(field), after = test::sum_of(result);
                for (int c = 0; c < 3; ++c) {
                    const double loss = std::abs(after[c] / before[c] - 1.0);
                    if (box_case.kept[c])
                        worst = std::max(worst, loss);
                    else if (r >= 1.0)
                        min_loss = std::min(min_loss, loss);
                }
            }
    expect_at_most("diffusion.momentum_error", worst, 1e-6);
    // And a wall does take what runs against it.
    expect_at_least("diffusion.momentum_that_walls_take", min_loss, 0.05);
}

// --- Accumulated diffusion time ----------------------------------------------------------------------------------------------------

// Viscosity acts in full for steps of any length: the time of steps that are too short is accumulated. A wave of 8 cells in a still
// periodic box, nu = 0.01 m^2/s, h = 1 m, fades as exp(-nu k^2 t) with the grid's own k^2 = 4 sin^2(pi/8). Steps at 30, 120 and
// 1000 Hz have r = 3.3e-4, 8.3e-5 and 1e-5; below 1e-4 a single one is less than what floats hold.
double height_after(double seconds, double hz) {
    const Config config{.cells = {1, 8, 1},
                        .boundaries = Boundaries::all(BoundaryKind::periodic),
                        .viscosity = 0.01f,
                        .relaxation_time = 0.0f,
                        .stages = {.advection = false}};
    Wind wind = test::made(config);
    const auto wave = [](double y) { return std::sin(2.0 * std::numbers::pi * y / 8.0); };
    wind.set_velocity([&](glm::dvec3 x) { return glm::vec3(wave(x.y), 0.0f, 0.0f); });
    take_steps(wind, static_cast<int>(std::lround(seconds * hz)), 1.0 / hz);
    double sum = 0.0;
    for (int j = 0; j < 8; ++j)
        sum += wind.field()[j].x * wave(wind.origin().y + j + 0.5) / 4.0;
    return sum;
}

TEST(OwedDiffusion, AWaveFadesAlikeInShortAndInLongSteps) {
    const double half_sine = std::sin(std::numbers::pi / 8.0);
    const double exact = std::exp(-0.01 * 4.0 * half_sine * half_sine * 60.0);
    for (const double hz : {30.0, 120.0, 1000.0}) {
        expect_at_most("diffusion.owed_hz_" + std::to_string(static_cast<int>(hz)),
                       std::abs(height_after(60.0, hz) / exact - 1.0), 2e-3);
    }
}

} // namespace
} // namespace windrow
