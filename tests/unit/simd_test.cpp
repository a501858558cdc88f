// The hot loops exist once a SIMD level: each gives one result for any number of threads, and they differ by rounding alone.

#include "fluid/simd.h"
#include "fluid/thread_pool.h"
#include "tests/winds.h"

namespace {

using namespace windrow;
using namespace windrow::test;

std::vector<Simd> levels() {
    std::vector<Simd> found;
    for (const Simd level : {Simd::baseline, Simd::avx2, Simd::avx512})
        if (runs(level))
            found.push_back(level);
    return found;
}

Field storm(Simd level, ParallelFor parallel_for, int steps) {
    Wind wind = made({.cells = {21, 12, 18},
                      .ambient = {2.0f, 0.0f, 1.0f},
                      .gusts = {.intensity = 0.3f},
                      .simd = level,
                      .parallel_for = parallel_for});
    EXPECT_TRUE(wind.set_velocity(smooth_noise({21, 12, 18}, 4.0f, 201)));
    added(wind, VortexMotor{});
    added(wind, JetMotor{.position = {-6.0, 0.0, 0.0}});
    added(wind, PressureMotor{.position = {3.0, 0.0, 3.0}, .speed = 6.0f});
    for (int n = 0; n < steps; ++n) {
        EXPECT_TRUE(wind.follow({0.07 * n, 0.0, 0.0}));
        wind.step(1.0 / 60.0);
    }
    return copy(wind.field());
}

TEST(SimdLevels, EachGivesOneResultForAnyNumberOfThreads) {
    for (const Simd level : levels()) {
        const Field serial = storm(level, {}, 20);
        for (const int threads : {2, 3, 5}) {
            ThreadPool pool(threads);
            EXPECT_EQ(cells_that_differ(serial, storm(level, pool.parallel_for(), 20)), 0u)
                << name_of(level) << ", " << threads << " threads";
        }
    }
}

TEST(SimdLevels, DifferByRoundingAlone) {
    const Field reference = storm(Simd::baseline, {}, 1);
    const double speed = largest_speed(reference);
    for (const Simd level : levels()) {
        WINDROW_EXPECT_FIGURE(std::string("simd_one_step_off_baseline_") + name_of(level),
                              largest_apart(storm(level, {}, 1), reference) / speed, 1e-5);
    }
}

TEST(SimdLevels, TheBestIsOneOfThem) {
    EXPECT_TRUE(runs(Simd::best));
    EXPECT_TRUE(runs(Simd::baseline));
    EXPECT_EQ(cells_that_differ(storm(Simd::best, {}, 5), storm(levels().back(), {}, 5)), 0u);
    EXPECT_STREQ(name_of(Simd::best), name_of(levels().back()));
}

TEST(SimdLevels, OneThatTheMachineLacksIsRejected) {
    if (runs(Simd::avx2) && runs(Simd::avx512))
        GTEST_SKIP() << "this machine runs them all";
    for (const Simd level : {Simd::avx2, Simd::avx512}) {
        if (runs(level))
            continue;
        const auto rejected = Wind::create({.simd = level});
        ASSERT_FALSE(rejected);
        EXPECT_NE(rejected.error().find("which this machine does not run"), std::string::npos) << rejected.error();
    }
}

} // namespace
