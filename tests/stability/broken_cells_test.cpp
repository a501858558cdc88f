// NaN, infinity, speeds and steps that a float can just hold: harmless after one step.

#include "fluid/wind.h"
#include "tests/fields.h"

#include <cstddef>
#include <gtest/gtest.h>
#include <limits>

namespace {

using namespace windrow;
using namespace windrow::test;

Wind made(const Config& config) {
    auto wind = Wind::create(config);
    EXPECT_TRUE(wind) << wind.error();
    return *std::move(wind);
}

TEST(BrokenCells, DoNoMoreThanAmbientOnesWould) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinity, -infinity}) {
        Wind wind = made({.ambient = {2.0f, 0.0f, 0.0f}}), mended = made({.ambient = {2.0f, 0.0f, 0.0f}});
        Field field = smooth_noise({32, 16, 32}, 3.0f, 37);
        for (const std::size_t cell : {std::size_t{0}, std::size_t{5000}, field.size() - 1})
            field[cell] = {bad, 1.0f, bad, 0.0f};
        ASSERT_TRUE(wind.set_velocity(field));
        for (const std::size_t cell : {std::size_t{0}, std::size_t{5000}, field.size() - 1})
            field[cell] = {2.0f, 0.0f, 0.0f, 0.0f};
        ASSERT_TRUE(mended.set_velocity(field));
        for (int n = 0; n < 10; ++n) {
            EXPECT_EQ(wind.step(0.05).repaired_cells, n == 0 ? 3 : 0);
            mended.step(0.05);
            ASSERT_TRUE(all_finite(wind.field()));
            ASSERT_EQ(cells_that_differ(wind.field(), mended.field()), 0u);
        }
    }
}

TEST(BrokenCells, HugeFiniteSpeedsStayFinite) {
    for (const float huge : {1e6f, 1e12f, 1e18f, 1e20f, 1e30f, 3e38f})
        for (const double dt : {1e-6, 1.0 / 60.0, 1.0}) {
            Wind wind = made({.cells = {12, 8, 10}});
            Field field = white_noise({12, 8, 10}, 1.0f, 38);
            for (glm::vec4& u : field)
                u *= huge;
            ASSERT_TRUE(wind.set_velocity(field));
            bool finite = true;
            for (int n = 0; n < 5; ++n) {
                wind.step(dt);
                finite = finite && all_finite(wind.field());
            }
            EXPECT_TRUE(finite) << huge << " m/s, dt " << dt;
        }
}

TEST(BrokenCells, StepsOfAnyFiniteLengthStayFinite) {
    for (const double dt : {1e-37, 1e-20, 1e-9, 1e3, 1e6, 1e12, 1e20, 1e30, 1e38}) {
        Wind wind = made({.cells = {12, 8, 10}, .ambient = {3.0f, 0.0f, 1.0f}, .viscosity = 1e-3f});
        ASSERT_TRUE(wind.motors().add(DirectionalMotor{.law = Drive{20.0f, 1e6f}}));
        ASSERT_TRUE(wind.motors().add(DirectionalMotor{.position = {2.0, 0.0, 0.0}, .law = Force{10.0f}}));
        const auto body = wind.motors().add(WakeMotor{});
        ASSERT_TRUE(body);
        bool finite = true;
        for (int n = 0; n < 5; ++n) {
            ASSERT_TRUE(wind.motors().move(*body, {0.3 * n, 0.0, 0.0}));
            wind.step(dt);
            finite = finite && all_finite(wind.field());
        }
        EXPECT_TRUE(finite) << "dt " << dt;
    }
}

} // namespace
