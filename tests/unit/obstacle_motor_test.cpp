// Motors among obstacles: a body takes no push, and no flow of a volume source passes it.

#include "tests/winds.h"

#include <cstring>
#include <numbers>

namespace {

using namespace windrow;
using namespace windrow::test;

double fastest_where(const Wind& wind, const std::function<bool(glm::dvec3)>& counts) {
    double largest = 0.0;
    for_each_cell(wind.box().cells, [&](int i, int j, int k) {
        const glm::dvec3 centre = wind.origin() + (glm::dvec3(i, j, k) + 0.5) * double(wind.box().cell_size);
        if (counts(centre))
            largest = std::max(largest, double(glm::length(wind.field()[wind.box().index(i, j, k)])));
    });
    return largest;
}

bool same_air(const Wind& a, const Wind& b) {
    return std::memcmp(a.field().data(), b.field().data(), a.field().size_bytes()) == 0;
}

// --- Volume sources ------------------------------------------------------------------------------------------------------------

enum class Order { wall_first, vent_first, wall_is_set };

class VentInADuct : public ::testing::TestWithParam<std::tuple<Order, Shape, double>> {};

// A duct, open at both ends, with a wall across.
TEST_P(VentInADuct, BlowsNothingThroughAWall) {
    const auto [order, shape, x] = GetParam();
    Boundaries walls = Boundaries::all(BoundaryKind::free_slip);
    walls.x_low = walls.x_high = {BoundaryKind::open};
    Wind wind = made({.cells = {24, 6, 6},
                      .boundaries = walls,
                      .centre = {12.0, 3.0, 3.0},
                      .relaxation_time = 0.0f,
                      .pressure_solves = order == Order::wall_is_set ? 16 : 0});
    const Motor vent = OmniMotor{.position = {6.0, 3.0, 3.0}, .radius = 2.0f, .speed = 2.0f};
    const Obstacle wall{.position = {x, 3.0, 3.0}, .orientation = glm::quat(1, 0, 1, 0), .shape = shape};
    if (order == Order::vent_first) {
        added(wind, vent);
        take_steps(wind, 3, 0.1);
    }
    Obstacle start = wall;
    if (order == Order::wall_is_set)
        start.position.x += 5.0;
    const ObstacleId id = *wind.obstacles().add(start);
    if (order == Order::wall_first)
        take_steps(wind, 2, 0.1);
    if (order != Order::vent_first)
        added(wind, vent);
    if (order == Order::wall_is_set) {
        take_steps(wind, 3, 0.1);
        ASSERT_TRUE(wind.obstacles().set(id, wall));
    }
    take_steps(wind, 40, 0.1);
    double out = 0.0;
    for (int k = 0; k < 6; ++k)
        for (int j = 0; j < 6; ++j)
            out -= double(wind.field()[wind.box().index(0, j, k)].x);
    const double given = 4.0 * std::numbers::pi * 2.0 * 2.0 * 2.0;
    EXPECT_NEAR(out, given, 0.05 * given) << "all of it leaves by the open end";
    EXPECT_LT(fastest_where(wind, [](glm::dvec3 p) { return p.x > 15.0; }), 2e-3 * given / 36.0);
}

INSTANTIATE_TEST_SUITE_P(Orders, VentInADuct,
                         ::testing::Combine(::testing::Values(Order::wall_first, Order::vent_first, Order::wall_is_set),
                                            ::testing::Values(Shape(Plate{{20.0f, 20.0f}}), Shape(Block{{20.0f, 20.0f, 1.5f}})),
                                            ::testing::Values(12.3, 12.5)));

// The flow of a vent goes around a body where it is now: none is left where it was.
TEST(MotorsAmongObstacles, AVentBlowsAroundABodyThatMoves) {
    const Config config{.cells = {20, 16, 16}, .relaxation_time = 0.0f};
    Wind with_both = made(config), with_ball = made(config), with_vent = made(config);
    for (Wind* wind : {&with_both, &with_vent})
        added(*wind, OmniMotor{.position = {-5.0, 0.0, 0.0}, .radius = 2.0f, .speed = 6.0f});
    const glm::dvec3 start(2.0, -4.0, 0.0);
    for (Wind* wind : {&with_both, &with_ball}) {
        const ObstacleId ball = *wind->obstacles().add({.position = start, .shape = Sphere{2.0f}});
        take_steps(*wind, 5, 0.05);
        for (int n = 1; n <= 40; ++n) {
            ASSERT_TRUE(wind->obstacles().move(ball, start + glm::dvec3(0.0, 0.2 * n, 0.0)));
            (void)wind->step(0.05);
        }
    }
    (void)with_vent.step(0.05);
    const float vent = with_vent.velocity(start).x, found = (with_both.velocity(start) - with_ball.velocity(start)).x;
    EXPECT_GT(found, 0.5f * vent) << "of " << vent << " m/s: none where the flow still goes around the place that it left";
}

TEST(MotorsAmongObstacles, ABlastStopsAtAWall) {
    Wind wind = made({.cells = {24, 16, 24}, .boundaries = Boundaries::open_over_floor(), .centre = {0.0, 8.0, 0.0}});
    for (const double side : {-1.0, 1.0}) { // a room without a roof, with walls 8 m high
        ASSERT_TRUE(wind.obstacles().add({.position = {4.0 * side, 4.0, 0.0}, .shape = Block{{0.5f, 4.0f, 4.5f}}}));
        ASSERT_TRUE(wind.obstacles().add({.position = {0.0, 4.0, 4.0 * side}, .shape = Block{{4.5f, 4.0f, 0.5f}}}));
    }
    (void)wind.step(0.02);
    added(wind, PressureMotor{.position = {0.0, 2.0, 0.0}, .radius = 1.5f, .speed = 40.0f});
    (void)wind.step(0.02);
    const double inside =
        fastest_where(wind, [](glm::dvec3 p) { return std::abs(p.x) < 3.0 && std::abs(p.z) < 3.0 && p.y < 7.0; });
    const double beside =
        fastest_where(wind, [](glm::dvec3 p) { return std::max(std::abs(p.x), std::abs(p.z)) > 5.0 && p.y < 2.0; });
    EXPECT_GT(inside, 5.0);
    EXPECT_LT(beside, 0.05 * inside) << "the air over the wall moves, that behind it hardly";
}

// A room of plates without thickness, about the middle; the side at low z is left out where it is open.
void add_room(Wind& wind, bool open) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            if (open && axis == 2 && side < 0.0)
                continue;
            glm::dvec3 place(0.0);
            place[axis] = 3.3 * side;
            const glm::vec3 turn_axis(axis == 1 ? 1.0f : 0.0f, axis == 0 ? 1.0f : 0.0f, 0.0f);
            ASSERT_TRUE(wind.obstacles().add(
                {.position = place,
                 .orientation = axis == 2 ? glm::quat(1, 0, 0, 0) : glm::angleAxis(float(std::numbers::pi) / 2, turn_axis),
                 .shape = Plate{{3.3f, 3.3f}}}));
        }
}

