// Air left alone: open boundaries must not feed it, and the relaxation time brings it to rest.

#include "tests/stability/watch.h"

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_still_cells(32, 16, 32);

Wind still(const Boundaries& boundaries, float relaxation_time) {
    return made({.cells = k_still_cells, .boundaries = boundaries, .viscosity = 0.0f, .relaxation_time = relaxation_time});
}

double rms(const Wind& wind) {
    return std::sqrt(2.0 * energy_of(wind.field()) / double(wind.field().size()));
}

void start_with_noise(Wind& wind) {
    EXPECT_TRUE(wind.set_velocity(projected(white_noise(k_still_cells, 1.0f, 23), wind.box())));
}

// No force: no more energy than at the start. Speeds have the bound of white starts (hard_cases_test.cpp).
void expect_five_minutes_without_gain(const std::string& name, const Boundaries& boundaries, double rate_hz) {
    Wind wind = still(boundaries, 0.0f);
    start_with_noise(wind);
    Watch watch(wind);
    take_steps(watch, shortened(static_cast<int>(300.0 * rate_hz)), 1.0 / rate_hz);
    watch.judge(name, {1.001, 1.1});
    figure("stability/" + name + "/rms_mps_at_end", rms(wind));
}

// 18,000 steps of 1/60 s. Edge copies instead of ambient beyond the sides fail this by a factor of 8.
TEST(Stillness, FiveMinutesWithOpenSidesNeverGainEnergy) {
    expect_five_minutes_without_gain("still_open_60_hz", Boundaries{}, 60.0);
    expect_five_minutes_without_gain("still_floor_30_hz", Boundaries::open_over_floor(), 30.0); // 9,000 steps
}

TEST(Stillness, FiveMinutesInAClosedBoxNeverGainEnergy) {
    expect_five_minutes_without_gain("still_periodic_30_hz", Boundaries::all(BoundaryKind::periodic), 30.0);
    expect_five_minutes_without_gain("still_walls_30_hz", Boundaries::all(BoundaryKind::no_slip), 30.0);
}

// Not only noise: a stream that crosses the sides, in steps so short that only the projection acts.
TEST(Stillness, StreamsThroughOpenSidesGainNoEnergy) {
    for (const auto& [name, boundaries] : {std::pair{"open", Boundaries{}}, {"floor", Boundaries::open_over_floor()}})
        for (const double dt : {0.001, 1.0 / 60.0, 0.5}) {
            Wind wind = still(boundaries, 0.0f);
            ASSERT_TRUE(wind.set_velocity(projected(shear_layer(k_still_cells, 1.0f, 25), wind.box())));
            Watch watch(wind);
            watch.run(600, dt);
            watch.judge(std::string("stream_") + name + "_dt_" + std::to_string(dt).substr(0, 5), {1.001, 1.6});
        }
}

// With the default of 20 s, 300 s are 15 times e: 3e-7 of the start, and float's rounding.
TEST(Stillness, TheSettlingTimeBringsItToRest) {
    if (k_sanitized)
        GTEST_SKIP() << "only the whole time tells";
    for (const auto& [name, boundaries] : {std::pair{"open", Boundaries{}},
                                           {"periodic", Boundaries::all(BoundaryKind::periodic)},
                                           {"walls", Boundaries::all(BoundaryKind::free_slip)}}) {
        if (!whole_sweeps() && std::string_view(name) == "periodic") // has no boundary
            continue;
        Wind wind = still(boundaries, 20.0f);
        start_with_noise(wind);
        Watch watch(wind);
        take_steps(watch, 9'000, 1.0 / 30.0);
        const std::string full = std::string("settling_") + name;
        watch.judge(full, {1.001, 1.1});
        WINDROW_EXPECT_FIGURE("stability/" + full + "/rms_mps_after_300_s", rms(wind), 1e-5);
    }
}

// About a breeze too: what settles is the difference from ambient. A step takes dt/T of it, so what is less than a rounding
// of the wind over dt/T stays.
TEST(Stillness, ABreezeComesBackToItself) {
    if (k_sanitized)
        GTEST_SKIP() << "only the whole time tells";
    const glm::vec3 ambient(0.5f, 0.0f, 0.2f);
    Wind wind = made({.cells = k_still_cells, .ambient = ambient});
    ASSERT_TRUE(wind.set_velocity(white_noise(k_still_cells, 1.0f, 24)));
    Watch watch(wind);
    const double dt = 0.1;
    take_steps(watch, 3'000, dt);
    watch.judge("breeze_over_noise", {1.001, 1.1}); // a start of 1 m/s, above the breeze
    const double rounding = 6e-8 * double(glm::length(ambient)) * 20.0 / dt;
    WINDROW_EXPECT_FIGURE("stability/breeze_over_noise/largest_difference_mps_after_300_s", largest_off(wind.field(), ambient),
                          4.0 * rounding);
}

} // namespace
