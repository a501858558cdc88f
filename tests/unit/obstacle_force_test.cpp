// Wind::force_on as a call: handles, places, sleep, snapshots.

#include "tests/unit/snapshot_session.h"
#include "tests/winds.h"

#include <numbers>

namespace {

using namespace windrow;
using namespace windrow::test;

bool same(const ObstacleForce& a, const ObstacleForce& b) {
    return a.force == b.force && a.moment == b.moment && a.pressure == b.pressure && a.in_box == b.in_box;
}

TEST(ObstacleForce, RejectsHandlesThatNameNone) {
    Wind wind = made({.cells = {8, 8, 8}}), other = made({.cells = {8, 8, 8}});
    const ObstacleId body = *wind.obstacles().add({}), stranger = *other.obstacles().add({});
    ASSERT_TRUE(wind.obstacles().remove(body));
    EXPECT_EQ(wind.force_on(body).error(),
              "obstacle 0 of generation 1 does not exist (removed, or never added): use the handle that add() returned.");
    ASSERT_TRUE(wind.obstacles().add({}));
    EXPECT_FALSE(wind.force_on(body)) << "of what came after it";
    EXPECT_FALSE(wind.force_on(ObstacleId{}));
    const ObstacleId first = *made({.cells = {8, 8, 8}}).obstacles().add({});
    EXPECT_EQ(other.force_on(first).error(),
              "obstacle 0 of generation 1 belongs to another wind: use the handle that add() of this one returned.");
    EXPECT_TRUE(other.force_on(stranger));
}

TEST(ObstacleForce, IsNoneWhereNoAirIsComputed) {
    Wind wind = made({.cells = {8, 8, 8}, .ambient = {5.0f, 0.0f, 0.0f}});
    const ObstacleId near = *wind.obstacles().add({}), far = *wind.obstacles().add({.position = {100.0, 0.0, 0.0}});
    EXPECT_FALSE(wind.force_on(near)->in_box) << "before the first step";
    (void)wind.step(0.05);
    EXPECT_TRUE(wind.force_on(near)->in_box);
    EXPECT_GT(wind.force_on(near)->force.x, 0.1f);
    EXPECT_TRUE(same(*wind.force_on(far), {}));
    ASSERT_TRUE(wind.obstacles().set(near, {.position = {50.0, 0.0, 0.0}}));
    (void)wind.step(0.05);
    EXPECT_TRUE(same(*wind.force_on(near), {})) << "it has left the box";
}

TEST(ObstacleForce, IsNoneWhileTheAirSleeps) {
    Wind wind = made({.cells = {8, 8, 8}});
    const ObstacleId ball = *wind.obstacles().add({.shape = Sphere{1.5f}});
    ASSERT_TRUE(wind.obstacles().move(ball, {1e-5, 0.0, 0.0}));
    (void)wind.step(0.1);
    EXPECT_NE(wind.force_on(ball)->force.x, 0.0f);
    EXPECT_TRUE(take_steps(wind, 5, 0.1).asleep);
    EXPECT_EQ(wind.force_on(ball)->force, glm::vec3(0.0f));
}

// A blast pushes what is beside it at once, and a door the way it opens.
TEST(ObstacleForce, ABlastPushesADoor) {
    Wind wind = made({.cells = {16, 12, 12}});
    const ObstacleId door =
        *wind.obstacles().add({.position = {2.3, 0.0, 0.0},
                               .orientation = glm::angleAxis(float(std::numbers::pi) / 2, glm::vec3(0.0f, 1.0f, 0.0f)),
                               .shape = Plate{{1.0f, 1.5f}}});
    (void)wind.step(0.02);
    added(wind, PressureMotor{.position = {-1.0, 0.0, 0.0}, .radius = 1.5f, .speed = 40.0f});
    (void)wind.step(0.02);
    const ObstacleForce force = *wind.force_on(door);
    EXPECT_GT(force.force.x, 500.0f);
    EXPECT_LT(std::abs(force.force.y) + std::abs(force.force.z), 0.05f * force.force.x);
}

TEST(ObstacleForce, IsPartOfASnapshot) {
    Wind first = made({.cells = {14, 10, 12}, .ambient = {4.0f, 0.0f, 1.0f}});
    const ObstacleId ids[] = {*first.obstacles().add({.shape = Plate{{2.0f, 2.0f}}}),
                              *first.obstacles().add({.position = {3.0, 1.0, -2.0}, .shape = Sphere{1.2f}})};
    added(first, OmniMotor{.position = {-3.0, 0.0, 0.0}});
    for (int n = 0; n < 4; ++n) {
        ASSERT_TRUE(first.obstacles().move(ids[0], {0.05 * n, 0.0, 0.0}));
        (void)first.step(0.05);
    }
    Wind again = loaded(*first.save());
    for (int n = 0; n < 4; ++n) {
        for (const ObstacleId id : ids)
            EXPECT_TRUE(same(*first.force_on(id), *again.force_on(id))) << "after " << n << " steps";
        (void)first.step(0.04);
        (void)again.step(0.04);
    }
}

} // namespace
