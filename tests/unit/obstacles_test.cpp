// The list of obstacles: handles, capacity, what is rejected, and what a tick hands to the air.

#include "fluid/wind_state.h"
#include "tests/shapes.h"
#include "tests/winds.h"

#include <array>
#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace windrow;
using namespace windrow::test;
using detail::PlacedObstacle;

constexpr Window k_window{.cells = {64, 32, 64}, .cell_size = 1.0f};
const Boundaries k_open{};

ObstacleId placed_in(Obstacles& obstacles, const Obstacle& obstacle) {
    const auto id = obstacles.add(obstacle);
    EXPECT_TRUE(id) << id.error();
    return id ? *id : ObstacleId{};
}

std::vector<PlacedObstacle> ticked(Obstacles& obstacles, double duration = 1.0 / 60.0, const Window& window = k_window,
                                   const Boundaries& boundaries = k_open) {
    const auto placed = obstacles.tick(duration, window, boundaries);
    return {placed.begin(), placed.end()};
}

bool same(const PlacedObstacle& a, const PlacedObstacle& b) {
    return detail::same(a.shape, b.shape) && a.surface == b.surface && a.position == b.position && a.axes == b.axes &&
           a.velocity == b.velocity && a.spin == b.spin;
}
bool same(const std::vector<PlacedObstacle>& a, const std::vector<PlacedObstacle>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return same(x, y); });
}

glm::quat turned(double degrees, glm::dvec3 axis = {0.0, 1.0, 0.0}) {
    return glm::quat(glm::angleAxis(glm::radians(degrees), axis));
}

TEST(Obstacles, AHandleNamesItsObstacleUntilItIsRemoved) {
    Obstacles obstacles;
    const ObstacleId a = placed_in(obstacles, {.position = {1.0, 0.0, 0.0}}), b = placed_in(obstacles, {.shape = Sphere{2.0f}});
    EXPECT_FALSE(a == b);
    EXPECT_EQ(obstacles.count(), 2);
    ASSERT_NE(obstacles.find(a), nullptr);
    EXPECT_EQ(obstacles.find(a)->position.x, 1.0);
    EXPECT_TRUE(std::holds_alternative<Sphere>(obstacles.find(b)->shape));
    EXPECT_TRUE(obstacles.move(a, {5.0, 6.0, 7.0}));
    EXPECT_EQ(obstacles.find(a)->position, glm::dvec3(5.0, 6.0, 7.0));
    EXPECT_TRUE(obstacles.set(a, {.shape = Plate{}, .surface = Surface::no_slip}));
    EXPECT_TRUE(std::holds_alternative<Plate>(obstacles.find(a)->shape)) << "the shape may change";
    EXPECT_TRUE(obstacles.remove(a));
    EXPECT_EQ(obstacles.find(a), nullptr);
    EXPECT_NE(obstacles.find(b), nullptr);
    EXPECT_EQ(obstacles.count(), 1);
}

TEST(Obstacles, AStaleHandleIsRejectedAndMovesNoStranger) {
    Obstacles obstacles;
    const ObstacleId first = placed_in(obstacles, {});
    ASSERT_TRUE(obstacles.remove(first));
    const ObstacleId stranger = placed_in(obstacles, {.position = glm::dvec3(9.0)});
    ASSERT_EQ(stranger.slot, first.slot) << "the slot is used again, or this test shows nothing";
    for (const ObstacleId id : {first, ObstacleId{}, ObstacleId{.slot = 77, .generation = 1}}) {
        const auto rejected = obstacles.move(id, {});
        ASSERT_FALSE(rejected);
        EXPECT_EQ(rejected.error(), "obstacle " + std::to_string(id.slot) + " of generation " + std::to_string(id.generation) +
                                        " does not exist (removed, or never added): use the handle that add() returned.");
        EXPECT_FALSE(obstacles.move(id, {}, turned(30.0)));
        EXPECT_FALSE(obstacles.set(id, {}));
        EXPECT_FALSE(obstacles.remove(id));
        EXPECT_EQ(obstacles.find(id), nullptr);
    }
    EXPECT_EQ(obstacles.count(), 1);
    EXPECT_EQ(obstacles.find(stranger)->position, glm::dvec3(9.0));
}

