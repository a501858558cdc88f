// Closed rooms: no wind blows in them, whatever blows outside, and nothing else is lost by it.
#include "tests/stability/watch.h"

#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_room_cells(32, 16, 32);
const glm::dvec3 k_centre(16.0, 8.0, 16.0);
constexpr float k_half = 4.2f; // [m] from the middle of the room to its walls

Config windy(double gusts) {
    Config config{
        .cells = k_room_cells, .boundaries = Boundaries::open_over_floor(), .centre = k_centre, .ambient = {10.0f, 0.0f, 0.0f}};
    config.gusts.intensity = static_cast<float>(gusts);
    return config;
}

glm::quat turned_room(float degrees, glm::vec3 axis) {
    return glm::angleAxis(glm::radians(degrees), glm::normalize(axis));
}

// Five walls and a roof about a middle, or without the one towards +x. Thickness 0: plates.
std::vector<ObstacleId> build_room(Wind& wind, glm::dvec3 middle, glm::quat orientation, float thickness, bool whole = true) {
    std::vector<ObstacleId> walls;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            if (!whole && axis == 0 && side > 0.0f)
                continue;
            glm::vec3 away(0.0f), half(k_half + 0.5f * thickness);
            away[axis] = side * k_half;
            half[axis] = 0.5f * thickness;
            Obstacle wall{.position = middle + glm::dvec3(orientation * away), .orientation = orientation, .shape = Block{half}};
            if (thickness == 0.0f) {
                constexpr glm::vec3 k_up(0.0f, 1.0f, 0.0f), k_right(1.0f, 0.0f, 0.0f);
                wall.orientation = axis == 0   ? orientation * turned_room(90.0f, k_up)
                                   : axis == 1 ? orientation * turned_room(90.0f, k_right)
                                               : orientation;
                wall.shape = Plate{glm::vec2(k_half)};
            }
            const auto id = wind.obstacles().add(wall);
            EXPECT_TRUE(id) << id.error();
            walls.push_back(id ? *id : ObstacleId{});
        }
    return walls;
}

// RMS speed [m/s] of the cells more than a cell inside the room, and of those outside.
struct Speeds {
    double inside = 0.0, outside = 0.0;
};
Speeds speeds_of(const Wind& wind, glm::dvec3 middle, glm::quat orientation, float thickness) {
    Speeds squares;
    int count[2] = {};
    const glm::ivec3 cells = wind.box().cells;
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i) {
                const glm::vec3 from =
                    glm::abs(glm::conjugate(orientation) * glm::vec3(wind.view().origin() + glm::dvec3(i, j, k) + 0.5 - middle));
                const float away = std::max({from.x, from.y, from.z}) - k_half;
                const glm::vec4 u = wind.field()[wind.box().index(i, j, k)];
                if (away < -0.5f * thickness - 0.9f)
                    squares.inside += static_cast<double>(glm::dot(u, u)), ++count[0];
                if (away > 0.5f * thickness + 0.9f)
                    squares.outside += static_cast<double>(glm::dot(u, u)), ++count[1];
            }
    return {std::sqrt(squares.inside / count[0]), std::sqrt(squares.outside / count[1])};
}

struct RoomCase {
    const char* name;
    float degrees, thickness;
    bool profile;
};
constexpr RoomCase k_rooms[] = {{"plates", 0.0f, 0.0f, false},
                                {"turned_plates", 33.0f, 0.0f, true},
                                {"walls", 0.0f, 1.0f, true},
                                {"turned_walls", 33.0f, 1.0f, false},
                                {"thick_walls", 33.0f, 2.6f, false}};

// Wind of 10 m/s with gusts of 12 % for a minute. `worked_on`: a force too weak to be seen acts in the room, so its energy has no
// bound, and only the walls keep the wind out.
void expect_still(const RoomCase& room, bool worked_on) {
    Config config = windy(0.12);
    if (room.profile)
        config.profile = LogProfile{};
    if (worked_on)
        config.pressure_solves = 8; // one leaves up to .01 of the wind
    Wind wind = made(config);
    const glm::quat orientation = turned_room(room.degrees, {0.2f, 1.0f, 0.1f});
    build_room(wind, k_centre, orientation, room.thickness);
    if (worked_on) {
        EXPECT_TRUE(wind.motors().add(
            DirectionalMotor{.position = k_centre, .region = Sphere{1.5f}, .law = Force{.acceleration = 1e-6f}}));
    }
    // What the first step leaves in a room that is worked on fades in some 20 steps.
    const int few = worked_on ? 40 : 10;
    for (int n = 0; n < (k_sanitized ? few : whole_sweeps() ? 1800 : 120); ++n)
        (void)wind.step(1.0 / 30.0);
    const Speeds speeds = speeds_of(wind, k_centre, orientation, room.thickness);
    const std::string name = std::string("rooms/") + room.name + (worked_on ? "/walls_alone" : "");
    WINDROW_EXPECT_FIGURE(name, speeds.inside / speeds.outside, 1e-3);
    EXPECT_GT(speeds.outside, 5.0) << name;
}

