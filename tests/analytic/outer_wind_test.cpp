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
    const int steps = test::whole_sweeps() ? 360 : 150;
    double worst_same = 0.0, worst_twice = 0.0, worst_over_outer = 0.0, worst_alone = 0.0;
    for (int n = 1; n <= steps; ++n) {
        for (Wind* wind : {same.get(), twice.get(), &in_same, &in_twice, &alone})
            wind->step(1.0 / 30.0);
        if (n % 30 != 0 || n < 120)
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

// --- A vortex in a plane -----------------------------------------------------------------------------------------------------

/// A column of swirling air that the wind carries along x: a steady flow beside that. Its stream function is a Gaussian.
struct Vortex {
    double start = 0.0; ///< [m] along x
    double sigma = 5.0; ///< [m]
    double speed = 2.0; ///< [m/s] its fastest
    glm::vec3 wind{5.0f, 0.0f, 0.0f};

    [[nodiscard]] glm::vec3 velocity(glm::dvec3 at, double time) const {
        const double x = (at.x - start - double(wind.x) * time) / sigma, z = at.z / sigma;
        const double swirl = speed * std::exp(0.5 * (1.0 - x * x - z * z));
        return wind + glm::vec3(float(-swirl * z), 0.0f, float(swirl * x));
    }
};

Config plane_box(double size_x, double size_z, double cell, double middle = 0.0) {
    Boundaries boundaries;
    boundaries.y_low.kind = boundaries.y_high.kind = BoundaryKind::free_slip;
    const auto cells = [&](double size) { return static_cast<int>(std::lround(size / cell)); };
    return {.cells = {cells(size_x), 2, cells(size_z)},
            .cell_size = float(cell),
            .boundaries = boundaries,
            .centre = {middle, 0.0, 0.0},
            .relaxation_time = 0.0f};
}

void set_to(Wind& wind, const Vortex& vortex) {
    wind.set_velocity([&](glm::dvec3 at) { return vortex.velocity(at, 0.0); });
}

/// Of the difference from the vortex over the vortex's own, both over the whole inner box.
double off_vortex(const Wind& wind, const Vortex& vortex, double time) {
    double apart = 0.0, own = 0.0;
    test::for_each_cell(wind, [&](glm::dvec3 at, std::size_t n) {
        const glm::vec3 truth = vortex.velocity(at, time), off = glm::vec3(wind.field()[n]) - truth;
        apart += double(glm::dot(off, off));
        own += double(glm::dot(truth - vortex.wind, truth - vortex.wind));
    });
    return std::sqrt(apart / own);
}

double energy_beside(const Wind& wind, glm::vec3 mean) {
    double squares = 0.0;
    for (const glm::vec4& u : wind.field())
        squares += double(glm::dot(glm::vec3(u) - mean, glm::vec3(u) - mean));
    return squares;
}

// What leaves through the far side of the inner box leaves nothing behind.
TEST(OuterWindVortex, Leaves) {
    const Vortex vortex;
    Config around = plane_box(160.0, 64.0, 2.0, 30.0);
    around.ambient = vortex.wind;
    const auto outer = shared(around);
    Wind inner = within(outer, plane_box(32.0, 32.0, 1.0));
    for (Wind* wind : {outer.get(), &inner})
        set_to(*wind, vortex);
    const double before = energy_beside(inner, vortex.wind);
    for (int n = 0; n < 110; ++n) { // 55 m: its rim is five sigma beyond the box
        outer->step(0.1);
        inner.step(0.1);
    }
    WINDROW_EXPECT_FIGURE("outer_wind.vortex_leaves.energy", energy_beside(inner, vortex.wind) / before, 1e-4);
}

// It comes in through the near side from an outer wind that alone had it.
TEST(OuterWindVortex, Enters) {
    const Vortex vortex{.start = -35.0}; // its middle three sigma before the box
    Config around = plane_box(160.0, 64.0, 2.0);
    around.ambient = vortex.wind;
    const auto outer = shared(around);
    set_to(*outer, vortex);
    Wind inner = within(outer, plane_box(40.0, 40.0, 1.0));
    for (int n = 0; n < 35; ++n) {
        outer->step(0.2);
        inner.step(0.2);
    }
    WINDROW_EXPECT_FIGURE("outer_wind.vortex_enters.error", off_vortex(inner, vortex, 7.0), 0.10);
    double apart = 0.0, own = 0.0;
    test::for_each_cell(inner, [&](glm::dvec3 at, std::size_t) {
        const glm::vec3 truth = vortex.velocity(at, 7.0), off = outer->velocity(at) - truth;
        apart += double(glm::dot(off, off));
        own += double(glm::dot(truth - vortex.wind, truth - vortex.wind));
    });
    test::figure("outer_wind.vortex_enters.outer", std::sqrt(apart / own));
}

// Both levels and the steps are halved: the order is that of the step. `rate`: steps of the inner wind for one of the outer.
double half_in(double cell, int rate) {
    const Vortex vortex{.start = -30.0};
    Config around = plane_box(128.0, 64.0, 2.0 * cell);
    around.ambient = vortex.wind;
    around.ticks.hz = 10.0 / cell / rate;
    const auto outer = shared(around);
    set_to(*outer, vortex);
    Config inside = plane_box(32.0, 32.0, cell);
    inside.ticks.hz = 10.0 / cell;
    Wind inner = within(outer, inside);
    const double dt = 0.1 * cell;
    const int steps = static_cast<int>(std::lround(3.0 / dt)); // its middle is one metre before the side
    double time = 0.0;
    for (int n = 0; n < steps; ++n) {
        if (rate == 1)
            outer->step(dt);
        else
            (void)outer->advance(dt);
        inner.step(dt);
        time += dt;
    }
    // An outer wind with ticks is shown a tick late.
    return off_vortex(inner, vortex, rate == 1 ? time : time - rate * dt);
}

TEST(OuterWindVortex, OrderOfTwoLevels) {
    const double coarse = half_in(1.0, 1), middle = half_in(0.5, 1);
    test::figure("outer_wind.order.error", middle);
    EXPECT_GE(test::figure("outer_wind.order.first", std::log2(coarse / middle)), 1.8);
    if (!test::whole_sweeps())
        return;
    const double fine = half_in(0.25, 1);
    EXPECT_GE(test::figure("outer_wind.order.second", std::log2(middle / fine)), 2.0);
    // At a third of the rate.
    EXPECT_GE(test::figure("outer_wind.order.third_of_the_rate", std::log2(half_in(1.0, 3) / half_in(0.5, 3))), 2.0);
}

// --- A window that walks -----------------------------------------------------------------------------------------------------

TEST(OuterWindWalks, PastABush) {
    Upwind bush{.name = "walk",
                .plants = {PlantDrag{.position = {0.0, 0.0, 10.0}, .radius = 8.0f, .height = 10.0f, .area = 80.0f}}};
    Config fine = fine_box();
    fine.cells = {96, 20, 64};
    Config coarse = fine;
    coarse.cells /= 2;
    coarse.cell_size = 2.0f;
    coarse.ticks.hz = 10.0;
    Config small{.cells = {24, 12, 24},
                 .boundaries = Boundaries::open_over_floor(),
                 .centre = {-20.0, 0.0, -4.0},
                 .relaxation_time = 0.0f};
    Wind truth = made(fine);
    const auto outer = shared(coarse);
    for (Wind* wind : {&truth, outer.get()}) {
        add_to(*wind, bush);
        test::take_steps(*wind, 120, 1.0 / 15.0);
    }
    Wind inner = within(outer, small);
    small.ambient = fine.ambient;
    Wind alone = made(small);
    for (Wind* wind : {&inner, &alone})
        add_to(*wind, bush);
    constexpr int k_frames = 160;
    double whole = 0.0, middle = 0.0, lone = 0.0;
    for (int n = 1; n <= k_frames; ++n) { // 40 m in 8 s, at a slant
        const glm::dvec3 walker(-20.0 + 40.0 * n / k_frames, 0.0, -4.0 + 12.0 * n / k_frames);
        for (Wind* wind : {&inner, &alone}) {
            (void)wind->follow(walker);
        }
        truth.step(1.0 / 20.0);
        (void)outer->advance(1.0 / 20.0);
        inner.step(1.0 / 20.0);
        alone.step(1.0 / 20.0);
        if (n % 40 != 0)
            continue;
        const Off now = off(inner, truth);
        whole = std::max(whole, now.error);
        middle = std::max(middle, now.middle);
        lone = std::max(lone, off(alone, truth).error);
    }
    WINDROW_EXPECT_FIGURE("outer_wind.walk.whole", whole, 0.13);
    WINDROW_EXPECT_FIGURE("outer_wind.walk.middle", middle, 0.09);
    test::figure("outer_wind.walk.alone", lone);
}

// --- A hill in a landscape ---------------------------------------------------------------------------------------------------

/// Root mean square of the difference over that of what the hill does, among places over it.
double off_hill(const Wind& wind, const Wind& truth, double from, double to, double ground) {
    double apart = 0.0, own = 0.0;
    for (double x = from; x <= to; x += 8.0)
        for (double z = -60.0; z <= 60.0; z += 8.0)
            for (const double over : {12.0, 28.0, 52.0}) {
                const double top = ground * std::exp(-(x * x + z * z) / (80.0 * 80.0));
                const glm::dvec3 at(x, top + over, z);
                const glm::vec3 wanted = truth.velocity(at), more = wanted - truth.ambient_wind().velocity(at);
                apart += double(glm::dot(wind.velocity(at) - wanted, wind.velocity(at) - wanted));
                own += double(glm::dot(more, more));
            }
    return std::sqrt(apart / own);
}

// A box of 8 m cells over a hill, in a landscape of 24 m cells with a tick a second: against a box of 8 m cells as large as that.
TEST(LongOuterWindHill, InALandscape) {
    constexpr double k_height = 60.0;
    const auto ground = HeightMap::create({161, 161}, 8.0f, [](glm::vec2 place) {
        const glm::vec2 off = place - 640.0f;
        return float(k_height) * std::exp(-glm::dot(off, off) / (80.0f * 80.0f));
    });
    ASSERT_TRUE(ground) << ground.error();
    const Obstacle hill{.position = {-640.0, 0.0, -640.0}, .shape = Ground{std::make_shared<const HeightMap>(*ground)}};
    Config wide{.cells = {120, 42, 96},
                .cell_size = 8.0f,
                .boundaries = Boundaries::open_over_floor(),
                .ambient = {8.0f, 0.0f, 0.0f},
                .relaxation_time = 0.0f};
    Config landscape = wide;
    landscape.cells = {40, 14, 32};
    landscape.cell_size = 24.0f;
    landscape.ticks.hz = 1.0;
    Config box{.cells = {40, 24, 32}, .cell_size = 8.0f, .boundaries = Boundaries::open_over_floor(), .relaxation_time = 0.0f};
    Wind truth = made(wide);
    const auto outer = shared(landscape);
    for (Wind* wind : {&truth, outer.get()})
        ASSERT_TRUE(wind->obstacles().add(hill));
    Wind inner = within(outer, box);
    box.ambient = wide.ambient;
    Wind alone = made(box);
    for (Wind* wind : {&inner, &alone})
        ASSERT_TRUE(wind->obstacles().add(hill));
    for (int n = 0; n < 240; ++n) {
        truth.step(0.5);
        (void)outer->advance(0.5);
        inner.step(0.5);
        alone.step(0.5);
    }
    WINDROW_EXPECT_FIGURE("outer_wind.hill.top", off_hill(inner, truth, -40.0, 40.0, k_height), 0.08);
    WINDROW_EXPECT_FIGURE("outer_wind.hill.lee", off_hill(inner, truth, 60.0, 140.0, k_height), 0.11);
    test::figure("outer_wind.hill.top_alone", off_hill(alone, truth, -40.0, 40.0, k_height));
    test::figure("outer_wind.hill.lee_alone", off_hill(alone, truth, 60.0, 140.0, k_height));
}

} // namespace
} // namespace windrow