TEST(Obstacles, AHandleOfAnotherWindIsRejected) {
    Wind wind = made({}), other = made({});
    const ObstacleId id = placed_in(wind.obstacles(), {}), stranger = placed_in(other.obstacles(), {});
    ASSERT_EQ(id.slot, stranger.slot);
    const auto moved = wind.obstacles().move(stranger, {1.0, 0.0, 0.0});
    ASSERT_FALSE(moved);
    EXPECT_EQ(moved.error(),
              "obstacle 0 of generation 1 belongs to another wind: use the handle that add() of this one returned.");
    EXPECT_FALSE(wind.obstacles().remove(stranger));
    EXPECT_TRUE(wind.obstacles().move({.slot = id.slot, .generation = id.generation}, {})) << "sent as slot and generation";
}

TEST(Obstacles, HoldTheirCapacityAndNoMore) {
    Obstacles obstacles;
    std::vector<ObstacleId> ids;
    for (std::uint32_t n = 0; n < Obstacles::k_capacity; ++n)
        ids.push_back(placed_in(obstacles, {.position = {double(n), 0.0, 0.0}}));
    EXPECT_EQ(obstacles.count(), 16384);
    const auto one_more = obstacles.add({});
    ASSERT_FALSE(one_more);
    EXPECT_EQ(one_more.error(), "there are already 16384 obstacles: remove some; a wind has at most 16384.");
    ASSERT_TRUE(obstacles.remove(ids[1234]));
    EXPECT_TRUE(obstacles.add({}));
    for (std::size_t n = 0; n < ids.size(); ++n)
        EXPECT_EQ(obstacles.remove(ids[n]).has_value(), n != 1234);
    EXPECT_EQ(obstacles.count(), 1);
}

TEST(Obstacles, RejectWhatIsNoBody) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::pair<Obstacle, std::string> bad[] = {
        {{.position = {0.0, nan, 0.0}}, "obstacle.position is (0, nan, 0) m: give each component -1e12 to 1e12 m."},
        {{.orientation = glm::quat(0, 0, 0, 0)},
         "obstacle.orientation is (0, 0, 0, 0): give a finite quaternion x, y, z, w that is not 0."},
        {{.orientation = glm::quat(k_nan, 0, 0, 1)},
         "obstacle.orientation is (0, 0, 1, nan): give a finite quaternion x, y, z, w that is not 0."},
        {{.shape = Sphere{0.0f}}, "obstacle.shape.sphere.radius is 0 m: give a number above 0, at most 1e6 m."},
        {{.shape = Block{{1.0f, -1.0f, 1.0f}}},
         "obstacle.shape.block.half_size is (1, -1, 1) m: give each component a number above 0, at most 1e6 m."},
        {{.shape = MeshShape{}}, "obstacle.shape.mesh has no mesh: give one that TriangleMesh::create made."},
        {{.shape = VoxelShape{}}, "obstacle.shape.voxels has no grid: give one that VoxelGrid::create made."},
        {{.shape = Ground{}}, "obstacle.shape.ground has no heights: give some that HeightMap::create made."},
        {{.shape = MeshShape{mesh_of(box_mesh({2.0f, 1.0f, 1.0f})), 0.0f}}, "obstacle.shape.mesh.scale is 0: give 1e-6 to 1e6."},
        {{.shape = MeshShape{mesh_of(box_mesh({2.0f, 1.0f, 1.0f})), 1e6f}},
         "obstacle.shape.mesh reaches 2e6 m from its origin: give at most 1e6 m."},
        {{.shape = VoxelShape{grid_of({.cells = {4, 1, 1}, .closed = {1, 1, 1, 1}}), 1e6f}},
         "obstacle.shape.voxels reaches 2e6 m from its origin: give at most 1e6 m."},
        {{.shape = Plate{{k_infinity, 1.0f}}},
         "obstacle.shape.plate.half_size is (inf, 1) m: give each component a number above 0, at most 1e6 m."},
        {{.surface = static_cast<Surface>(7)}, "obstacle.surface is 7: give free_slip or no_slip."},
    };
    Obstacles obstacles;
    const ObstacleId good = placed_in(obstacles, {});
    for (const auto& [obstacle, reason] : bad) {
        const auto id = obstacles.add(obstacle);
        ASSERT_FALSE(id);
        EXPECT_EQ(id.error(), reason);
        EXPECT_FALSE(obstacles.set(good, obstacle));
    }
    EXPECT_FALSE(obstacles.move(good, {nan, 0.0, 0.0}));
    EXPECT_FALSE(obstacles.move(good, {}, glm::quat(0, 0, 0, 0)));
    EXPECT_EQ(obstacles.count(), 1);
    EXPECT_EQ(obstacles.find(good)->position, glm::dvec3(0.0));
}

