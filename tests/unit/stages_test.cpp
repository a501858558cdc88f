// Stages: what is off does nothing, and a stage whose parameter is off is the same as one switched off, to the bit.

#include "tests/winds.h"

namespace {

using namespace windrow;
using namespace windrow::test;

Wind noisy_wind(const Config& config) {
    Wind wind = made(config);
    EXPECT_TRUE(wind.set_velocity(white_noise(config.cells, 3.0f, 131)));
    return wind;
}

void blow(Wind& wind) {
    ASSERT_TRUE(wind.motors().add(DirectionalMotor{.law = Force{40.0f}, .turbulence = k_steady}));
    ASSERT_TRUE(wind.motors().add(DirectionalMotor{.position = {1.0, 1.0, 1.0}, .law = Drive{}, .turbulence = k_steady}));
    ASSERT_TRUE(wind.motors().add(WakeMotor{}));
}

/// Steps both and counts the cells that ever differ.
std::size_t difference(Wind a, Wind b, int steps = 10, double dt = 0.05) {
    std::size_t differing = 0;
    for (int n = 0; n < steps; ++n) {
        a.step(dt);
        b.step(dt);
        differing += cells_that_differ(a.field(), b.field());
    }
    return differing;
}

Config with(const std::function<void(Config&)>& change) {
    return test::with({.cells = {12, 9, 10}, .ambient = {1.0f, 0.5f, 0.0f}, .viscosity = 2.0f, .relaxation_time = 2.0f}, change);
}

TEST(Stages, WithAllOffNothingMoves) {
    Wind wind = noisy_wind(with([](Config& c) { c.stages = k_no_stages; }));
    blow(wind);
    const Field before = copy(wind.field());
    for (int n = 0; n < 20; ++n)
        EXPECT_EQ(wind.step(0.3).motors_in_reach, 0);
    EXPECT_EQ(cells_that_differ(before, wind.field()), 0u);
}

TEST(Stages, OffEqualsItsParameterOff) {
    for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids})
        for (const bool advection : {true, false}) {
            const auto base = [&](const std::function<void(Config&)>& change) {
                return noisy_wind(with([&](Config& c) {
                    c.scheme = scheme;
                    c.stages.advection = advection;
                    change(c);
                }));
            };
            const auto as_it_is = [](Config&) {};
            EXPECT_EQ(difference(base([](Config& c) { c.stages.relaxation = false; }),
                                 base([](Config& c) { c.relaxation_time = 0.0f; })),
                      0u);
            EXPECT_EQ(
                difference(base([](Config& c) { c.stages.diffusion = false; }), base([](Config& c) { c.viscosity = 0.0f; })), 0u);
            Wind off = base([](Config& c) { c.stages.sources = false; });
            blow(off);
            EXPECT_EQ(difference(std::move(off), base(as_it_is)), 0u);

            // And each of them does something where it is on.
            EXPECT_GT(difference(base(as_it_is), base([](Config& c) { c.stages.relaxation = false; })), 0u);
            EXPECT_GT(difference(base(as_it_is), base([](Config& c) { c.stages.diffusion = false; })), 0u);
            EXPECT_GT(difference(base(as_it_is), base([](Config& c) { c.stages.projection = false; })), 0u);
            Wind blown = base(as_it_is);
            blow(blown);
            EXPECT_GT(difference(std::move(blown), base(as_it_is)), 0u);
        }
}

