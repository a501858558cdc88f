// Diffusion, du/dt = nu L u, over one step of ratio r = nu dt / h^2, where there are no sides or they can be mirrored away.
//
// A mode of angles theta comes out times   none 1 (to the bit) | one pass 1 - 4 r S | implicit 1 / (1 + 4 r S),
// S = sum over the axes of sin^2(theta / 2). Both methods add exactly 2 r cells^2 to a Gaussian's variance in every step.
#include "figures.h"
#include "flows.h"

#include <array>

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

double factor_of(DiffusionMethod method, double r, double s) {
    return method == DiffusionMethod::none       ? 1.0
           : method == DiffusionMethod::one_pass ? 1.0 - 4.0 * r * s
                                                 : 1.0 / (1.0 + 4.0 * r * s);
}

TEST(Diffusion, EachModeHasTheFactorOfItsMethod) {
    const std::array sizes = {glm::ivec3(32, 16, 32), glm::ivec3(17, 9, 23), glm::ivec3(32, 1, 5)};
    const std::array methods = {DiffusionMethod::none, DiffusionMethod::one_pass, DiffusionMethod::implicit};
    const std::array names = {"none", "one_pass", "implicit"};
    double worst[3] = {}, worst_mean = 0.0;
    Random random(8);
    for (const glm::ivec3 cells : sizes)
        for (const double r : {5e-5, 1.5e-4, 1e-2, 0.08, 0.09, 0.5, 3.0, 100.0, 1e4}) {
            const Box box = periodic_box(cells);
            Workspace work = workspace(box, {0.7f, -0.2f, 0.4f});
            for (int trial = 0; trial < 4; ++trial) {
                // Its own mode for each component; the last trial takes the shortest waves.
                glm::dvec3 theta[3];
                double s[3] = {};
                for (int c = 0; c < 3; ++c)
                    for (int axis = 0; axis < 3; ++axis) {
                        const int k = trial == 3 ? cells[axis] / 2 : random.below(cells[axis] / 2 + 1);
                        theta[c][axis] = 2.0 * k_pi * k / cells[axis];
                        s[c] += std::pow(std::sin(0.5 * theta[c][axis]), 2);
                    }
                const auto wave = [&](glm::dvec3 x) {
                    return glm::dvec3(std::cos(glm::dot(theta[0], x - 0.5)), std::cos(glm::dot(theta[1], x - 0.5)),
                                      std::cos(glm::dot(theta[2], x - 0.5)));
                };
                const DiffusionMethod method = diffusion_method(static_cast<float>(r), 1.0f, 1.0f);
                const Field result = diffused(work, velocities_of(box, wave), r);
                visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
                    for (int c = 0; c < 3; ++c) {
                        const double off = std::abs(result[n][c] - factor_of(method, r, s[c]) * wave(x)[c]);
                        double& slot = s[c] == 0.0 ? worst_mean : worst[static_cast<int>(method)];
                        slot = std::max(slot, off);
                    }
                });
            }
        }
    for (const DiffusionMethod method : methods)
        expect_at_most(std::string("diffusion.mode_factor.") + names[static_cast<int>(method)], worst[static_cast<int>(method)],
                       1e-5);
    expect_at_most("diffusion.mean_keeps_its_value", worst_mean, 1e-5);
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
    for (const Sides& sides : {Sides::all(SideKind::periodic), Sides::open_over_floor(), Sides::all(SideKind::no_slip)}) {
        const Box box{.cells = {7, 6, 5}, .sides = sides};
        Workspace work = workspace(box);
        const Field field = random.field(box, 10.0);
        EXPECT_EQ(diffused(work, field, 9e-5), field);
    }
}

