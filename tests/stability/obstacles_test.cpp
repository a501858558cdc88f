// Hard cases with obstacles: what moves nothing from outside creates no energy, and no speed runs away.
#include "fluid/thread_pool.h"
#include "tests/shapes.h"
#include "tests/stability/watch.h"

#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_obstacle_cells(24, 12, 24);

ObstacleId placed(Wind& wind, const Obstacle& obstacle) {
    const auto id = wind.obstacles().add(obstacle);
    EXPECT_TRUE(id) << id.error();
    return id ? *id : ObstacleId{};
}

glm::quat turned(float degrees, glm::vec3 axis) {
    return glm::angleAxis(glm::radians(degrees), glm::normalize(axis));
}

constexpr glm::ivec3 k_few_cells(16, 8, 16);

Config closed_box() {
    return {.cells = k_few_cells,
            .boundaries = Boundaries::all(BoundaryKind::free_slip),
            .centre = {8.0, 4.0, 8.0},
            .viscosity = 0.0f,
            .relaxation_time = 0.0f,
            .max_cfl = 1e6f,
            .max_substeps = 1};
}

// White noise of 1 m/s between walls and bodies at rest. The energy of the first step's end is the measure: what the noise blew
// against the walls has gone by then.
void expect_calms(const std::string& name, Wind& wind, float cfl) {
    EXPECT_TRUE(wind.set_velocity(white_noise(k_few_cells, 1.0f, 5)));
    (void)wind.step(1e-4);
    const double largest = largest_speed(wind.field());
    Watch watch(wind);
    const int steps = k_sanitized ? 50 : whole_sweeps() ? 10'000 : 300;
    take_steps(watch, steps, static_cast<double>(cfl) / std::max(largest, 1.0));
    watch.judge("obstacles/" + name, {.energy = 1.001, .max = 1.5});
}

// Every angle at once: plates that cross, in a box of noise.
TEST(ObstacleStability, PlatesOfEveryAngleCreateNoEnergy) {
    for (const float cfl : {0.1f, 1.0f, 5.0f, 50.0f}) {
        Wind wind = made(closed_box());
        for (const float angle : {0.0f, 27.0f, 45.0f, 63.0f})
            placed(wind, {.position = {3.0 + 0.07 * static_cast<double>(angle), 4.0, 8.0},
                          .orientation = turned(90.0f + angle, {0.0f, 1.0f, 0.0f}),
                          .shape = Plate{.half_size = {6.0f, 3.0f}}});
        placed(wind,
               {.position = {12.0, 3.5, 8.0}, .orientation = turned(50.0f, {1.0f, 0.3f, 0.2f}), .shape = Plate{{3.0f, 3.0f}}});
        expect_calms("plates/cfl_" + std::to_string(static_cast<int>(cfl * 10.0f)), wind, cfl);
    }
}

TEST(ObstacleStability, BodiesOfEveryShapeCreateNoEnergy) {
    for (const float cfl : {0.2f, 2.0f, 10.0f}) {
        Wind wind = made(closed_box());
        placed(wind, {.position = {3.3, 3.1, 4.2}, .shape = Sphere{1.9f}});
        placed(
            wind,
            {.position = {11.1, 2.0, 4.7}, .orientation = turned(31.0f, {0.0f, 1.0f, 0.0f}), .shape = Block{{2.0f, 2.0f, 1.4f}}});
        placed(wind, {.position = {4.4, 4.0, 11.5}, .shape = Cylinder{.radius = 1.3f, .half_length = 8.0f}});
        placed(wind, {.position = {11.0, 3.0, 12.0}, .shape = Capsule{.half_axis = {2.0f, 1.0f, 1.0f}, .radius = 0.8f}});
        placed(wind, {.position = {8.0, 4.0, 8.0}, .shape = Block{{0.3f, 2.5f, 2.5f}}}); // thinner than a cell
        expect_calms("bodies/cfl_" + std::to_string(static_cast<int>(cfl * 10.0f)), wind, cfl);
    }
}

// Ridges of two and of five cells, one steeper than 60 degrees.
TEST(ObstacleStability, HillsCreateNoEnergy) {
    for (const float cfl : {0.5f, 2.0f, 10.0f}) {
        Wind wind = made(closed_box());
        placed(wind, {.shape = Ground{heights_of({17, 17}, 1.0f, [](double x, double z) {
                          return 2.5 + 1.7 * std::sin(1.1 * x) * std::cos(0.5 * z) + 0.8 * std::sin(0.4 * x + 0.9 * z);
                      })}});
        expect_calms("hills/cfl_" + std::to_string(static_cast<int>(cfl * 10.0f)), wind, cfl);
    }
}

// A box whose cells are all inside, but one.
TEST(ObstacleStability, AnAirCellAloneIsBounded) {
    Wind wind = made(closed_box());
    for (const int axis : {0, 1, 2}) // it is cell (8, 4, 8)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 middle(8.5, 4.5, 8.5);
            middle[axis] += side * 10.5;
            placed(wind,
                   {.position = middle, .shape = Block{glm::vec3(20.0f) - glm::vec3(axis == 0, axis == 1, axis == 2) * 10.0f}});
        }
    EXPECT_TRUE(wind.set_velocity(white_noise(k_few_cells, 1.0f, 5)));
    Watch watch(wind, 1.0);
    watch.run(1'000, 0.5);
    watch.judge("obstacles/one_cell", {.energy = 1.001, .max = 1.5});
}

