// The box that follows: nothing inside is lost, what is new is ambient, and where in the world it happens makes no difference.

#include "fluid/event_log.h"
#include "tests/shapes.h"
#include "tests/winds.h"

#include <cstring>
#include <limits>

namespace {

using namespace windrow;
using namespace windrow::test;

glm::dvec3 origin_cells(const Wind& wind) {
    return glm::round(wind.origin() / double(wind.box().cell_size));
}

/// The air with its place, as a world would remember it.
struct AirInPlace {
    explicit AirInPlace(const Wind& wind) : field(copy(wind.field())), origin(origin_cells(wind)) {}
    Field field;
    glm::dvec3 origin;
};

// Against what each cell must hold if the box was moved and nothing else happened: the value that stood at its place, or ambient.
std::size_t cells_not_as_expected(const Wind& wind, const AirInPlace& before) {
    const Box& box = wind.box();
    const glm::dvec3 moved = origin_cells(wind) - before.origin;
    Field expected(wind.field().size(), glm::vec4(wind.ambient(), 0.0f));
    for_each_cell(box.cells, [&](int i, int j, int k) {
        const glm::dvec3 there = glm::dvec3(i, j, k) + moved;
        if (glm::all(glm::greaterThanEqual(there, glm::dvec3(0.0))) && glm::all(glm::lessThan(there, glm::dvec3(box.cells))))
            expected[box.index(i, j, k)] = before.field[box.index(int(there.x), int(there.y), int(there.z))];
    });
    return cells_that_differ(wind.field(), expected);
}

glm::dvec3 middle(const Wind& wind) {
    return wind.origin() + 0.5 * glm::dvec3(wind.box().cells) * double(wind.box().cell_size);
}

// --- A shift without a step keeps the overlap to the bit -------------------------------------------------------------

TEST(Window, AThousandShiftsKeepTheOverlapToTheBit) {
    const glm::vec3 ambient(1.5f, -0.25f, 3.0f);
    Wind wind = made({.cells = {17, 9, 23}, .cell_size = 0.5f, .centre = {-3.0, 40.0, 0.25}, .ambient = ambient});
    Random random(41);
    std::size_t wrong = 0;
    int beyond = 0;
    for (int n = 0; n < 1000; ++n) {
        if (n % 5 == 0) {
            ASSERT_TRUE(wind.set_velocity(white_noise(wind.box().cells, 5.0f, random.bits())));
        }
        const AirInPlace before(wind);
        const int most = n % 10 == 9 ? 40 : 8;
        const glm::ivec3 shift(random.integer(-most, most), random.integer(-most, most) / 3, random.integer(-most, most));
        beyond += std::abs(shift.x) >= 17 || std::abs(shift.y) >= 9 || std::abs(shift.z) >= 23;
        // Anywhere within the half cell around a centre is the same shift.
        const glm::dvec3 origin = wind.origin();
        ASSERT_TRUE(wind.follow(middle(wind) + 0.5 * (glm::dvec3(shift) + random.point(0.49))));
        ASSERT_EQ(wind.origin(), origin + 0.5 * glm::dvec3(shift));
        wrong += cells_not_as_expected(wind, before);
    }
    EXPECT_GT(beyond, 20);
    WINDROW_EXPECT_FIGURE("shift_cells_changed", double(wrong), 0.0);
}

TEST(Window, APointInsideFeelsNoShift) {
    Wind wind = made({.ambient = {2.0f, 0.0f, -1.0f}, .blend_width = 0.0f, .viscosity = 0.0f, .relaxation_time = 0.0f});
    ASSERT_TRUE(wind.set_velocity(smooth_noise(wind.box().cells, 4.0f, 42)));
    take_steps(wind, 5, 1.0 / 60.0);
    Random random(43);
    std::vector<glm::dvec3> points;
    for (int n = 0; n < 2000; ++n) {
        const double x = random.real(-12.0, 12.0), y = random.real(-5.0, 5.0), z = random.real(-12.0, 12.0);
        points.emplace_back(x, y, z);
    }
    const double speed = largest_speed(wind.field());
    double worst = 0.0;
    for (const glm::dvec3 to :
         {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, -2.0, 1.0), glm::dvec3(-3.0, 1.0, 3.0), glm::dvec3(2.2, 0.4, -0.7)}) {
        std::vector<glm::vec3> before(points.size()), after(points.size());
        wind.velocity(points, before);
        ASSERT_TRUE(wind.follow(to));
        wind.velocity(points, after);
        for (std::size_t n = 0; n < points.size(); ++n)
            worst = std::max(worst, double(glm::length(after[n] - before[n])) / speed);
    }
    WINDROW_EXPECT_FIGURE("shift_at_fixed_points", worst, 1e-6);
}