TEST(Rooms, AreStillInGusts) {
    for (const RoomCase& room : k_rooms)
        expect_still(room, false);
}

TEST(Rooms, WallsAloneKeepTheWindOut) {
    for (const RoomCase& room : k_rooms)
        expect_still(room, true);
}

// A door that closes catches moving air. It keeps what it has, gains nothing, and comes to rest.
TEST(Rooms, KeepTheAirThatADoorClosesIn) {
    Config config = windy(0.1);
    config.relaxation_time = 4.0f;
    Wind wind = made(config);
    build_room(wind, k_centre, turned_room(180.0f, {0.0f, 1.0f, 0.0f}), 1.0f, false); // open to where the wind comes from
    const double dt = 1.0 / 30.0;
    for (int n = 0; n < 60; ++n)
        (void)wind.step(dt);
    const auto inside = [&] { return speeds_of(wind, k_centre, turned_room(0.0f, {0.0f, 1.0f, 0.0f}), 1.0f).inside; };
    const double open = inside();
    EXPECT_GT(open, 0.5);
    const auto door =
        wind.obstacles().add({.position = k_centre - glm::dvec3(4.2, 0.0, 0.0), .shape = Block{{0.5f, 4.7f, 4.7f}}});
    ASSERT_TRUE(door) << door.error();
    (void)wind.step(dt);
    const double closed = inside();
    EXPECT_GT(closed, 0.1 * open);
    for (int n = 0; n < 240; ++n) {
        (void)wind.step(dt);
        EXPECT_LE(inside(), 1.2 * closed) << "step " << n; // the cells at the walls, which are not counted, may give some
    }
    EXPECT_LT(inside(), 0.2 * closed); // exp(-2) = 0.14
}

TEST(Rooms, BlowWhereAFanRunsInside) {
    Wind wind = made(windy(0.1));
    build_room(wind, k_centre, turned_room(0.0f, {0.0f, 1.0f, 0.0f}), 1.0f);
    const auto fan = wind.motors().add(DirectionalMotor{
        .position = k_centre, .direction = {0.0f, 0.0f, 1.0f}, .region = Sphere{1.5f}, .law = Drive{.speed = 4.0f}});
    ASSERT_TRUE(fan) << fan.error();
    for (int n = 0; n < 60; ++n)
        (void)wind.step(1.0 / 30.0);
    EXPECT_GT(speeds_of(wind, k_centre, turned_room(0.0f, {0.0f, 1.0f, 0.0f}), 1.0f).inside, 0.5);
}

// A box that moves finds a house that was never in it: its air is at rest, and stays so.
TEST(Rooms, AreStillWhereTheyComeIntoTheBox) {
    Wind wind = made(windy(0.12));
    const glm::dvec3 house = k_centre + glm::dvec3(30.0, 0.3, 2.4);
    const glm::quat orientation = turned_room(20.0f, {0.0f, 1.0f, 0.0f});
    build_room(wind, house, orientation, 1.0f);
    for (int n = 0; n < 240; ++n) {
        ASSERT_TRUE(wind.follow(k_centre + glm::dvec3(std::min(0.2 * n, 30.0), 0.0, 0.0)));
        (void)wind.step(1.0 / 30.0);
    }
    const Speeds speeds = speeds_of(wind, house, orientation, 1.0f);
    figure("rooms/entered", speeds.inside / speeds.outside, 1e-3);
    EXPECT_LE(speeds.inside, 1e-3 * speeds.outside);
}

// With its history: the copy of a wind goes on with the same bits.
TEST(Rooms, GoOnWithTheSameBitsWhenLoaded) {
    Wind wind = made(windy(0.12));
    build_room(wind, k_centre + glm::dvec3(8.0, 0.0, 0.0), turned_room(12.0f, {0.0f, 1.0f, 0.0f}), 0.0f);
    const auto walk = [](Wind& walking, int first) {
        for (int n = first; n < first + 20; ++n) {
            ASSERT_TRUE(walking.follow(k_centre + glm::dvec3(0.3 * n, 0.0, 0.1 * n)));
            (void)walking.step(1.0 / 30.0);
        }
    };
    walk(wind, 0);
    const auto bytes = wind.save();
    ASSERT_TRUE(bytes);
    auto loaded = Wind::load(*bytes);
    ASSERT_TRUE(loaded) << loaded.error();
    walk(wind, 20);
    walk(*loaded, 20);
    EXPECT_TRUE(std::equal(wind.field().begin(), wind.field().end(), loaded->field().begin()));
}

} // namespace
