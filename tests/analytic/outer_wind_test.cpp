// A wind inside another one (fluid/cpu/outer_wind.h): what comes in through the sides of the inner box is what the outer wind has
// there, and what leaves is not held up.
//
// The truth is a box of the inner cells that is as large as the outer one. Errors are the root mean square of the difference over that
// of what the truth has more than the ambient wind, over the inner box.
#include "tests/tier.h"
#include "tests/winds.h"

#include <array>
#include <memory>
#include <random>
#include <vector>

namespace windrow {
namespace {

using test::made;

std::shared_ptr<Wind> shared(const Config& config) {
    return std::make_shared<Wind>(made(config));
}

Wind within(const std::shared_ptr<Wind>& outer, Config config) {
    config.ambient = glm::vec3(0.0f);
    config.profile.reset();
    config.gusts = {};
    auto wind = Wind::create(config, outer);
    EXPECT_TRUE(wind) << wind.error();
    return *std::move(wind);
}

/// What the inner air is beside the truth.
struct Off {
    double error = 0.0;  ///< of the whole box
    double middle = 0.0; ///< of its inner half along x and z
    double outer = 0.0;  ///< what the outer level has itself, over the whole box
};

Off off(const Wind& inner, const Wind& truth) {
    const WindView view = inner.view();
    double squares = 0.0, off_middle = 0.0, of_outer = 0.0, most = 0.0, most_middle = 0.0;
    const glm::ivec3 cells = view.box().cells;
    test::for_each_cell(cells, [&](int i, int j, int k) {
        const glm::dvec3 centre = view.window().centre(i, j, k);
        const glm::vec3 wanted = truth.velocity(centre), ambient = truth.ambient_wind().velocity(centre);
        const glm::vec3 apart = glm::vec3(view.field()[view.box().index(i, j, k)]) - wanted;
        const bool middle = 4 * i >= cells.x && 4 * i < 3 * cells.x && 4 * k >= cells.z && 4 * k < 3 * cells.z;
        const double moved = double(glm::dot(wanted - ambient, wanted - ambient));
        squares += double(glm::dot(apart, apart));
        most += moved;
        off_middle += middle ? double(glm::dot(apart, apart)) : 0.0;
        most_middle += middle ? moved : 0.0;
        if (inner.outer()) {
            const glm::vec3 coarse = inner.outer()->velocity(centre) - wanted;
            of_outer += double(glm::dot(coarse, coarse));
        }
    });
    return {std::sqrt(squares / most), std::sqrt(off_middle / most_middle), std::sqrt(of_outer / most)};
}

// --- What passes through the sides -------------------------------------------------------------------------------------------

/// Something in the air beside, before or across the inner box of 32 x 16 x 32 m about the origin.
struct Upwind {
    const char* name;
    std::vector<DragDeposit> plants{};
    std::vector<Motor> motors{};
    double same = 0.02, twice = 0.0; ///< bounds: outer cells as large, and twice as large
};
void PrintTo(const Upwind& value, std::ostream* out) {
    *out << value.name;
}

void add_to(Wind& wind, const Upwind& what) {
    ASSERT_TRUE(wind.drag().add(what.plants));
    for (const Motor& motor : what.motors)
        (void)test::added(wind, motor);
}

Config fine_box() {
    return {.cells = {80, 24, 64},
            .boundaries = Boundaries::open_over_floor(),
            .ambient = {5.0f, 0.0f, 0.0f},
            .relaxation_time = 0.0f};
}
Config window_box() {
    return {.cells = {32, 16, 32}, .boundaries = Boundaries::open_over_floor(), .relaxation_time = 0.0f};
}

class OuterWindPasses : public testing::TestWithParam<Upwind> {};

TEST_P(OuterWindPasses, WhatStandsUpwind) {
    const Upwind& what = GetParam();
    const auto same = shared(fine_box());
    Config coarse_box = fine_box();
    coarse_box.cells /= 2;
    coarse_box.cell_size = 2.0f;
    const auto twice = shared(coarse_box);
    Wind in_same = within(same, window_box()), in_twice = within(twice, window_box());
    Wind alone = made(test::with(window_box(), [](Config& config) { config.ambient = fine_box().ambient; }));
    for (Wind* wind : {same.get(), twice.get(), &in_same, &in_twice, &alone})
        add_to(*wind, what);
    constexpr int k_steps = 360;
    double worst_same = 0.0, worst_twice = 0.0, worst_over_outer = 0.0, worst_alone = 0.0;
    for (int n = 1; n <= k_steps; ++n) {
        for (Wind* wind : {same.get(), twice.get(), &in_same, &in_twice, &alone})
            wind->step(1.0 / 30.0);
        if (n % 60 != 0 || n < 120)
            continue;
        const Off near = off(in_same, *same), far = off(in_twice, *same), lone = off(alone, *same);
        worst_same = std::max(worst_same, near.error);
        worst_twice = std::max(worst_twice, far.error);
        worst_over_outer = std::max(worst_over_outer, far.error / far.outer);
        worst_alone = std::max(worst_alone, lone.error);
    }
    const std::string name = std::string("outer_wind.") + what.name;
    WINDROW_EXPECT_FIGURE(name + ".same_cells", worst_same, what.same);
    WINDROW_EXPECT_FIGURE(name + ".twice_the_cells", worst_twice, what.twice);
    WINDROW_EXPECT_FIGURE(name + ".over_outer", worst_over_outer, 1.1);
    test::figure(name + ".alone", worst_alone);
}

INSTANTIATE_TEST_SUITE_P(
    Of, OuterWindPasses,
    testing::Values(Upwind{.name = "bush",
                           .plants = {PlantDrag{.position = {-26.0, 0.0, 3.0}, .radius = 7.0f, .height = 10.0f, .area = 100.0f}},
                           .same = 0.02,
                           .twice = 0.18},
                    Upwind{.name = "fan",
                           .motors = {DirectionalMotor{.position = {-26.0, 6.0, -2.0},
                                                       .direction = {1.0f, 0.0f, 0.2f},
                                                       .region = Sphere{9.0f},
                                                       .law = Drive{.speed = 10.0f}}},
                           .same = 0.02,
                           .twice = 0.18},
                    Upwind{.name = "wood",
                           .plants = {BeltDrag{.start = {-26.0, 0.0, -28.0},
                                               .end = {-26.0, 0.0, 28.0},
                                               .width = 8.0f,
                                               .height = 8.0f,
                                               .resistance = 2.0f},
                                      BeltDrag{.start = {-4.0, 0.0, -28.0},
                                               .end = {-4.0, 0.0, 28.0},
                                               .width = 8.0f,
                                               .height = 8.0f,
                                               .resistance = 2.0f}},
                           .same = 0.02,
                           .twice = 0.13}),
    [](const auto& suite) { return std::string(suite.param.name); });

} // namespace
} // namespace windrow