TEST(Window, OnlyTheAxesThatFollowMove) {
    Boundaries boundaries = Boundaries::open_over_floor();
    boundaries.z_low.kind = boundaries.z_high.kind = BoundaryKind::periodic;
    Wind wind = made({.cells = {16, 8, 16}, .boundaries = boundaries});
    const glm::dvec3 origin = wind.origin();
    ASSERT_TRUE(wind.follow({5.0, 5.0, 5.0}));
    EXPECT_EQ(wind.origin(), origin + glm::dvec3(5.0, 0.0, 0.0));

    Wind pinned = made({.cells = {16, 8, 16}, .follow_axes = glm::bvec3(false, false, true)});
    ASSERT_TRUE(pinned.follow({5.0, 5.0, 5.0}));
    EXPECT_EQ(pinned.origin(), glm::dvec3(-8.0, -4.0, -3.0));
}

TEST(Window, AJumpBeyondItStartsAfresh) {
    const Config config{.cells = {12, 8, 10}, .ambient = {1.0f, 2.0f, 3.0f}};
    for (const glm::dvec3 jump :
         {glm::dvec3(12.0, 0.0, 0.0), glm::dvec3(0.0, -8.0, 0.0), glm::dvec3(1e9, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1e12)}) {
        Wind wind = made(config);
        ASSERT_TRUE(wind.set_velocity(white_noise(config.cells, 3.0f, 44)));
        take_steps(wind, 3, 0.1);
        ASSERT_TRUE(wind.follow(jump));
        Config there = config;
        there.centre = jump;
        Wind fresh = made(there);
        ASSERT_EQ(wind.origin(), fresh.origin());
        EXPECT_EQ(cells_that_differ(wind.field(), fresh.field()), 0u) << "ambient in one call";
        const auto blow = [&](Wind& air) {
            ASSERT_TRUE(air.motors().add(DirectionalMotor{.position = jump, .law = Force{20.0f}}));
            take_steps(air, 3, 0.1);
        };
        blow(wind);
        blow(fresh);
        EXPECT_EQ(cells_that_differ(wind.field(), fresh.field()), 0u) << "its history too";
    }
}

TEST(Window, APointThatIsNoneIsRejected) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    Wind wind = made({.cells = {8, 8, 8}, .cell_size = 0.5f});
    ASSERT_TRUE(wind.set_velocity(white_noise({8, 8, 8}, 3.0f, 45)));
    const AirInPlace before(wind);
    for (const glm::dvec3 point : {glm::dvec3(nan, 0.0, 0.0), glm::dvec3(0.0, infinity, 0.0), glm::dvec3(0.0, 0.0, -infinity),
                                   glm::dvec3(6e11, 0.0, 0.0)}) {
        const auto rejected = wind.follow(point);
        ASSERT_FALSE(rejected);
        EXPECT_EQ(rejected.error().find("follow point is ("), 0u) << rejected.error();
        EXPECT_NE(rejected.error().find("finite"), std::string::npos) << rejected.error();
    }
    EXPECT_EQ(wind.origin(), glm::dvec3(-2.0));
    EXPECT_EQ(cells_not_as_expected(wind, before), 0u);
    EXPECT_TRUE(wind.follow({4e11, -4e11, 0.0})) << "within 1e12 cells";
}

