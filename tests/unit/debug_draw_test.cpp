// Lines that a host draws over its picture are where the wind has its things.
#include "fluid/debug_draw.h"
#include "fluid/wind.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace windrow {
namespace {

struct DebugLine {
    glm::dvec3 from, to;
};

struct DebugPicture {
    std::vector<DebugLine> lines{};
    std::vector<std::string> words{};
};

constexpr DebugDraw k_nothing{.box = false, .motors = false, .obstacles = false};

DebugPicture picture_of(const Wind& wind, const DebugDraw& settings) {
    DebugPicture picture;
    debug_draw(wind, wind, settings,
               {.line =
                    [&](glm::dvec3 from, glm::dvec3 to, std::uint32_t) {
                        picture.lines.push_back({from, to});
                    },
                .text = [&](glm::dvec3, std::string_view words, std::uint32_t) { picture.words.emplace_back(words); }});
    return picture;
}

TEST(DebugDrawing, OfTheBoxHasTwelveEdgesAtItsFaces) {
    auto wind = Wind::create({.cells = {16, 8, 12}, .cell_size = 0.5f, .centre = {1e6, 10.0, 0.0}});
    ASSERT_TRUE(wind);
    DebugDraw settings = k_nothing;
    EXPECT_TRUE(picture_of(*wind, settings).lines.empty());
    settings.box = true;
    const auto lines = picture_of(*wind, settings).lines;
    ASSERT_EQ(lines.size(), 12u);
    double sum = 0.0;
    for (const DebugLine& line : lines) {
        sum += glm::distance(line.from, line.to);
        for (int axis = 0; axis < 3; ++axis) { // each end is a corner
            const double low = line.from[axis] - wind->origin()[axis];
            EXPECT_LT(std::min(std::abs(low), std::abs(low - static_cast<double>(wind->box().size()[axis]))), 1e-6);
        }
    }
    EXPECT_NEAR(sum, 4.0 * (8.0 + 4.0 + 6.0), 1e-6);
}

TEST(DebugDrawing, OfArrowsIsTheVelocityThere) {
    auto wind = Wind::create({.cells = {16, 8, 16}, .ambient = {5.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    DebugDraw settings = k_nothing;
    settings.arrows = true;
    settings.spacing = 4.0f;
    settings.height = 2.0f;
    const auto lines = picture_of(*wind, settings).lines;
    ASSERT_EQ(lines.size(), 3u * 4u * 4u); // a shaft and two barbs each
    for (std::size_t n = 0; n < lines.size(); n += 3) {
        EXPECT_NEAR(lines[n].from.y, wind->origin().y + 2.0, 1e-9);
        EXPECT_LT(glm::distance(lines[n].to - lines[n].from, glm::dvec3(2.0, 0.0, 0.0)), 1e-4); // 5 of 10 m/s along 4 m
    }
}

TEST(DebugDrawing, FollowsMotorsAndObstaclesThatMove) {
    auto wind = Wind::create({.cells = {16, 8, 16}});
    ASSERT_TRUE(wind);
    const auto fan = wind->motors().add(JetMotor{.position = {1.0, 2.0, 3.0}});
    const auto house = wind->obstacles().add({.position = {-2.0, 1.0, -2.0}, .shape = Block{{1.0f, 1.0f, 1.0f}}});
    ASSERT_TRUE(fan && house);
    DebugDraw settings = k_nothing;
    settings.motors = settings.obstacles = true;
    const auto touches = [&](glm::dvec3 place) {
        const auto lines = picture_of(*wind, settings).lines;
        return std::any_of(lines.begin(), lines.end(),
                           [&](const DebugLine& line) { return glm::distance(line.from, place) < 1e-6; });
    };
    EXPECT_TRUE(touches({1.0, 2.0, 3.0}));   // the arrow begins at the nozzle
    EXPECT_TRUE(touches({-3.0, 0.0, -3.0})); // a corner
    ASSERT_TRUE(wind->obstacles().move(*house, {0.0, 1.0, 0.0}));
    EXPECT_TRUE(touches({-1.0, 0.0, -1.0}));
    settings.motors = false;
    EXPECT_FALSE(touches({1.0, 2.0, 3.0}));
}

TEST(DebugDrawing, OfLoadsPointsWithTheWindAndNamesTheForce) {
    auto wind = Wind::create({.cells = {24, 8, 16}, .ambient = {8.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    ASSERT_TRUE(wind->obstacles().add({.position = {0.0, 0.0, 0.0}, .shape = Block{{1.5f, 2.0f, 2.0f}}}));
    for (int step = 0; step < 30; ++step)
        (void)wind->step(1.0 / 30.0);
    DebugDraw settings = k_nothing;
    settings.loads = true;
    const DebugPicture picture = picture_of(*wind, settings);
    ASSERT_EQ(picture.lines.size(), 3u);
    ASSERT_EQ(picture.words.size(), 1u);
    EXPECT_GT(picture.lines[0].to.x, picture.lines[0].from.x);
    EXPECT_TRUE(picture.words[0].ends_with(" N"));
}

} // namespace
} // namespace windrow