TEST(Stages, WithoutAdvectionNothingIsCarried) {
    Wind wind = noisy_wind(with([](Config& c) {
        c.stages = k_no_stages;
        c.stages.sources = true;
    }));
    ASSERT_TRUE(wind.motors().add(
        DirectionalMotor{.position = {0.5, 0.5, 0.5}, .region = Sphere{2.0f}, .law = Force{64.0f}, .turbulence = k_steady}));
    const Field before = copy(wind.field());
    const Box& box = wind.box();
    const auto centre = box.index(6, 4, 5);
    wind.step(0.125);
    EXPECT_EQ(wind.field()[centre].x, before[centre].x + 8.0f) << "the whole f dt acts in the step, where it is";
    for (std::size_t n = 0; n < before.size(); ++n)
        EXPECT_TRUE(wind.field()[n].x >= before[n].x && wind.field()[n].y == before[n].y);
    EXPECT_EQ(wind.field()[0], before[0]);

    // With it the force is centred: half at departure, half at arrival, and nothing later.
    Wind centred = made({.cells = {16, 16, 16},
                         .boundaries = Boundaries::all(BoundaryKind::periodic),
                         .viscosity = 0.0f,
                         .relaxation_time = 0.0f});
    const MotorId id =
        added(centred, DirectionalMotor{.region = AlignedBox{glm::vec3(1e6f)}, .law = Force{1.0f}, .turbulence = k_steady});
    centred.step(0.25);
    EXPECT_NEAR(centred.field()[0].x, 0.25, 1e-6);
    ASSERT_TRUE(centred.motors().remove(id));
    centred.step(0.25);
    EXPECT_NEAR(centred.field()[0].x, 0.25, 1e-6) << "and no more";
}

TEST(Stages, SettlingAloneIsItsImplicitFactor) {
    const glm::vec3 ambient(1.0f, 0.5f, 0.0f);
    Wind wind = noisy_wind(with([](Config& c) {
        c.stages = k_no_stages;
        c.stages.relaxation = true;
    }));
    const Field before = copy(wind.field());
    const int steps = 30;
    take_steps(wind, steps, 0.1);
    const double factor = std::pow(1.0 / (1.0 + 0.1 / 2.0), steps);
    double worst = 0.0;
    for (std::size_t n = 0; n < before.size(); ++n) {
        const glm::dvec3 expected = glm::dvec3(ambient) + factor * (glm::dvec3(before[n]) - glm::dvec3(ambient));
        worst = std::max(worst, glm::length(glm::dvec3(wind.field()[n]) - expected));
    }
    WINDROW_EXPECT_FIGURE("settling_error", worst, 5e-6);
}

TEST(Stages, ProjectionAloneTakesTheDivergenceAndNothingElse) {
    Wind wind = noisy_wind(with([](Config& c) {
        c.stages = k_no_stages;
        c.stages.projection = true;
    }));
    Field by_hand = copy(wind.field());
    auto work = Workspace::create({.box = wind.box(), .ambient = {1.0f, 0.5f, 0.0f}});
    ASSERT_TRUE(work);
    project(*work, by_hand);
    wind.step(0.1);
    EXPECT_EQ(cells_that_differ(by_hand, wind.field()), 0u);
}

TEST(Stages, WithoutProjectionADivergentWindStaysSo) {
    Field source(12 * 9 * 10, glm::vec4(0.0f));
    for (int i = 0; i < 12; ++i) // a wave along x that only a projection takes away
        for (std::size_t row = 0; row < 90; ++row)
            source[row * 12 + static_cast<std::size_t>(i)].x = 0.1f * std::sin(0.523599f * (static_cast<float>(i) + 0.5f));
    const auto share_left = [&](bool projection) {
        Wind air = noisy_wind(with([&](Config& c) {
            c.stages = k_no_stages;
            c.stages.advection = true;
            c.stages.projection = projection;
            c.boundaries = Boundaries::all(BoundaryKind::periodic);
        }));
        EXPECT_TRUE(air.set_velocity(source));
        const double before = energy_of(air.field());
        take_steps(air, 3, 0.01);
        return energy_of(air.field()) / before;
    };
    EXPECT_GT(share_left(false), 0.99);
    EXPECT_LT(share_left(true), 0.05);
}

TEST(Stages, ResetIsAFreshSolverInPlace) {
    const Config config = with([](Config&) {});
    Wind used = noisy_wind(config);
    blow(used);
    take_steps(used, 5, 0.05);
    used.reset();
    Wind fresh = made(config);
    EXPECT_EQ(cells_that_differ(used.field(), fresh.field()), 0u);
    blow(fresh);
    EXPECT_EQ(difference(std::move(used), std::move(fresh)), 0u);
}

} // namespace