// A ball of air that moves, in a periodic box and in an open one that it does not fill.
TEST(Diffusion, AGaussianSpreadsByTwoNuT) {
    constexpr double k_start = 9.0; // sigma 3 cells
    for (const SideKind kind : {SideKind::periodic, SideKind::open})
        for (const auto& [r, steps] : {std::pair(0.05, 80), std::pair(0.4, 10), std::pair(4.0, 1)}) {
            const Box box{.cells = {48, 40, 44}, .sides = Sides::all(kind)};
            Workspace work = workspace(box);
            const glm::dvec3 middle = 0.5 * glm::dvec3(box.cells) + glm::dvec3(0.3, -0.2, 0.1);
            Field field = velocities_of(box, [&](glm::dvec3 x) {
                const double squared = glm::dot(x - middle, x - middle);
                return std::exp(-0.5 * squared / k_start) * glm::dvec3(1.0, -2.0, 0.5);
            });
            for (int step = 0; step < steps; ++step)
                field = diffused(work, field, r);
            double worst = 0.0;
            for (int c = 0; c < 3; ++c)
                for (int axis = 0; axis < 3; ++axis) {
                    double sum = 0.0, second = 0.0;
                    visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
                        sum += field[n][c];
                        second += field[n][c] * (x[axis] - middle[axis]) * (x[axis] - middle[axis]);
                    });
                    worst = std::max(worst, std::abs(second / sum / (k_start + 2.0 * r * steps) - 1.0));
                }
            expect_at_most(std::string("diffusion.variance_error.") + (kind == SideKind::open ? "open." : "periodic.") +
                               figures::number_text(r),
                           worst, 0.01);
        }
}

// Every value is a mean of its neighbours' and its own: no ratio may let the largest grow. White noise holds the worst waves.
TEST(Diffusion, NothingGrowsAtAnyRatio) {
    Random random(4);
    double worst = 0.0, worst_squares = 0.0;
    for (const Sides& sides : {Sides::all(SideKind::periodic), Sides::all(SideKind::open), Sides::all(SideKind::free_slip),
                               Sides::all(SideKind::no_slip), Sides::open_over_floor()})
        for (const glm::ivec3 cells : {glm::ivec3(32, 16, 32), glm::ivec3(17, 9, 23), glm::ivec3(24, 1, 3)}) {
            const Box box{.cells = cells, .sides = sides};
            Workspace work = workspace(box);
            for (const double r : {1e-4, 1e-3, 0.02, 1.0 / 12.0, 0.1, 0.2, 0.7, 10.0, 1e3, 1e4}) {
                const Field field = random.field(box);
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
    const SideKind periodic = SideKind::periodic, slip = SideKind::free_slip;
    struct Case {
        Sides sides;
        glm::bvec3 kept;
    };
    const Case cases[] = {{Sides::all(periodic), {true, true, true}},
                          {sides_of({periodic, periodic}, {slip, slip}, {slip, slip}), {true, false, false}},
                          {sides_of({slip, slip}, {periodic, periodic}, {periodic, periodic}), {false, true, true}},
                          {sides_of({slip, slip}, {slip, slip}, {periodic, periodic}), {false, false, true}}};
    Random random(6);
    double worst = 0.0, least_loss = 1.0;
    for (const Case& box_case : cases)
        for (const glm::ivec3 cells : {glm::ivec3(32, 16, 32), glm::ivec3(17, 9, 23)})
            for (const double r : {1e-3, 0.05, 1.0 / 12.0, 0.2, 2.0, 50.0, 1e4}) {
                const Box box{.cells = cells, .sides = box_case.sides};
                Workspace work = workspace(box);
                Field field = random.field(box);
                for (glm::vec4& u : field)
                    u += glm::vec4(1.0f, 1.5f, -1.0f, 0.0f);
                const Field result = diffused(work, field, r);
                glm::dvec3 before(0.0), after(0.0);
                for (std::size_t n = 0; n < field.size(); ++n) {
                    before += glm::dvec3(field[n]);
                    after += glm::dvec3(result[n]);
                }
                for (int c = 0; c < 3; ++c) {
                    const double loss = std::abs(after[c] / before[c] - 1.0);
                    if (box_case.kept[c])
                        worst = std::max(worst, loss);
                    else if (r >= 1.0)
                        least_loss = std::min(least_loss, loss);
                }
            }
    expect_at_most("diffusion.momentum_error", worst, 1e-6);
    // And a wall does take what runs against it.
    expect_at_least("diffusion.momentum_that_walls_take", least_loss, 0.05);
}

} // namespace
} // namespace windrow