// A sealed room takes up the air of a vent, and the report counts it. With an opening all of the air leaves.
TEST(MotorsAmongObstacles, AVentInASealedRoomMovesTheRoomAlone) {
    for (const bool open : {false, true})
        for (const bool free_air : {true, false}) {
            Config config{.cells = {18, 18, 18}, .relaxation_time = 0.0f};
            if (!free_air)
                config.boundaries.y_low = config.boundaries.y_high = {BoundaryKind::free_slip};
            Wind wind = made(config);
            add_room(wind, open);
            added(wind, OmniMotor{.position = {0.5, 0.0, 0.0}, .radius = 1.5f, .speed = 4.0f});
            for (int n = 0; n < 10; ++n)
                EXPECT_EQ(wind.step(0.05).sealed_sources, open ? 0 : 1);
            const auto out_of_room = [](glm::dvec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 4.0; };
            const double within = fastest_where(wind, [&](glm::dvec3 p) { return !out_of_room(p); });
            const double beyond = fastest_where(wind, out_of_room);
            EXPECT_GT(within, 2.0);
            EXPECT_LT(within, 40.0);
            if (open)
                EXPECT_GT(beyond, 0.5);
            else
                EXPECT_LT(beyond, 2e-3 * within) << (free_air ? "free air" : "a duct");
        }
}

TEST(MotorsAmongObstacles, AVentInAClosedBoxIsReported) {
    Wind wind = made({.cells = {8, 8, 8}, .boundaries = Boundaries::all(BoundaryKind::free_slip)});
    added(wind, OmniMotor{.position = {0.5, 0.0, 0.0}, .radius = 1.5f});
    EXPECT_EQ(wind.step(0.05).sealed_sources, 1);
    ASSERT_TRUE(wind.set_boundaries({}));
    EXPECT_EQ(wind.step(0.05).sealed_sources, 0);
}

TEST(MotorsAmongObstacles, ASnapshotWithAVentGoesOnToTheSameBits) {
    Wind first = made({.cells = {18, 16, 18}, .ambient = {2.0f, 0.0f, 0.0f}});
    add_room(first, true);
    added(first, OmniMotor{.position = {0.5, 0.0, 0.0}, .radius = 1.5f});
    take_steps(first, 4, 0.05);
    Wind again = *Wind::load(*first.save());
    for (Wind* wind : {&first, &again}) {
        take_steps(*wind, 3, 0.05);
        ASSERT_TRUE(wind->follow({2.0, 0.0, 0.0}));
        take_steps(*wind, 3, 0.05);
    }
    EXPECT_TRUE(same_air(first, again));
}

// --- Forces and drives ---------------------------------------------------------------------------------------------------------