TEST(Obstacles, OrientationsAreNormalised) {
    Obstacles obstacles;
    const ObstacleId id = placed_in(obstacles, {.orientation = glm::quat(0, 0, 1e30f, 0)});
    EXPECT_EQ(obstacles.find(id)->orientation, glm::quat(0, 0, 1, 0));
    ASSERT_TRUE(obstacles.move(id, {}, glm::quat(3, 4, 0, 0)));
    EXPECT_NEAR(glm::length(obstacles.find(id)->orientation), 1.0f, 1e-6f);
}

TEST(Obstacles, ATickReturnsThoseThatMeetTheBox) {
    Obstacles obstacles;
    (void)placed_in(obstacles, {.position = {32.0, 16.0, 32.0}});
    (void)placed_in(obstacles, {.position = {-3.5, 16.0, 32.0}});                              // 2.5 m from the box to its face
    (void)placed_in(obstacles, {.position = {-2.5, 16.0, 32.0}});                              // 1.5 m
    (void)placed_in(obstacles, {.position = {-2.9, 10.0, 32.0}, .orientation = turned(45.0)}); // its edge: 1.49 m
    (void)placed_in(obstacles, {.position = {500.0, 16.0, 32.0}, .shape = Block{{450.0f, 1, 1}}}); // far away, and long
    (void)placed_in(obstacles, {.position = {500.0, 16.0, 32.0}, .shape = Block{{1, 1, 450.0f}}}); // across
    EXPECT_EQ(ticked(obstacles).size(), 4u);
    Boundaries periodic;
    periodic.x_low.kind = periodic.x_high.kind = BoundaryKind::periodic;
    const auto images = ticked(obstacles, 0.02, k_window, periodic);
    EXPECT_EQ(images.size(), 6u) << "along a periodic axis an image of each is in the box";
    for (const PlacedObstacle& body : images)
        EXPECT_TRUE(body.position.x >= 0.0f && body.position.x < 64.0f);
}

// A search finds all that a look at each one finds, of any size, wherever the box is.
TEST(Obstacles, TheSearchMissesNone) {
    Random random(3);
    Obstacles obstacles;
    std::vector<Obstacle> all;
    for (int n = 0; n < 3000; ++n) {
        Obstacle one{.position = random.point(150.0), .orientation = turned(random.real(0.0, 360.0), random.direction())};
        one.shape = Block{glm::vec3(random.spread(0.05, 60.0), random.spread(0.05, 60.0), random.spread(0.05, 60.0))};
        all.push_back(one);
        (void)placed_in(obstacles, one);
    }
    std::size_t found = 0;
    for (int n = 0; n < 40; ++n) {
        Window window{.cells = {20, 10, 30}, .cell_size = n % 2 == 0 ? 1.0f : 0.25f};
        window.origin_cells = CellIndex(random.point(120.0) / double(window.cell_size));
        std::size_t expected = 0;
        for (const Obstacle& one : all) {
            Obstacles alone;
            (void)placed_in(alone, one);
            expected += alone.tick(0.02, window, k_open).size();
        }
        const std::size_t here = obstacles.tick(0.02, window, k_open).size();
        EXPECT_EQ(here, expected);
        found += here;
    }
    EXPECT_GT(found, 500u);
}

