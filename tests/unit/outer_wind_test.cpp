// A wind inside another one: what it takes from the outer wind, and that it takes nothing where that is the ambient wind.
#include "tests/figure.h"
#include "tests/tier.h"
#include "tests/winds.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace windrow {
namespace {

using test::made;

std::shared_ptr<Wind> shared(const Config& config) {
    return std::make_shared<Wind>(made(config));
}

Wind within(const std::shared_ptr<Wind>& outer, const Config& config) {
    auto wind = Wind::create(config, outer);
    EXPECT_TRUE(wind) << wind.error();
    return *std::move(wind);
}

Config around() {
    return {.cells = {20, 8, 20}, .cell_size = 2.0f, .boundaries = Boundaries::open_over_floor(), .ticks = {.hz = 10.0}};
}
Config inside() {
    return {.cells = {12, 8, 12}, .boundaries = Boundaries::open_over_floor()};
}
const DirectionalMotor k_fan{.position = {-12.0, 3.0, 0.0}, .region = Sphere{5.0f}, .law = Drive{.speed = 9.0f}};

struct Same {
    const char* name;
    Config config{}; ///< of mean wind, profile and gusts
    double bound = 0.0;
};
void PrintTo(const Same& value, std::ostream* out) {
    *out << value.name;
}

class OuterWindIsAmbient : public testing::TestWithParam<Same> {};

// An outer wind that is the ambient wind leaves the bits of a wind without one: with a motor in the inner box, in steps and in ticks,
// while the box moves.
TEST_P(OuterWindIsAmbient, LeavesTheBits) {
    const Config& air = GetParam().config;
    const auto with_air = [&](Config config) {
        config.ambient = air.ambient;
        config.profile = air.profile;
        config.gusts = air.gusts;
        return config;
    };
    for (const bool ticks : {false, true}) {
        const auto outer = shared(with_air(around()));
        Wind nested = within(outer, inside()), alone = made(with_air(inside()));
        double worst = 0.0;
        for (Wind* wind : {&nested, &alone})
            (void)test::added(*wind, DirectionalMotor{.position = {1.0, 2.0, 0.0}, .law = Drive{.speed = 6.0f}});
        for (int n = 0; n < 40; ++n) {
            const double dt = n % 3 == 0 ? 1.0 / 30.0 : 1.0 / 45.0;
            for (Wind* wind : {outer.get(), &nested, &alone}) {
                if (wind != outer.get()) {
                    ASSERT_TRUE(wind->follow({0.1 * n, 0.0, -0.05 * n}));
                }
                if (ticks)
                    (void)wind->advance(dt);
                else
                    (void)wind->step(dt);
            }
            worst = std::max(worst, test::largest_apart(nested.field(), alone.field()));
            std::vector<double> places{0.1 * n, 0.1 * n + 3.9, 9.5, 30.0}; // inside, in the blend zone, beyond, beyond both
            if (air.profile || air.gusts.intensity > 0.0f)
                places.resize(1); // farther out the wind is read between the outer wind's cells
            for (const double x : places)
                worst = std::max(worst,
                                 double(glm::length(nested.velocity({x, 1.2, -0.05 * n}) - alone.velocity({x, 1.2, -0.05 * n}))));
        }
        WINDROW_EXPECT_FIGURE(std::string("outer_wind.ambient.") + GetParam().name + (ticks ? ".ticks" : ""), worst,
                              GetParam().bound);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, OuterWindIsAmbient,
                         testing::Values(Same{"still"}, Same{"uniform", {.ambient = {4.0f, 0.0f, 1.0f}}},
                                         Same{"profile", {.ambient = {6.0f, 0.0f, 0.0f}, .profile = LogProfile{}}},
                                         Same{"gusts", {.ambient = {6.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.3f}}, 1e-5}),
                         [](const auto& suite) { return std::string(suite.param.name); });

TEST(OuterWind, IsWhatTheInnerWindIsBeyondItsBox) {
    Config config = around();
    config.ambient = {5.0f, 0.0f, 0.0f};
    const auto outer = shared(config);
    (void)test::added(*outer, k_fan);
    Wind inner = within(outer, inside());
    for (int n = 0; n < 60; ++n) {
        (void)outer->advance(1.0 / 30.0);
        (void)inner.advance(1.0 / 30.0);
    }
    const glm::dvec3 beyond(-12.0, 3.0, 0.0);
    EXPECT_GT(outer->velocity(beyond).x, 7.0f);
    EXPECT_EQ(inner.velocity(beyond), outer->velocity(beyond));
    // The fan's jet has come in, and nothing jumps where the box ends.
    EXPECT_GT(inner.velocity({-2.0, 3.0, 0.0}).x, 6.0f);
    float largest = 0.0f;
    for (int n = 0; n < 240; ++n) {
        const double x = -9.0 + 0.025 * n;
        largest = std::max(largest, glm::length(inner.velocity({x + 0.025, 3.0, 0.5}) - inner.velocity({x, 3.0, 0.5})));
    }
    WINDROW_EXPECT_FIGURE("outer_wind.blend.largest_change", double(largest), 0.1);
    std::vector<glm::vec4> felt(1);
    inner.velocity(std::vector{beyond}, felt);
    EXPECT_EQ(glm::vec3(felt[0]), outer->velocity(beyond));
}

TEST(OuterWind, FillsNewCells) {
    Config config = around();
    config.relaxation_time = 0.0f;
    const auto outer = shared(config);
    outer->set_velocity([](glm::dvec3 at) { return glm::vec3(3.0f, 0.0f, 0.1f * float(at.x)); });
    Wind inner = within(outer, inside());
    EXPECT_EQ(inner.velocity({2.5, 2.0, 0.0}), outer->velocity({2.5, 2.0, 0.0}));
    inner.set_velocity([](glm::dvec3) { return glm::vec3(0.0f); });
    ASSERT_TRUE(inner.follow({4.0, 0.0, 0.0}));
    const Box& box = inner.box();
    for (int i = 0; i < box.cells.x; ++i) {
        const glm::dvec3 centre = inner.view().window().centre(i, 2, 5);
        const glm::vec3 cell = inner.field()[box.index(i, 2, 5)];
        const glm::vec3 wanted = i < box.cells.x - 4 ? glm::vec3(0.0f) : outer->velocity(centre);
        EXPECT_LE(glm::length(cell - wanted), 1e-6f) << i;
    }
    // A jump beyond the box starts afresh in the outer wind.
    ASSERT_TRUE(inner.follow({-10.0, 0.0, 0.0}));
    EXPECT_LE(glm::length(inner.velocity({-10.0, 2.0, 0.0}) - outer->velocity({-10.0, 2.0, 0.0})), 1e-6f);
}

TEST(OuterWind, SleepsWithTheOuterWind) {
    Config config = around();
    config.relaxation_time = 1.0f;
    Config small = inside();
    small.relaxation_time = 1.0f;
    const auto outer = shared(config);
    Wind inner = within(outer, small);
    const auto run = [&](int frames) {
        for (int n = 0; n < frames; ++n) {
            (void)outer->advance(0.1);
            (void)inner.advance(0.1);
        }
    };
    run(20);
    EXPECT_TRUE(outer->diagnostics().asleep);
    EXPECT_TRUE(inner.diagnostics().asleep);
    const MotorId fan = test::added(*outer, k_fan);
    run(20);
    EXPECT_FALSE(outer->diagnostics().asleep);
    EXPECT_FALSE(inner.diagnostics().asleep);
    EXPECT_GT(glm::length(inner.velocity({-4.0, 3.0, 0.0})), 0.05f);
    ASSERT_TRUE(outer->motors().remove(fan));
    run(300);
    EXPECT_TRUE(outer->diagnostics().asleep);
    EXPECT_TRUE(inner.diagnostics().asleep);
    EXPECT_EQ(inner.velocity({-4.0, 3.0, 0.0}), glm::vec3(0.0f));
}

TEST(OuterWind, HasTheAmbientWindOfAllLevels) {
    const auto outer = shared(around());
    Wind inner = within(outer, inside());
    EXPECT_FALSE(inner.set_ambient({1.0f, 0.0f, 0.0f}));
    EXPECT_FALSE(inner.set_gusts({.intensity = 0.2f}));
    ASSERT_TRUE(outer->set_ambient({7.0f, 0.0f, 0.0f}));
    ASSERT_TRUE(outer->set_gusts({.intensity = 0.2f}));
    for (Wind* wind : {outer.get(), &inner})
        test::take_steps(*wind, 1, 0.05);
    EXPECT_EQ(inner.ambient(), glm::vec3(7.0f, 0.0f, 0.0f));
    EXPECT_EQ(inner.config().gusts.intensity, 0.2f);
    EXPECT_LE(test::off_ambient(inner), 1e-4);

    // What the walls of the outer wind close is closed for all levels, and another tile is one for all.
    const auto walled = shared(test::with(around(), [](Config& config) {
        config.boundaries.z_low.kind = config.boundaries.z_high.kind = BoundaryKind::free_slip;
        config.ambient = {3.0f, 0.0f, 4.0f};
        config.gusts.intensity = 0.3f;
    }));
    Wind between = within(walled, inside());
    EXPECT_EQ(between.ambient(), glm::vec3(3.0f, 0.0f, 0.0f));
    ASSERT_TRUE(walled->set_gusts({.intensity = 0.3f, .tile = GustTile::bake(77)}));
    for (Wind* wind : {walled.get(), &between})
        test::take_steps(*wind, 1, 0.05);
    ASSERT_TRUE(walled->set_boundaries(Boundaries::all(BoundaryKind::free_slip)));
    for (Wind* wind : {walled.get(), &between})
        test::take_steps(*wind, 1, 0.05);
    EXPECT_EQ(between.ambient_wind().gust_axes(), walled->ambient_wind().gust_axes());
    const glm::dvec3 place(1.0, 2.0, 3.0);
    EXPECT_EQ(between.ambient_wind().velocity(place), walled->ambient_wind().velocity(place));
}

// A snapshot of each level goes on with the same bits, in the middle of frames and after the box has moved.
TEST(OuterWind, SnapshotsGoOnWithTheSameBits) {
    Config config = around();
    config.ambient = {5.0f, 0.0f, 0.0f};
    const auto outer = shared(config);
    (void)test::added(*outer, k_fan);
    Wind inner = within(outer, inside());
    const auto frame = [](const std::shared_ptr<Wind>& large, Wind& small, int n) {
        ASSERT_TRUE(small.follow({0.05 * n, 0.0, 0.02 * n}));
        (void)large->advance(1.0 / 60.0);
        (void)small.advance(1.0 / 60.0);
    };
    for (int n = 0; n < 61; ++n)
        frame(outer, inner, n);
    // The weather changes between the last tick of the inner wind and the save.
    ASSERT_TRUE(outer->set_ambient({8.0f, 0.0f, 1.0f}) && outer->set_gusts({.intensity = 0.3f}));
    const auto large = outer->save(), small = inner.save();
    ASSERT_TRUE(large && small);
    const auto outer_again = std::make_shared<Wind>(*Wind::load(*large));
    auto inner_again = Wind::load(*small, {}, outer_again);
    ASSERT_TRUE(inner_again) << inner_again.error();
    for (int n = 61; n < 100; ++n) {
        frame(outer, inner, n);
        frame(outer_again, *inner_again, n);
    }
    EXPECT_EQ(test::largest_apart(outer->field(), outer_again->field()), 0.0);
    EXPECT_EQ(test::largest_apart(inner.field(), inner_again->field()), 0.0);
    EXPECT_EQ(inner.velocity({9.0, 2.0, 0.0}), inner_again->velocity({9.0, 2.0, 0.0}));

    const auto no_outer = Wind::load(*small);
    EXPECT_NE(no_outer.error().find("saved with an outer wind"), std::string::npos);
    const auto one_too_many = Wind::load(*large, {}, outer);
    EXPECT_NE(one_too_many.error().find("saved without an outer wind"), std::string::npos);
}

// Sub-steps while a body moves follow from the outer wind's speed too.
TEST(OuterWind, TakesAsManySubstepsAfterALoad) {
    auto outer = shared(test::with(around(), [](Config& config) { config.ticks.hz = 5.0; }));
    (void)test::added(*outer,
                      DirectionalMotor{.position = {0.0, 3.0, 0.0}, .region = Sphere{6.0f}, .law = Drive{.speed = 60.0f}});
    Wind inner = within(outer, test::with(inside(), [](Config& config) { config.cell_size = 0.25f; }));
    const auto body = inner.obstacles().add({.position = {0.0, 1.0, 0.0}, .shape = Sphere{0.4f}});
    ASSERT_TRUE(body);
    const auto tick = [&](Wind& large, Wind& small, int n) {
        (void)large.advance(1.0 / 30.0);
        EXPECT_TRUE(small.obstacles().move(*body, {0.02 * n, 1.0, 0.0}));
        return small.advance(1.0 / 30.0).last.substeps;
    };
    for (int n = 0; n < 28; ++n)
        (void)tick(*outer, inner, n);
    const auto again = std::make_shared<Wind>(*Wind::load(*outer->save()));
    Wind loaded = *Wind::load(*inner.save(), {}, again);
    for (int n = 28; n < 33; ++n) {
        const int wanted = tick(*outer, inner, n);
        EXPECT_GT(wanted, 1);
        EXPECT_EQ(tick(*again, loaded, n), wanted) << n;
    }
    EXPECT_EQ(test::largest_apart(inner.field(), loaded.field()), 0.0);
}

TEST(OuterWind, IsTheSameWhetherItIsReadOrNot) {
    for (const bool jumps : {false, true}) {
        const auto outer = shared(around());
        (void)test::added(*outer, k_fan);
        Wind read = within(outer, inside()), unread = within(outer, inside());
        for (int n = 0; n < 40; ++n) {
            test::take_steps(*outer, 1, 1.0 / 30.0);
            for (Wind* wind : {&read, &unread}) {
                if (n == 30 && jumps) {
                    ASSERT_TRUE(wind->follow({-40.0, 0.0, 0.0}) && wind->follow({3.0, 0.0, 0.0}));
                } else if (n == 30) {
                    wind->reset();
                }
            }
            if (n >= 30)
                (void)read.velocity({0.0, 2.0, 0.0});
            for (Wind* wind : {&read, &unread})
                test::take_steps(*wind, 1, 1.0 / 30.0);
        }
        EXPECT_EQ(test::largest_apart(read.field(), unread.field()), 0.0) << jumps;
    }
}

TEST(OuterWind, LeavesNoPressureBehindAReset) {
    const auto outer = shared(around()), fresh = shared(around());
    Wind inner = within(outer, inside()), first = within(fresh, inside());
    const MotorId fan = test::added(*outer, k_fan);
    for (int n = 0; n < 60; ++n) {
        (void)outer->advance(1.0 / 30.0);
        (void)inner.advance(1.0 / 30.0);
    }
    ASSERT_TRUE(outer->motors().remove(fan));
    for (Wind* wind : {outer.get(), &inner})
        wind->reset();
    for (int n = 0; n < 6; ++n)
        for (Wind* wind : {outer.get(), &inner, fresh.get(), &first})
            (void)wind->advance(1.0 / 30.0);
    EXPECT_LE(test::largest_apart(inner.field(), first.field()), 1e-6);
}

// A garden stands still in a landscape; the window of a player walks out of it. There it has the landscape's wind, as one without
// the garden has.
TEST(OuterWind, OfAMiddleLevelThatEndsIsTheNext) {
    const auto land = shared({.cells = {40, 8, 40}, .cell_size = 4.0f, .ambient = {6.0f, 0.0f, 0.0f}, .ticks = {.hz = 10.0}});
    (void)test::added(*land, DirectionalMotor{.position = {24.0, 0.0, 0.0},
                                              .direction = {0.0f, 0.0f, 1.0f},
                                              .region = Sphere{9.0f},
                                              .law = Drive{.speed = 9.0f}});
    const auto garden =
        std::make_shared<Wind>(within(land, {.cells = {16, 8, 16}, .cell_size = 2.0f, .follow_axes = glm::bvec3(false)}));
    Wind walks = within(garden, {.cells = {12, 8, 12}}), alone = within(land, {.cells = {12, 8, 12}});
    for (int n = 0; n < 240; ++n)
        for (Wind* wind : {land.get(), garden.get(), &walks, &alone}) {
            if (wind == &walks || wind == &alone) {
                ASSERT_TRUE(wind->follow({0.1 * n, 0.0, 0.0}));
            }
            (void)wind->advance(1.0 / 20.0);
        }
    // [m/s] Across the mean wind, where the middle level alone has none.
    const float expected = alone.velocity({23.9, 0.0, 0.0}).z;
    EXPECT_LT(expected, -3.0f);
    WINDROW_EXPECT_FIGURE("outer_wind.beyond_a_middle_level", std::abs(walks.velocity({23.9, 0.0, 0.0}).z - expected), 0.6);
}

// Random levels and what a host calls between frames. Saved and loaded they go on with the same bits, and about another origin they are
// the same wind.
TEST(OuterWind, OfRandomStoriesGoesOnAfterALoadAndInAnotherOrigin) {
    using Levels = std::vector<std::shared_ptr<Wind>>; // outermost first
    const auto levels_of = [](unsigned seed) {
        std::mt19937 chance(seed);
        const auto below = [&](int count) { return static_cast<int>(chance() % static_cast<unsigned>(count)); };
        const Boundaries sides = below(3) != 0 ? Boundaries::open_over_floor() : Boundaries::all(BoundaryKind::open);
        constexpr glm::ivec3 k_cells[] = {{18, 8, 18}, {14, 8, 14}, {12, 6, 12}};
        Levels made;
        float cell_size = 4.0f;
        for (int n = 0, count = 2 + below(2); n < count; ++n, cell_size /= below(3) == 0 ? 1.0f : 2.0f) {
            Config config{.cells = k_cells[n], .cell_size = cell_size, .boundaries = sides};
            if (below(2) == 0)
                config.ticks = {.hz = 10.0 * (n + 1)};
            config.pressure_solves = below(3) == 0 ? 2 : config.pressure_solves;
            config.relaxation_time = below(4) == 0 ? 5.0f : config.relaxation_time;
            if (n == 0) {
                config.ambient = {static_cast<float>(below(17) - 8), 0.0f, static_cast<float>(below(17) - 8)};
                config.gusts = {.intensity = below(2) == 0 ? 0.3f : 0.0f, .length = 12.0f};
            }
            made.push_back(n == 0 ? shared(config) : std::make_shared<Wind>(within(made.back(), config)));
        }
        for (const auto& wind : made) {
            const double bottom = wind->origin().y;
            (void)test::added(
                *wind,
                DirectionalMotor{.position = {-5.0, bottom + 3.0, 1.0}, .region = Sphere{4.0f}, .law = Drive{.speed = 9.0f}});
            if (below(2) == 0) {
                EXPECT_TRUE(wind->obstacles().add({.position = {4.0, bottom + 2.0, 2.0}, .shape = Block{{1.5f, 3.0f, 2.0f}}}));
            }
        }
        return made;
    };
    const auto frame = [](const Levels& levels, unsigned seed, glm::dvec3 origin) {
        std::mt19937 chance(seed);
        const auto below = [&](int count) { return static_cast<int>(chance() % static_cast<unsigned>(count)); };
        const glm::dvec3 walked = origin + glm::dvec3(below(5) - 2, 0.0, 0.4 * below(9));
        const int what = below(10);
        if (what == 0) {
            EXPECT_TRUE(levels.front()->set_ambient({static_cast<float>(below(9) - 4), 0.0f, 2.0f}));
        }
        for (const auto& wind : levels) {
            if (what == 1)
                wind->reset();
            const bool walks = what == 2 || (what == 3 && wind == levels.back());
            EXPECT_TRUE(!walks || wind->follow(walked));
        }
        const double dt = below(2) == 0 ? 1.0 / 60.0 : 1.0 / 23.0;
        for (const auto& wind : levels)
            (void)wind->advance(dt);
    };
    double moved = 0.0;
    for (unsigned seed = 0; seed < static_cast<unsigned>(test::sampled(200, 8)); ++seed) {
        const Levels levels = levels_of(seed), elsewhere = levels_of(seed);
        Levels loaded;
        constexpr glm::dvec3 k_origin{256.0, 0.0, -128.0};
        double largest = 1e-9, apart = 0.0;
        for (unsigned n = 0; n < 24; ++n) {
            if (n == 6 + seed % 9) {
                for (const auto& wind : levels) {
                    auto again = Wind::load(*wind->save(), {}, loaded.empty() ? nullptr : loaded.back());
                    ASSERT_TRUE(again) << again.error();
                    loaded.push_back(std::make_shared<Wind>(*std::move(again)));
                }
                for (const auto& wind : elsewhere)
                    ASSERT_TRUE(wind->shift_origin(k_origin));
            }
            frame(levels, 1000 * seed + n, {});
            frame(elsewhere, 1000 * seed + n, loaded.empty() ? glm::dvec3(0.0) : k_origin);
            if (loaded.empty())
                continue;
            frame(loaded, 1000 * seed + n, {});
            for (std::size_t level = 0; level < levels.size(); ++level)
                for (int point = 0; point < 64; ++point) {
                    const glm::dvec3 part(point % 4, point / 4 % 4, point / 16);
                    const glm::dvec3 place =
                        levels[level]->origin() + glm::dvec3(levels[level]->box().size()) * (0.45 * part - 0.1);
                    const glm::vec3 wind = levels[level]->velocity(place);
                    ASSERT_EQ(wind, loaded[level]->velocity(place)) << seed << ", frame " << n << ", level " << level;
                    apart = std::max(apart, double(glm::length(wind - elsewhere[level]->velocity(place + k_origin))));
                    largest = std::max(largest, double(glm::length(wind)));
                }
        }
        moved = std::max(moved, apart / largest);
    }
    WINDROW_EXPECT_FIGURE("outer_wind.stories.in_another_origin", moved, 2e-4);
}

// A box that repeats is around every place.
TEST(OuterWind, IsFollowedFarWhereItRepeats) {
    const auto outer = shared({.cells = {16, 8, 16},
                               .boundaries = {.x_low = {BoundaryKind::periodic}, .x_high = {BoundaryKind::periodic}},
                               .ambient = {5.0f, 0.0f, 0.0f}});
    (void)test::added(*outer, DirectionalMotor{.position = {2.0, 0.0, 0.0}, .law = Drive{.speed = 7.0f}});
    test::take_steps(*outer, 20, 0.05);
    for (const double place : {9000.0, -9008.0, 1.6e9}) {
        Wind here = within(outer, {.cells = {8, 4, 8}}), there = within(outer, {.cells = {8, 4, 8}});
        ASSERT_TRUE(here.follow({8.0, 0.0, 0.0}) && there.follow({place + 8.0, 0.0, 0.0}));
        for (Wind* wind : {&here, &there})
            test::take_steps(*wind, 3, 0.05);
        if (std::fmod(place, 16.0) == 0.0) {
            EXPECT_LE(test::largest_apart(here.field(), there.field()), 1e-4) << place;
        }
    }
}

// Cells that the outer wind repairs in its next step do not come in before.
TEST(OuterWind, KeepsAirThatIsNoNumberOutside) {
    const auto outer = shared(around());
    outer->set_velocity([](glm::dvec3 at) { return glm::vec3(at.x < 0.0 ? std::nanf("") : 2.0f, 0.0f, 0.0f); });
    Wind inner = within(outer, inside());
    for (int n = 0; n < 5; ++n)
        (void)inner.step(1.0 / 30.0);
    EXPECT_TRUE(std::ranges::all_of(inner.field(), [](glm::vec4 u) { return std::isfinite(u.x + u.y + u.z); }));
}

TEST(OuterWind, RejectsWhatItCannotBe) {
    const auto outer = shared(around());
    const auto error = [&](const std::function<void(Config&)>& change) {
        return Wind::create(test::with(inside(), change), outer).error();
    };
    EXPECT_NE(error([](Config& config) { config.ambient.x = 1.0f; }).find("ambient, profile or gusts"), std::string::npos);
    EXPECT_NE(error([](Config& config) { config.profile = LogProfile{}; }).find("ambient, profile or gusts"), std::string::npos);
    EXPECT_NE(error([](Config& config) { config.scheme = Scheme::stable_fluids; }).find("second_order"), std::string::npos);
    const std::string beyond = error([](Config& config) { config.centre.x = 15.0; });
    EXPECT_NE(beyond.find("from 9 to 21 m along x"), std::string::npos) << beyond;
    EXPECT_NE(error([](Config& config) { config.cells.y = 20; }).find("along y"), std::string::npos);
    const auto tiny = shared({.cells = {16, 16, 16},
                              .cell_size = 0.012f,
                              .boundaries = {.x_low = {BoundaryKind::periodic}, .x_high = {BoundaryKind::periodic}}});
    const Config wide{.cells = {64, 4, 4}};
    const auto saved = within(shared({.cells = {80, 16, 16}}), wide).save();
    EXPECT_NE(Wind::load(*saved, {}, tiny).error().find("the box spans 5753 cells"), std::string::npos);
    const std::string many = Wind::create(wide, tiny).error();
    EXPECT_NE(many.find("the box spans 5753 cells of its outer wind along x: give larger outer cells."), std::string::npos)
        << many;
}

} // namespace
} // namespace windrow