// The air that is in front of a body at 100 m/s must get out of its way, no faster than a few times its speed.
TEST(ObstacleStability, BodiesAtAHundredMetresASecondAreBounded) {
    Wind wind = made({.cells = k_obstacle_cells,
                      .boundaries = Boundaries::open_over_floor(),
                      .centre = {12.0, 6.0, 12.0},
                      .ambient = {3.0f, 0.0f, 0.0f}});
    const ObstacleId train = placed(wind, {.position = {0.0, 3.0, 12.0}, .shape = Block{{6.0f, 2.5f, 1.5f}}});
    const ObstacleId ball = placed(wind, {.position = {12.0, 9.0, 18.0}, .shape = Sphere{1.2f}});
    Watch watch(wind, 100.0);
    for (int n = 0; n < shortened(2'000); ++n) {
        const double way = 60.0 * (n * 100.0 / 30.0 / 60.0 - std::floor(n * 100.0 / 30.0 / 60.0));
        (void)wind.obstacles().move(train, {-20.0 + way, 3.0, 12.0});
        (void)wind.obstacles().move(ball, {12.0 + 6.0 * std::sin(0.55 * n), 9.0, 12.0 + 6.0 * std::cos(0.55 * n)},
                                    turned(40.0f * static_cast<float>(n), {0.2f, 1.0f, 0.4f}));
        (void)watch.step(1.0 / 30.0);
    }
    watch.judge("obstacles/fast", {.energy = 1.0, .max = 4.0});
}

TEST(ObstacleStability, BodiesThatComeAndGoInEveryStepAreBounded) {
    Wind wind = made(
        {.cells = k_obstacle_cells, .centre = {12.0, 6.0, 12.0}, .ambient = {8.0f, 0.0f, 2.0f}, .gusts = {.intensity = 0.2f}});
    Random random(3);
    std::vector<ObstacleId> ids;
    Watch watch(wind, 8.25);
    for (int n = 0; n < shortened(2'000); ++n) {
        if (ids.size() > 6) {
            EXPECT_TRUE(wind.obstacles().remove(ids.front()));
            ids.erase(ids.begin());
        }
        const glm::dvec3 at(24.0 * random.real(0.0, 1.0), 12.0 * random.real(0.0, 1.0),
                            24.0 * random.real(0.0, 1.0)); // half outside too
        const float size = 0.3f + 3.0f * static_cast<float>(random.real(0.0, 1.0));
        const glm::quat any = turned(360.0f * static_cast<float>(random.real(0.0, 1.0)), {0.3f, 1.0f, 0.5f});
        Obstacle made{.position = at, .orientation = any};
        if (n % 3 == 0)
            made.shape = Plate{{size, size}};
        else if (n % 3 == 1)
            made.shape = Sphere{size};
        else
            made.shape = Block{{size, 0.4f * size, 0.2f * size}};
        ids.push_back(placed(wind, made));
        (void)watch.step(n % 2 == 0 ? 1.0 / 60.0 : 1.0 / 25.0);
    }
    watch.judge("obstacles/come_and_go", {.energy = 3.0, .max = 6.0});
}

// The box follows a walk through a street; the air that stays is the same as in a box that was always there.
TEST(ObstacleStability, AWalkThroughAStreetHasTheSameBitsAnywhereInTheWorld) {
    const auto walk = [](glm::dvec3 corner) {
        Wind wind = made({.cells = k_obstacle_cells,
                          .boundaries = Boundaries::open_over_floor(),
                          .centre = corner + glm::dvec3(12.0, 6.0, 12.0),
                          .ambient = {6.0f, 0.0f, 1.0f}});
        for (int house = 0; house < 8; ++house)
            placed(wind, {.position = corner + glm::dvec3(6.0 + 7.0 * house, 2.0, house % 2 == 0 ? 7.5 : 16.5),
                          .orientation = turned(10.0f * static_cast<float>(house), {0.0f, 1.0f, 0.0f}),
                          .shape = Block{{2.5f, 3.0f, 2.0f}}});
        Watch watch(wind, 6.0);
        for (int n = 0; n < 90; ++n) {
            EXPECT_TRUE(wind.follow(corner + glm::dvec3(12.0 + 0.4 * n, 6.0, 12.0)));
            (void)watch.step(1.0 / 30.0);
        }
        watch.judge("obstacles/street", {.energy = 2.0, .max = 3.0});
        return Field(wind.field().begin(), wind.field().end());
    };
    EXPECT_EQ(walk(glm::dvec3(0.0)), walk({65536.0, 0.0, -131072.0}));
}

TEST(ObstacleStability, TheNumberOfThreadsChangesNoBit) {
    const auto run = [](ParallelFor parallel_for) {
        Wind wind = made({.cells = k_obstacle_cells,
                          .ambient = {6.0f, 0.0f, 1.0f},
                          .gusts = {.intensity = 0.2f},
                          .parallel_for = parallel_for});
        const ObstacleId door = placed(wind, {.position = {2.0, 0.0, 0.0}, .shape = Plate{{3.0f, 3.0f}}});
        placed(wind, {.position = {-4.0, -2.0, 1.0}, .shape = Sphere{2.0f}});
        for (int n = 0; n < 30; ++n) {
            (void)wind.obstacles().move(door, {2.0, 0.0, 0.0}, turned(6.0f * static_cast<float>(n), {0.0f, 1.0f, 0.0f}));
            (void)wind.step(1.0 / 30.0);
        }
        return Field(wind.field().begin(), wind.field().end());
    };
    ThreadPool pool(3);
    EXPECT_EQ(run({}), run(pool.parallel_for()));
}

} // namespace