TEST(Obstacles, TheOrderIsThatOfTheirContent) {
    Random random(4);
    std::vector<Obstacle> all;
    for (int n = 0; n < 120; ++n) {
        const MeshData ball = ball_mesh(1.0f + 0.1f * static_cast<float>(random.integer(0, 2)), 0); // a mesh for each obstacle
        VoxelData grid{.cells = {2, 2, 1}, .closed = {1, 0, 1, static_cast<std::uint8_t>(random.integer(0, 1))}};
        const Shape shapes[] = {
            Capsule{.half_axis = random.vector(2.0f)}, Block{}, MeshShape{mesh_of(ball)}, VoxelShape{grid_of(grid), 0.5f},
            Ground{heights_of({{2, 2}, 1.0f, {0.0f, 0.0f, 1.0f, 2.0f * static_cast<float>(random.integer(0, 1))}})}};
        all.push_back({.position = {double(random.integer(0, 2)), 16.0, 32.0},
                       .orientation = turned(90.0 * random.integer(0, 1)),
                       .shape = shapes[random.integer(0, 4)],
                       .surface = static_cast<Surface>(random.integer(0, 1))});
    }
    Obstacles forward, backward;
    for (const Obstacle& one : all)
        (void)placed_in(forward, one);
    for (std::size_t n = all.size(); n-- > 0;) {
        const ObstacleId gone = placed_in(backward, {.position = {1.0, 1.0, 1.0}});
        (void)placed_in(backward, all[n]);
        ASSERT_TRUE(backward.remove(gone));
    }
    EXPECT_TRUE(same(ticked(forward), ticked(backward)));
}

