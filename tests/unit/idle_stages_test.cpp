// Only what a scene needs: a stage that has nothing to do runs no code. Told by the parallel loops that a step asks for, and by
// the stage's time, which is 0 to the bit where it did not begin.

#include "tests/winds.h"

namespace {

using namespace windrow;
using namespace windrow::test;

// Stands in for a host's job system and counts what it is asked for.
struct CountedLoops {
    int loops = 0;

    ParallelFor parallel_for() {
        return {.run =
                    [](void* context, int count, void (*task)(void*, int), void* argument) {
                        ++static_cast<CountedLoops*>(context)->loops;
                        for (int index = 0; index < count; ++index)
                            task(argument, index);
                    },
                .context = this};
    }
};

// The loops of each stage.
constexpr int k_guard = 1, k_advection = 2, k_projection = 5, k_report = 1;
constexpr int k_step = k_guard + k_advection + k_projection + k_report;

struct CountedStep {
    int loops = 0;
    Diagnostics step;
};

// The third step of a scene: what is made again at first is made.
template <class Change>
CountedStep third_step(Config config, const Change& change) {
    CountedLoops counter;
    config.cells = {24, 12, 20};
    config.parallel_for = counter.parallel_for();
    Wind wind = made(config);
    EXPECT_TRUE(wind.set_velocity(smooth_noise(config.cells, 2.0f, 51)));
    change(wind);
    take_steps(wind, 2, 1.0 / 60.0);
    counter.loops = 0;
    const Diagnostics step = wind.step(1.0 / 60.0);
    return {counter.loops, step};
}
CountedStep third_step(const Config& config) {
    return third_step(config, [](Wind&) {});
}

TEST(IdleStages, AStepWithoutMotorsGustsAndViscosityIsGuardAdvectionProjectionAndReport) {
    const CountedStep plain = third_step({});
    EXPECT_EQ(plain.loops, k_step);
    EXPECT_EQ(plain.step.times_ms.diffusion, 0.0);
    EXPECT_EQ(plain.step.times_ms.ambient, 0.0);
    EXPECT_EQ(third_step({.scheme = Scheme::stable_fluids}).loops, k_step);
    EXPECT_EQ(third_step({.interpolation = Interpolation::linear}).loops, k_step);
}

TEST(IdleStages, WhatIsTurnedOffRunsNothing) {
    EXPECT_EQ(third_step({.stages = {.projection = false}}).loops, k_step - k_projection);
    EXPECT_EQ(third_step({.stages = {.projection = false}}).step.divergence_rms, 0.0);
    const CountedStep still = third_step({.stages = {.advection = false}});
    EXPECT_EQ(still.loops, k_step - k_advection);
    EXPECT_EQ(still.step.times_ms.advection, 0.0);
    EXPECT_EQ(third_step({.stages = {.sources = false}}, [](Wind& wind) { EXPECT_TRUE(wind.motors().add(VortexMotor{})); }).loops,
              k_step);
}

TEST(IdleStages, ViscosityThatTheGridDoesNotResolveRunsNothing) {
    EXPECT_EQ(third_step({.viscosity = 1.5e-5f}).loops, k_step);
    EXPECT_GT(third_step({.viscosity = 0.5f}).loops, k_step);
    const CountedStep off = third_step({.viscosity = 0.5f, .stages = {.diffusion = false}});
    EXPECT_EQ(off.loops, k_step);
    EXPECT_EQ(off.step.times_ms.diffusion, 0.0);
}

TEST(IdleStages, MotorsThatDoNotReachTheBoxRunNothing) {
    const CountedStep far = third_step({}, [](Wind& wind) {
        EXPECT_TRUE(wind.motors().add(DirectionalMotor{.position = {1000.0, 0.0, 0.0}, .law = Force{}}));
        EXPECT_TRUE(wind.motors().add(OmniMotor{.position = {0.0, -500.0, 0.0}}));
    });
    EXPECT_EQ(far.step.motors_in_reach, 0);
    EXPECT_EQ(far.loops, k_step);
    const CountedStep near = third_step({}, [](Wind& wind) { EXPECT_TRUE(wind.motors().add(DirectionalMotor{.law = Force{}})); });
    EXPECT_EQ(near.step.motors_in_reach, 1);
    EXPECT_EQ(near.loops, k_step + 3) << "gathered once, and half its force on either side of the transport";
}

TEST(IdleStages, ASleepingStepRunsNothing) {
    CountedLoops counter;
    Wind wind = made({.relaxation_time = 0.05f, .parallel_for = counter.parallel_for()});
    Diagnostics step;
    for (int n = 0; n < 10 && !step.asleep; ++n)
        step = wind.step(1.0 / 60.0);
    ASSERT_TRUE(step.asleep);
    counter.loops = 0;
    wind.step(1.0 / 60.0);
    EXPECT_EQ(counter.loops, 0);
}

} // namespace
