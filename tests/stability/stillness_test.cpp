// Air left alone: open sides must not feed it, and the settling time brings it to rest, the checkerboard too, which no
// collocated projection sees.

#include "fluid/wind.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_cells(32, 16, 32);

Wind made(const Sides& sides, float settling_time, Scheme scheme = Scheme::second_order) {
    auto wind =
        Wind::create({.cells = k_cells, .sides = sides, .viscosity = 0.0f, .settling_time = settling_time, .scheme = scheme});
    EXPECT_TRUE(wind) << wind.error();
    return *std::move(wind);
}

double rms(const Wind& wind) {
    return std::sqrt(2.0 * energy_of(wind.field()) / double(wind.field().size()));
}

// Largest energy over the run, relative to the start's.
double five_minutes(Wind& wind, double rate_hz) {
    EXPECT_TRUE(wind.set_velocity(projected(white_noise(k_cells, 1.0f, 23), wind.box())));
    const double start = energy_of(wind.field());
    double largest = 0.0;
    for (int n = 0; n < static_cast<int>(300.0 * rate_hz); ++n)
        if (const double energy = wind.step(1.0 / rate_hz).energy / start; !(energy <= largest))
            largest = energy;
    return largest;
}

// 18,000 steps of 1/60 s. Edge copies instead of ambient beyond the sides fail this by a factor of 8.
TEST(Stillness, FiveMinutesWithOpenSidesNeverGainEnergy) {
    Wind open = made(Sides{}, 0.0f);
    WINDROW_EXPECT_FIGURE("still_open_60_hz_energy", five_minutes(open, 60.0), 1.001);
    figure("still_open_60_hz_rms_mps_at_end", rms(open));
    Wind floor = made(Sides::open_over_floor(), 0.0f);
    WINDROW_EXPECT_FIGURE("still_floor_30_hz_energy", five_minutes(floor, 30.0), 1.001); // 9,000 steps
    figure("still_floor_30_hz_rms_mps_at_end", rms(floor));
    Wind ring = made(Sides::all(SideKind::periodic), 0.0f);
    WINDROW_EXPECT_FIGURE("still_periodic_30_hz_energy", five_minutes(ring, 30.0), 1.001);
    figure("still_periodic_30_hz_rms_mps_at_end", rms(ring));
    Wind room = made(Sides::all(SideKind::no_slip), 0.0f);
    WINDROW_EXPECT_FIGURE("still_walls_30_hz_energy", five_minutes(room, 30.0), 1.001);
    figure("still_walls_30_hz_rms_mps_at_end", rms(room));
}

// Not only noise: a stream that crosses the sides, in steps so short that only the projection acts.
TEST(Stillness, StreamsThroughOpenSidesGainNoEnergy) {
    for (const auto& [name, sides] : {std::pair{"open", Sides{}}, {"floor", Sides::open_over_floor()}})
        for (const double dt : {0.001, 1.0 / 60.0, 0.5}) {
            Wind wind = made(sides, 0.0f);
            ASSERT_TRUE(wind.set_velocity(projected(shear_layer(k_cells, 1.0f, 25), wind.box())));
            const double start = energy_of(wind.field());
            double largest = 0.0;
            for (int n = 0; n < 600; ++n)
                if (const double energy = wind.step(dt).energy / start; !(energy <= largest))
                    largest = energy;
            WINDROW_EXPECT_FIGURE(std::string("stream_") + name + "_dt_" + std::to_string(dt).substr(0, 5) + "_energy", largest,
                                  1.001);
        }
}

// With the default of 20 s, 300 s are 15 times e: 3e-7 of the start, and float's rounding.
TEST(Stillness, TheSettlingTimeBringsItToRest) {
    for (const auto& [name, sides] :
         {std::pair{"open", Sides{}}, {"periodic", Sides::all(SideKind::periodic)}, {"walls", Sides::all(SideKind::free_slip)}}) {
        Wind wind = made(sides, 20.0f);
        const std::string full = std::string("settling_") + name;
        WINDROW_EXPECT_FIGURE(full + "_energy", five_minutes(wind, 30.0), 1.001);
        WINDROW_EXPECT_FIGURE(full + "_rms_mps_after_300_s", rms(wind), 1e-5);
    }
}

// About a breeze too: what settles is the difference from ambient. A step takes dt/T of it, so what is less than a rounding
// of the wind over dt/T stays.
TEST(Stillness, ABreezeComesBackToItself) {
    const glm::vec3 ambient(0.5f, 0.0f, 0.2f);
    auto wind = Wind::create({.cells = k_cells, .ambient = ambient});
    ASSERT_TRUE(wind);
    ASSERT_TRUE(wind->set_velocity(white_noise(k_cells, 1.0f, 24)));
    const double dt = 0.1;
    for (int n = 0; n < 3'000; ++n)
        wind->step(dt);
    double worst = 0.0;
    for (const glm::vec4& u : wind->field())
        worst = std::max(worst, double(glm::length(glm::vec3(u) - ambient)));
    const double rounding = 6e-8 * double(glm::length(ambient)) * 20.0 / dt;
    WINDROW_EXPECT_FIGURE("breeze_largest_difference_mps_after_300_s", worst, 4.0 * rounding);
}

// 0.01 m/s of (-1)^(i+j+k) in still air, after 60 s.
double checkerboard_left(const Sides& sides, float settling_time) {
    Wind wind = made(sides, settling_time);
    Field field(wind.field().size());
    for (int k = 0; k < k_cells.z; ++k)
        for (int j = 0; j < k_cells.y; ++j)
            for (int i = 0; i < k_cells.x; ++i)
                field[wind.box().index(i, j, k)] = glm::vec4(glm::vec3((i + j + k) % 2 == 0 ? 0.01f : -0.01f), 0.0f);
    EXPECT_TRUE(wind.set_velocity(field));
    const double start = rms(wind);
    for (int n = 0; n < 3'600; ++n)
        wind.step(1.0 / 60.0);
    return rms(wind) / start;
}

TEST(Stillness, TheCheckerboardSettles) {
    for (const auto& [name, sides] :
         {std::pair{"open", Sides{}}, {"walls", Sides::all(SideKind::free_slip)}, {"periodic", Sides::all(SideKind::periodic)}}) {
        const double alone = figure(std::string("checkerboard_left_without_settling_") + name, checkerboard_left(sides, 0.0f));
        const double settled = checkerboard_left(sides, 20.0f);
        WINDROW_EXPECT_FIGURE(std::string("checkerboard_left_") + name, settled, 1.01 * std::exp(-60.0 / 20.0));
        EXPECT_LT(settled, alone);
    }
}

} // namespace