TEST(Obstacles, OutsideOfTheBoxTheyCostNothing) {
    Obstacles obstacles;
    for (int n = 0; n < 10'000; ++n)
        (void)placed_in(obstacles, {.position = {300.0 + n % 100 * 12.0, 1.0, n / 100 * 12.0}});
    EXPECT_TRUE(ticked(obstacles).empty());
    EXPECT_LT(obstacles.visited(), 100u) << "the first tick searches";
    (void)ticked(obstacles);
    EXPECT_EQ(obstacles.visited(), 0u) << "no later one does";
    Window window = k_window;
    window.origin_cells.x = 3;
    (void)ticked(obstacles, 0.02, window);
    EXPECT_LT(obstacles.visited(), 100u) << "a shift searches again";
    const ObstacleId house = placed_in(obstacles, {.position = {10.0, 1.0, 10.0}});
    EXPECT_EQ(ticked(obstacles, 0.02, window).size(), 1u);
    EXPECT_LT(obstacles.visited(), 100u);
    ASSERT_TRUE(obstacles.move(house, {11.0, 1.0, 10.0}));
    obstacles.begin_frame(0.0, 0.02);
    (void)ticked(obstacles, 0.02, window);
    (void)ticked(obstacles, 0.02, window);
    EXPECT_EQ(obstacles.visited(), 1u) << "what moves is looked at in each tick";
    for (int n = 0; n < 3; ++n)
        (void)ticked(obstacles, 0.02, window);
    EXPECT_EQ(obstacles.visited(), 0u) << "and at rest no more";
    (void)obstacles.take_changed();
    (void)placed_in(obstacles, {.position = {900.0, 1.0, 0.0}});
    (void)ticked(obstacles, 0.02, window);
    EXPECT_EQ(obstacles.visited(), 0u) << "one that is added far away is not looked at";
    EXPECT_FALSE(obstacles.take_changed());
}

TEST(Obstacles, AMoveIsAVelocityForATick) {
    Obstacles obstacles;
    const ObstacleId id = placed_in(obstacles, {.position = {8.0, 4.0, 8.0}});
    (void)ticked(obstacles);
    ASSERT_TRUE(obstacles.move(id, {8.5, 4.0, 8.0}, turned(9.0)));
    obstacles.begin_frame(0.0, 0.25);
    const auto moving = ticked(obstacles, 0.25);
    ASSERT_EQ(moving.size(), 1u);
    EXPECT_EQ(moving[0].position, glm::vec3(8.5f, 4.0f, 8.0f));
    EXPECT_EQ(moving[0].velocity, glm::vec3(2.0f, 0.0f, 0.0f));
    EXPECT_NEAR(moving[0].spin.y, glm::radians(36.0f), 1e-5f);
    EXPECT_NEAR(glm::length(moving[0].axes[0] - glm::vec3(std::cos(glm::radians(9.0f)), 0.0f, -std::sin(glm::radians(9.0f)))),
                0.0f, 1e-6f);
    const auto resting = ticked(obstacles, 0.25);
    EXPECT_EQ(resting[0].velocity, glm::vec3(0.0f));
    EXPECT_EQ(resting[0].spin, glm::vec3(0.0f));
    EXPECT_EQ(resting[0].position, moving[0].position);
    ASSERT_TRUE(obstacles.set(id, {.position = {20.0, 4.0, 8.0}}));
    EXPECT_FALSE(ticked(obstacles)[0].moves()) << "what is set pushes nothing on the way";
}

// A turn by way of several poses of one frame goes through each, the shorter way.
TEST(Obstacles, ATurnGoesThroughThePosesOfAFrame) {
    Obstacles obstacles;
    const ObstacleId id = placed_in(obstacles, {.position = {8.0, 4.0, 8.0}});
    for (const double angle : {100.0, 200.0, 300.0})
        ASSERT_TRUE(obstacles.move(id, {8.0, 4.0, 8.0}, turned(angle)));
    obstacles.begin_frame(0.0, 0.3);
    for (const double angle : {50.0, 100.0, 150.0, 200.0, 250.0, 300.0}) {
        const auto placed = ticked(obstacles, 0.05);
        const glm::mat3 expected(glm::mat4_cast(turned(angle)));
        EXPECT_NEAR(glm::length(placed[0].axes[0] - expected[0]), 0.0f, 1e-5f) << angle;
        EXPECT_NEAR(placed[0].spin.y, glm::radians(1000.0f), 1e-3f) << angle;
    }
}

// What each tick of 1/30 s sees of a motion does not depend on the frames in which the host gave it.
TEST(Obstacles, TicksSeeTheSameMotionAtAnyFrameRate) {
    std::vector<std::vector<PlacedObstacle>> seen;
    for (const int fps : {30, 60, 144}) {
        Wind wind = made({.cells = {16, 8, 16}, .ticks = {.hz = 30.0}});
        const auto at = [](double t) { return glm::dvec3(-6.0 + 3.0 * t, 0.7 * t, 1.0 - t); };
        const ObstacleId id = placed_in(wind.obstacles(), {.position = at(0.0), .shape = Sphere{1.0f}});
        std::vector<PlacedObstacle> last;
        for (int frame = 1; frame <= 2 * fps; ++frame) {
            const double t = frame / double(fps);
            ASSERT_TRUE(wind.obstacles().move(id, at(t), turned(40.0 * t)));
            (void)wind.advance(1.0 / fps);
        }
        for (const PlacedObstacle& body : wind.state().core.obstacles.tick(1.0 / 30.0, wind.state().core.window(), k_open))
            last.push_back(body); // one more, of the pose that stays
        Wind again = made({.cells = {16, 8, 16}, .ticks = {.hz = 30.0}});
        Obstacles& list = again.obstacles();
        const ObstacleId other = placed_in(list, {.position = at(0.0), .shape = Sphere{1.0f}});
        double lead = 0.0;
        for (int frame = 1; frame <= fps; ++frame) {
            ASSERT_TRUE(list.move(other, at(frame / double(fps)), turned(40.0 * frame / fps)));
            list.begin_frame(lead, 1.0 / fps);
            for (lead += 1.0 / fps; lead >= 1.0 / 30.0 - 1e-12; lead -= 1.0 / 30.0)
                for (const PlacedObstacle& body : list.tick(1.0 / 30.0, again.state().core.window(), k_open))
                    last.push_back(body);
        }
        seen.push_back(last);
    }
    ASSERT_EQ(seen[0].size(), 31u);
    EXPECT_NEAR(glm::length(seen[0][0].position - glm::vec3(8.0f, 5.4f, 7.0f)), 0.0f, 1e-4f) << "after 2 s, from the low corner";
    EXPECT_NEAR(seen[0][5].velocity.x, 3.0f, 1e-3f);
    for (const auto& other : seen) {
        ASSERT_EQ(other.size(), seen[0].size());
        for (std::size_t n = 0; n < other.size(); ++n) {
            EXPECT_EQ(other[n].position, seen[0][n].position);
            EXPECT_EQ(other[n].velocity, seen[0][n].velocity);
            // Orientations come in floats.
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(glm::length(other[n].axes[axis] - seen[0][n].axes[axis]), 0.0f, 1e-6f);
            EXPECT_NEAR(glm::length(other[n].spin - seen[0][n].spin), 0.0f, 1e-4f);
        }
    }
}

// The same scene a long way from the origin gives the same bits.
TEST(Obstacles, ThePlaceInTheWorldDoesNotMatter) {
    std::vector<std::vector<PlacedObstacle>> seen;
    for (const glm::dvec3 offset : {glm::dvec3(0.0), glm::dvec3(1e6, -2e4, 3e7)}) {
        Window window = k_window;
        window.origin_cells = CellIndex(offset);
        Obstacles obstacles;
        const ObstacleId id = placed_in(obstacles, {.position = offset + glm::dvec3(7.1, 3.3, 9.7)});
        (void)placed_in(obstacles, {.position = offset + glm::dvec3(12.3, 1.9, 30.1), .shape = Cylinder{}});
        ASSERT_TRUE(obstacles.move(id, offset + glm::dvec3(7.4, 3.3, 9.9)));
        obstacles.begin_frame(0.0, 0.02);
        seen.push_back(ticked(obstacles, 0.02, window));
    }
    ASSERT_EQ(seen[0].size(), 2u);
    EXPECT_TRUE(same(seen[0], seen[1]));
}

TEST(Obstacles, ChangesAreReportedOnce) {
    Obstacles obstacles;
    const auto changed = [&](const Window& window = k_window) {
        (void)ticked(obstacles, 0.02, window);
        const bool stirred = obstacles.take_moved();
        return std::pair(obstacles.take_changed(), stirred);
    };
    using Pair = std::pair<bool, bool>;
    EXPECT_EQ(changed(), Pair(false, false));
    const ObstacleId house = placed_in(obstacles, {.position = {5.0, 5.0, 5.0}}),
                     far = placed_in(obstacles, {.position = {0.0, 0.0, 999.0}});
    EXPECT_EQ(changed(), Pair(true, true));
    EXPECT_EQ(changed(), Pair(false, false));
    Window shifted = k_window;
    shifted.origin_cells.z = 2;
    EXPECT_EQ(changed(shifted), Pair(true, false)) << "a shift of the box moves no body";
    ASSERT_TRUE(obstacles.remove(far));
    EXPECT_EQ(changed(shifted), Pair(false, false));
    ASSERT_TRUE(obstacles.move(house, {6.0, 5.0, 5.0}));
    obstacles.begin_frame(0.0, 0.02);
    EXPECT_EQ(changed(shifted), Pair(true, true));
    EXPECT_EQ(changed(shifted), Pair(true, false)) << "it stops";
    EXPECT_EQ(changed(shifted), Pair(false, false));
    ASSERT_TRUE(obstacles.move(house, {8.0, 5.0, 5.0}));
    obstacles.begin_frame(0.0, 0.5);
    obstacles.pass(0.5);
    EXPECT_EQ(changed(shifted), Pair(true, false)) << "it moved in time that was dropped";
    EXPECT_EQ(ticked(obstacles, 0.02, shifted)[0].position.x, 8.0f);
    ASSERT_TRUE(obstacles.remove(house));
    EXPECT_EQ(changed(shifted), Pair(true, true));
}

} // namespace