TEST(Window, ZeroIsAPlaceLikeAnyOther) {
    for (const double h : {1.0, 0.25}) {
        Wind wind = made({.cells = {8, 6, 5}, .cell_size = float(h), .centre = glm::dvec3(-10.0 * h)});
        glm::dvec3 last = wind.origin();
        glm::ivec3 shifts(0);
        for (int n = 1; n <= 2000; ++n) {
            ASSERT_TRUE(wind.follow(glm::dvec3(-10.0 + 0.01 * n) * h));
            const glm::dvec3 moved = (wind.origin() - last) / h;
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_TRUE(moved[axis] == 0.0 || moved[axis] == 1.0);
                shifts[axis] += moved[axis] == 1.0;
            }
            last = wind.origin();
            ASSERT_LE(glm::length(middle(wind) / h - glm::dvec3(-10.0 + 0.01 * n)), 0.5 * std::sqrt(3.0) + 1e-9)
                << "centred to half a cell";
        }
        EXPECT_EQ(shifts, glm::ivec3(20));
    }
}

TEST(Window, TheFloorFollowsItsHeight) {
    Wind wind = made(
        {.cells = {8, 10, 8}, .cell_size = 0.5f, .boundaries = Boundaries::open_over_floor(), .ambient = {2.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind.set_velocity(white_noise({8, 10, 8}, 3.0f, 46)));
    for (const auto& [height, low] :
         {std::pair{3.1, 3.0}, {3.3, 3.5}, {-0.2, 0.0}, {-7.6, -7.5}, {-5.0, -5.0}, {1e6 + 0.1, 1e6}}) {
        const AirInPlace before(wind);
        ASSERT_TRUE(wind.set_floor(height));
        EXPECT_EQ(wind.origin().y, low);
        EXPECT_EQ(cells_not_as_expected(wind, before), 0u);
    }
    EXPECT_FALSE(wind.set_floor(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(wind.set_floor(std::numeric_limits<double>::infinity()));
    EXPECT_FALSE(wind.set_floor(1e13));
    EXPECT_EQ(wind.origin().y, 1e6);
    Wind open = made({});
    const auto rejected = open.set_floor(0.0);
    ASSERT_FALSE(rejected);
    EXPECT_NE(rejected.error().find("y_low"), std::string::npos) << rejected.error();
}

// --- The bits are the same anywhere in the world ---------------------------------------------------------------------

// Walks, blows and stirs around `place`, and gives the air at the end.
Field walk(glm::dvec3 place, float cell_size) {
    Wind wind = made(
        {.cells = {24, 12, 20}, .cell_size = cell_size, .centre = place, .ambient = {2.0f, 0.1f, -1.0f}, .viscosity = 0.02f});
    const double h = cell_size;
    Random random(47);
    for (int n = 0; n < 12; ++n) {
        const glm::dvec3 at = place + h * random.point(8.0);
        const float radius = cell_size * random.uniform(0.5f, 4.0f);
        EXPECT_TRUE(wind.motors().add(
            DirectionalMotor{.position = at, .direction = random.vector(1.0f), .region = Sphere{radius}, .law = Force{30.0f}}));
        EXPECT_TRUE(wind.motors().add(DirectionalMotor{
            .position = at, .direction = random.vector(1.0f), .region = Capsule{random.vector(cell_size), radius}}));
    }
    const MotorId body = added(wind, WakeMotor{.position = place + h * glm::dvec3(-6.3, 0.7, 0.1), .radius = 1.1f * cell_size});
    for (int n = 1; n <= 50; ++n) {
        EXPECT_TRUE(wind.motors().move(body, place + h * glm::dvec3(-6.3 + 0.231 * n, 0.7, 0.1 + 0.05 * n)));
        EXPECT_TRUE(wind.follow(place + h * glm::dvec3(0.13 * n, 0.017 * n, -0.071 * n)));
        wind.step(1.0 / 60.0);
    }
    return copy(wind.field());
}

TEST(Window, AMillionMetresAwayEqualsTheOrigin) {
    for (const float h : {1.0f, 0.5f, 0.3f}) {
        const Field here = walk(glm::dvec3(0.0), h);
        EXPECT_GT(largest_speed(here), 3.0) << "the walk stirs";
        // Whole cells away, whatever a cell measures.
        const double far_off = std::round(1e6 / double(h)) * double(h);
        std::size_t differing = 0;
        for (const glm::dvec3 place :
             {glm::dvec3(far_off, 0.0, far_off), glm::dvec3(-far_off, 0.0, far_off), glm::dvec3(0.0, -far_off, 0.0)})
            differing += cells_that_differ(walk(place, h), here);
        WINDROW_EXPECT_FIGURE("far_away_cells_that_differ_h_" + std::to_string(h).substr(0, 3), double(differing), 0.0);
    }
}

// --- The origin of the world ---------------------------------------------------------------------------------------------------

/// A player, a dog's wake, a vent, a door and a rock in a gusty wind over a floor, whose world's origin moves by `way` after each tenth
/// frame.
struct FloatingWorld {
    explicit FloatingWorld(glm::dvec3 way_, Config config) : way(way_), wind(made(config)) {
        dog = added(wind, WakeMotor{.position = {-6.0, 1.0, 0.0}, .radius = 1.0f, .turbulence = {.intensity = 0.3f}});
        (void)added(wind, PressureMotor{.position = {4.0, 5.0, 2.0}, .radius = 1.2f});
        door = *wind.obstacles().add({.position = {1.0, 2.0, -1.5}, .shape = Block{{1.2f, 1.7f, 0.4f}}});
        EXPECT_TRUE(wind.obstacles().add({.position = {-3.0, 1.0, 3.0}, .shape = Sphere{1.1f}}));
    }
    void frame(int n) {
        if (n % 10 == 9) {
            EXPECT_TRUE(wind.shift_origin(way));
            origin += way;
        }
        EXPECT_TRUE(wind.motors().move(dog, origin + glm::dvec3(-6.0 + 0.1 * n, 1.0, 0.04 * n)));
        EXPECT_TRUE(wind.obstacles().move(door, origin + glm::dvec3(1.0, 2.0, -1.5 + 0.02 * n)));
        EXPECT_TRUE(wind.follow(origin + glm::dvec3(0.09 * n, 0.0, -0.05 * n)));
        wind.advance(1.0 / 60.0);
    }

    glm::dvec3 way, origin{0.0};
    Wind wind;
    MotorId dog;
    ObstacleId door;
};

TEST(Window, AShiftOfTheOriginChangesNoAir) {
    const Config config{.cells = {20, 10, 16},
                        .boundaries = Boundaries::open_over_floor(),
                        .ambient = {5.0f, 0.0f, 1.0f},
                        .profile = LogProfile{},
                        .gusts = {.intensity = 0.2f}};
    const double period = made(config).ambient_wind().period();
    ASSERT_EQ(period, std::round(period));
    Config over_no_floor = config;
    over_no_floor.boundaries = {};
    for (const auto& [air, whole] : {std::pair{config, true}, std::pair{config, false}, std::pair{over_no_floor, false}}) {
        const glm::dvec3 way = whole ? glm::dvec3(4.0 * period, 0.0, -2.0 * period) : glm::dvec3(4711.0, 3.0, -815.0);
        FloatingWorld stays(glm::dvec3(0.0), air), floats(way, air);
        EventLog log;
        const auto start = floats.wind.save();
        floats.wind.record_to(&log);
        double worst = 0.0, apart = 0.0;
        for (int n = 0; n < 60; ++n) {
            stays.frame(n);
            floats.frame(n);
            for (std::size_t cell = 0; cell < stays.wind.field().size(); ++cell)
                worst = std::max(worst, double(glm::length(stays.wind.field()[cell] - floats.wind.field()[cell])));
            for (const glm::dvec3 place : {glm::dvec3(0.3, 0.4, 0.2), glm::dvec3(3.0, 2.5, -2.0), glm::dvec3(40.0, 2.0, 9.0)}) {
                apart = std::max(apart,
                                 double(glm::length(stays.wind.velocity(place) - floats.wind.velocity(place + floats.origin))));
                apart = std::max(apart, double(glm::length(stays.wind.previous_view().velocity(place) -
                                                           floats.wind.previous_view().velocity(place + floats.origin))));
            }
            const WindowBlock here = stays.wind.window_block(glm::dvec3(1.0)),
                              there = floats.wind.window_block(glm::dvec3(1.0) + floats.origin);
            EXPECT_EQ(std::memcmp(&here, &there, sizeof here), 0) << n;
        }
        if (whole) {
            WINDROW_EXPECT_FIGURE("origin_shift_air_whole_gust_tiles", worst, 0.0);
            WINDROW_EXPECT_FIGURE("origin_shift_queries_whole_gust_tiles", apart, 0.0);
        } else {
            WINDROW_EXPECT_FIGURE("origin_shift_air_any_cells", worst, 1e-5);
            WINDROW_EXPECT_FIGURE("origin_shift_queries_any_cells", apart, 1e-5);
        }
        EXPECT_EQ(floats.wind.origin(), stays.wind.origin() + floats.origin);
        EXPECT_EQ(position_of(*floats.wind.motors().find(floats.dog)),
                  position_of(*stays.wind.motors().find(stays.dog)) + floats.origin);
        EXPECT_NEAR(floats.wind.force_on(floats.door)->force.x, stays.wind.force_on(stays.door)->force.x, whole ? 0.0 : 0.05);
        // Its bytes and its log know of it.
        Wind again = *Wind::load(*start);
        ASSERT_TRUE(replay(log, again));
        EXPECT_EQ(*again.save(), *floats.wind.save());
        Wind loaded = *Wind::load(*floats.wind.save());
        loaded.step(1.0 / 60.0);
        floats.wind.record_to(nullptr);
        floats.wind.step(1.0 / 60.0);
        EXPECT_EQ(cells_that_differ(copy(loaded.field()), copy(floats.wind.field())), 0u);
    }
}

TEST(Window, AShiftOfTheOriginMovesTheRoughness) {
    Config config{.cells = {16, 8, 8},
                  .boundaries = Boundaries::open_over_floor(),
                  .ambient = {5.0f, 0.0f, 0.0f},
                  .profile = LogProfile{},
                  .roughness = Roughness{}};
    config.roughness->map =
        RoughnessMap{.lengths = heights_of({41, 41}, 1.0f, [](double x, double) { return x < 20.0 ? 0.002f : 0.5f; }),
                     .position = {-20.0, 0.0, -20.0}};
    Wind stays = made(config), floats = made(config);
    for (int n = 0; n < 30; ++n) {
        const glm::dvec3 origin = n < 5 ? glm::dvec3(0.0) : glm::dvec3(64.0, 0.0, -32.0);
        if (n == 5) {
            ASSERT_TRUE(floats.shift_origin(origin));
        }
        for (Wind* wind : {&stays, &floats})
            (void)wind->step(1.0 / 20.0);
    }
    Wind loaded = *Wind::load(*floats.save());
    for (Wind* wind : {&stays, &floats, &loaded})
        (void)wind->step(1.0 / 20.0);
    EXPECT_LE(largest_apart(stays.field(), floats.field()), 1e-5);
    EXPECT_EQ(cells_that_differ(copy(loaded.field()), copy(floats.field())), 0u);
    EXPECT_EQ(stays.velocity({3.0, 0.2, 0.0}), floats.velocity({67.0, 0.2, -32.0}));
}

TEST(Window, AShiftOfTheOriginIsOfWholeCells) {
    Wind wind = made({.cells = {8, 8, 8}, .cell_size = 0.5f, .ambient = {1.0f, 0.0f, 0.0f}});
    const auto before = *wind.save();
    for (const glm::dvec3 way : {glm::dvec3(0.3, 0.0, 0.0), glm::dvec3(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0),
                                 glm::dvec3(0.0, 0.0, std::numeric_limits<double>::infinity()), glm::dvec3(1e300, 0.0, 0.0)})
        EXPECT_FALSE(wind.shift_origin(way));
    EXPECT_EQ(*wind.save(), before);
    EXPECT_EQ(wind.shift_origin({0.7, 0.0, 0.0}).error(),
              "shift_origin got (0.7, 0, 0) m: give whole cells, such as (0.5, 0, 0) m.");
}

} // namespace