TEST(MotorsAmongObstacles, OneInsideABodyMovesNothing) {
    const Config config{.cells = {16, 12, 16}, .ambient = {3.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.2f}};
    const std::vector<Motor> motors{
        DirectionalMotor{.region = Sphere{2.1f}, .law = Drive{.speed = 60.0f, .rate = 30.0f}},
        DirectionalMotor{.region = Sphere{2.1f}, .law = Force{.acceleration = 500.0f}},
        VortexMotor{.radius = 2.1f, .half_length = 2.1f},
        OmniMotor{.radius = 2.1f, .speed = 30.0f},
    };
    for (const Motor& motor : motors) {
        Wind plain = made(config), driven = made(config);
        for (Wind* wind : {&plain, &driven})
            ASSERT_TRUE(wind->obstacles().add({.shape = Block{glm::vec3(2.2f)}}));
        (void)added(driven, motor);
        for (int n = 0; n < 6; ++n) {
            const Diagnostics a = plain.step(0.05), b = driven.step(0.05);
            EXPECT_EQ(a.substeps, b.substeps);
        }
        double apart = 0.0;
        for (std::size_t n = 0; n < plain.field().size(); ++n)
            apart = std::max(apart, double(glm::length(plain.field()[n] - driven.field()[n])));
        EXPECT_LT(apart, 1e-5) << "kind " << motor.index();
    }
}

// A wake motor is for a body that is no obstacle. Where it is one, the drive of the wake acts beyond the body alone.
TEST(MotorsAmongObstacles, ABodyHasNoWakeDriveInside) {
    Wind plain = made({.cells = {20, 12, 12}}), driven = made({.cells = {20, 12, 12}});
    std::vector<ObstacleId> balls;
    for (Wind* wind : {&plain, &driven})
        balls.push_back(*wind->obstacles().add({.position = {-5.0, 0.0, 0.0}, .shape = Sphere{2.4f}}));
    const MotorId wake =
        added(driven, WakeMotor{.position = {-5.0, 0.0, 0.0}, .radius = 1.5f, .law = WakeDrive{.per_metre = 5.0f}});
    for (int n = 1; n <= 20; ++n) {
        const glm::dvec3 here(-5.0 + 0.3 * n, 0.0, 0.0);
        ASSERT_TRUE(plain.obstacles().move(balls[0], here));
        ASSERT_TRUE(driven.obstacles().move(balls[1], here));
        ASSERT_TRUE(driven.motors().move(wake, here));
        (void)plain.step(0.05);
        EXPECT_EQ(driven.step(0.05).motors_in_reach, 1);
    }
    EXPECT_TRUE(same_air(plain, driven));
}

// Across a wall: the air on the motor's side moves as it would, and that behind the wall rests.
TEST(MotorsAmongObstacles, AFanAcrossAWallPushesBothSidesAsItReaches) {
    Wind wind = made({.cells = {24, 12, 12}, .relaxation_time = 0.0f});
    ASSERT_TRUE(wind.obstacles().add({.position = {0.0, 0.0, 0.0}, .shape = Block{{0.6f, 20.0f, 20.0f}}}));
    added(wind, DirectionalMotor{.position = {-1.0, 0.0, 0.0}, .direction = {0.0f, 0.0f, 1.0f}, .region = Sphere{3.0f}});
    take_steps(wind, 10, 0.05);
    for_each_cell(wind.box().cells, [&](int i, int j, int k) {
        const double x = wind.origin().x + i + 0.5;
        if (std::abs(x) < 0.6) {
            EXPECT_EQ(wind.field()[wind.box().index(i, j, k)], glm::vec4(0.0f));
        }
    });
    EXPECT_GT(fastest_where(wind, [](glm::dvec3 p) { return p.x < -0.6; }), 1.0);
    EXPECT_GT(fastest_where(wind, [](glm::dvec3 p) { return p.x > 0.6; }), 0.05);
}

// --- Canopy --------------------------------------------------------------------------------------------------------------------

// A house in a field of maize: it rests, and the drag of the plants slows the air up to its walls as without it.
TEST(MotorsAmongObstacles, ACanopyStandsAroundAHouse) {
    Config config{.cells = {24, 12, 24},
                  .boundaries = Boundaries::open_over_floor(),
                  .centre = {0.0, 6.0, 0.0},
                  .ambient = {5.0f, 0.0f, 0.0f},
                  .canopy = Canopy{.height = 2.5f, .drag = 0.3f}};
    Wind wind = made(config);
    ASSERT_TRUE(wind.obstacles().add({.position = {0.0, 2.0, 0.0}, .shape = Block{{3.0f, 2.0f, 3.0f}}}));
    for (int n = 0; n < 60; ++n)
        ASSERT_LT(wind.step(0.1).max_speed, 12.0f);
    const auto inside = [](glm::dvec3 p) { return std::abs(p.x) < 3.0 && p.y < 4.0 && std::abs(p.z) < 3.0; };
    EXPECT_EQ(fastest_where(wind, inside), 0.0);
    EXPECT_LT(wind.velocity({0.0, 1.0, 9.0}).x, 0.7f * wind.velocity({0.0, 8.0, 9.0}).x);
}

} // namespace
