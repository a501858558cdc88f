// The mean wind changed while it blows: the air of the box changes with it and keeps its own motion.

#include "tests/winds.h"

namespace {

using namespace windrow;
using namespace windrow::test;

TEST(Ambient, ANewWindReachesAllAirAtOnce) {
    for (const auto& [name, boundaries] :
         {std::pair{"open", Boundaries{}}, {"periodic", Boundaries::all(BoundaryKind::periodic)}}) {
        Wind wind =
            made({.cells = {16, 8, 12}, .boundaries = boundaries, .ambient = {1.0f, 0.0f, 0.0f}, .relaxation_time = 0.0f});
        wind.step(0.1);
        ASSERT_TRUE(wind.set_ambient({3.0f, -0.5f, 0.25f}));
        EXPECT_EQ(largest_off(wind.field(), {3.0f, -0.5f, 0.25f}), 0.0);
        take_steps(wind, 100, 0.1);
        WINDROW_EXPECT_FIGURE(std::string("ambient_uniform_after_a_change_") + name, largest_off(wind.field(), wind.ambient()),
                              1e-5);
    }
}

TEST(Ambient, TheAirKeepsItsOwnMotion) {
    Wind wind = made({.cells = {16, 8, 12}, .ambient = {1.0f, 2.0f, -1.0f}});
    ASSERT_TRUE(wind.set_velocity(white_noise({16, 8, 12}, 3.0f, 141)));
    wind.step(0.1);
    const Field before = copy(wind.field());
    const glm::vec3 change(0.3f, -1.7f, 4.1f);
    ASSERT_TRUE(wind.set_ambient(glm::vec3(1.0f, 2.0f, -1.0f) + change));
    double worst = 0.0;
    for (std::size_t n = 0; n < before.size(); ++n)
        worst = std::max(worst, double(glm::length(glm::vec3(wind.field()[n]) - glm::vec3(before[n]) - change)));
    WINDROW_EXPECT_FIGURE("ambient_change_of_each_cell", worst, 2e-6);
}

TEST(Ambient, ManyChangesLeaveNoTrace) {
    Wind wind = made({.cells = {8, 8, 8}});
    Random random(143);
    for (int n = 0; n < 2'000; ++n) {
        ASSERT_TRUE(wind.set_ambient(random.vector(10.0f)));
        wind.step(1.0 / 60.0);
    }
    WINDROW_EXPECT_FIGURE("ambient_after_2000_changes", largest_off(wind.field(), wind.ambient()),
                          1e-4); // a rounding of 10 m/s a change
}

TEST(Ambient, WallsDropWhatCannotPass) {
    Wind room = made({.cells = {8, 8, 8}, .boundaries = Boundaries::all(BoundaryKind::free_slip)});
    ASSERT_TRUE(room.set_velocity(white_noise({8, 8, 8}, 1.0f, 144)));
    const Field before = copy(room.field());
    ASSERT_TRUE(room.set_ambient({5.0f, 5.0f, 5.0f}));
    EXPECT_EQ(room.ambient(), glm::vec3(0.0f));
    EXPECT_EQ(cells_that_differ(before, room.field()), 0u);

    Wind floor = made({.cells = {8, 8, 8}, .boundaries = Boundaries::open_over_floor()});
    ASSERT_TRUE(floor.set_ambient({5.0f, 5.0f, 5.0f}));
    EXPECT_EQ(largest_off(floor.field(), {5.0f, 0.0f, 5.0f}), 0.0);
    ASSERT_TRUE(floor.set_boundaries(Boundaries{}));
    EXPECT_EQ(floor.ambient(), glm::vec3(5.0f)) << "the wind that was asked for, once nothing stands in its way";
}

TEST(Ambient, NewCellsGetTheNewWind) {
    Wind wind = made({.cells = {8, 8, 8}, .ambient = {1.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind.set_ambient({2.0f, 0.0f, 3.0f}));
    ASSERT_TRUE(wind.follow({3.0, 0.0, 0.0}));
    EXPECT_EQ(largest_off(wind.field(), {2.0f, 0.0f, 3.0f}), 0.0);
    EXPECT_EQ(wind.velocity({1e6, 0.0, 0.0}), glm::vec3(2.0f, 0.0f, 3.0f));
    wind.reset();
    EXPECT_EQ(largest_off(wind.field(), {2.0f, 0.0f, 3.0f}), 0.0);
}

} // namespace
