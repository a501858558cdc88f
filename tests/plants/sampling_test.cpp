// The wind that plants sample fades to the ambient wind at the edge of the box without a step. tests/parity/wind_shader_test.cpp
// compares textures and queries.
#include "fluid/wind.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vector>

namespace windrow {
namespace {

TEST(PlantSampling, TheWindFadesToTheAmbientWindWithoutAStep) {
    auto wind = Wind::create({.cells = {16, 12, 16}, .ambient = {2.0f, 0.0f, -1.0f}});
    ASSERT_TRUE(wind) << wind.error();
    ASSERT_TRUE(wind->set_velocity(test::smooth_noise(wind->box().cells, 8.0f, 1)));
    wind->step(1.0 / 60.0);
    const double speed = test::largest_speed(wind->field());
    double most = 0.0;
    for (const glm::dvec3 way :
         {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0), glm::normalize(glm::dvec3(1.0, 0.3, 0.8))}) {
        std::vector<glm::dvec3> places;
        for (int mm = 0; mm < 16'000; ++mm)
            places.push_back(1e-3 * mm * way);
        std::vector<glm::vec3> winds(places.size());
        wind->velocity(places, winds);
        for (std::size_t n = 1; n < winds.size(); ++n)
            most = std::max(most, static_cast<double>(glm::length(winds[n] - winds[n - 1])) / speed);
        EXPECT_EQ(winds.back(), wind->ambient());
    }
    WINDROW_EXPECT_FIGURE("plants/sampling/largest_step_a_millimetre_over_largest_speed", most, 0.01);
}

} // namespace
} // namespace windrow
