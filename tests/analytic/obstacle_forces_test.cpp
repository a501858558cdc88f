// Forces on obstacles: what a body gets is what the air loses, added mass, the direction of pressure.
#include "fluid/wind_state.h"
#include "tests/tier.h"
#include "tests/winds.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace windrow {
namespace {

using namespace test;

glm::quat turned_about(double degrees, glm::dvec3 axis = {0.0, 1.0, 0.0}) {
    return glm::quat(glm::angleAxis(glm::radians(degrees), axis));
}

/// [m^4/s] Momentum of the air over its density.
glm::dvec3 momentum(const Wind& wind) {
    glm::dvec3 sum(0.0);
    for (const glm::vec4& u : wind.field())
        sum += glm::dvec3(u);
    return sum * std::pow(double(wind.box().cell_size), 3);
}

glm::dvec3 force_on(const Wind& wind, ObstacleId id) {
    const auto force = wind.force_on(id);
    EXPECT_TRUE(force) << force.error();
    return glm::dvec3(force->force);
}

// --- Momentum ------------------------------------------------------------------------------------------------------------------

// One projection of noise around bodies of every shape: cells outside lose what the bodies get. Cells inside that a surface cuts are
// pushed too, and the step replaces what they got.
TEST(ObstacleForces, AreTheMomentumThatAProjectionTakes) {
    const Box box{.cells = {24, 20, 22}, .cell_size = 0.5f, .boundaries = Boundaries::all(BoundaryKind::periodic)};
    const Shape shapes[] = {Sphere{1.3f}, Capsule{.half_axis = {0.4f, 0.8f, 0.2f}, .radius = 0.6f}, Block{{0.9f, 1.4f, 0.7f}},
                            Cylinder{.radius = 0.8f, .half_length = 1.2f}, Plate{{1.5f, 1.1f}}};
    std::vector<PlacedObstacle> bodies;
    for (std::size_t n = 0; n < std::size(shapes); ++n) {
        PlacedObstacle body;
        body.shape = shapes[n];
        body.position = {2.2f * float(n) + 1.0f, 3.0f + 0.9f * float(n), 8.0f - 1.3f * float(n)};
        body.axes = glm::mat3(glm::rotate(glm::mat4(1.0f), 0.5f * float(n), glm::vec3(0.3f, 1.0f, 0.2f)));
        body.velocity = {0.5f, -1.0f, float(n)};
        bodies.push_back(body);
    }
    auto work = *Workspace::create({.box = box});
    ASSERT_TRUE(work.set_obstacles(bodies));
    std::vector<glm::vec4> velocity = white_noise(box.cells, 5.0f, 3), gradient(velocity.size());
    project(work, velocity, gradient);
    const Solids& solids = *work.state().solids;
    for (const auto& cell : solids.inside())
        gradient[cell.cell] = glm::vec4(0.0f);
    glm::dvec3 lost(0.0), got(0.0);
    for (const glm::vec4& each : gradient)
        lost += std::pow(double(box.cell_size), 3) * glm::dvec3(each);
    for (std::size_t n = 0; n < bodies.size(); ++n)
        got += glm::dvec3(work.impulse_on(n));
    EXPECT_LT(glm::length(lost - got), 1e-4 * glm::length(got)) << glm::length(got);
}

// The mean force along x on a body in a wind of 10 m/s, over its area and the dynamic pressure, and over places against the cells. Of one
// that moves the air is still and the box follows it.
double drag_of(const Shape& shape, double area, bool moves, double rate) {
    constexpr double k_speed = 10.0, k_from = 0.6, k_to = 1.8; // [m/s, s, s]
    const int places = sampled(6, 4);
    double mean = 0.0;
    for (int n = 0; n < places; ++n) {
        const glm::dvec3 beside = 0.25 * glm::dvec3(n * 0.37 - std::floor(n * 0.37), n * 0.61 - std::floor(n * 0.61), n * 0.23);
        Wind wind = made({.cells = {56, 32, 32},
                          .cell_size = 0.25f,
                          .ambient = {moves ? 0.0f : static_cast<float>(k_speed), 0.0f, 0.0f},
                          .relaxation_time = 0.0f});
        const ObstacleId body = *wind.obstacles().add({.position = beside, .shape = shape});
        const double dt = 1.0 / rate;
        double sum = 0.0;
        int count = 0;
        for (double t = dt; t < k_to; t += dt) {
            if (moves) {
                const glm::dvec3 place = beside - glm::dvec3(k_speed * t, 0.0, 0.0);
                EXPECT_TRUE(wind.obstacles().move(body, place));
                EXPECT_TRUE(wind.follow(place - beside));
            }
            (void)wind.step(dt);
            if (t >= k_from) {
                sum += force_on(wind, body).x;
                ++count;
            }
        }
        mean += sum / count / (0.5 * static_cast<double>(k_air_density) * k_speed * k_speed * area) / places;
    }
    return mean;
}

// A block that moves through still air and one at rest in a wind are one flow. Where the impulse that cells inside take counts as force,
// it is counted anew in each step: .15 and .47 apart, and .18 between the rates. What is left is of cells that a body uncovers.
TEST(ObstacleForces, AreTheSameInAnyFrameAndAtAnyRate) {
    constexpr double k_area = 2.25; // [m^2]
    struct Case {
        const char* name;
        Shape shape;
        double most; // of the difference over the force at rest
    };
    const Case cases[] = {{"flat", Block{{0.26f, 0.75f, 0.75f}}, 0.1}, {"long", Block{{1.5f, 0.75f, 0.75f}}, 0.4}};
    for (const Case& one : cases) {
        const double rests = drag_of(one.shape, k_area, false, 60.0), moves = drag_of(one.shape, k_area, true, 60.0);
        const std::string name = std::string("forces/frames/") + one.name;
        figure(name + "/rests", rests);
        figure(name + "/moves", moves);
        WINDROW_EXPECT_FIGURE(name + "/apart", std::abs(moves - rests) / rests, one.most);
    }
    const double slow = drag_of(cases[1].shape, k_area, true, 60.0), fast = drag_of(cases[1].shape, k_area, true, 240.0);
    WINDROW_EXPECT_FIGURE("forces/frames/long/60_against_240_hz", std::abs(fast - slow) / slow, 0.12);
}

struct Story {
    const char* name;
    Config config{};
    bool blast = false;
};
void PrintTo(const Story& story, std::ostream* stream) {
    *stream << story.name;
}

class Momentum : public ::testing::TestWithParam<Story> {};

// Plates have no cells inside: all of the air's momentum is in the cells. So slow that transport moves none of it.
TEST_P(Momentum, OfTheAirIsWhatBodiesGive) {
    Config config = GetParam().config;
    config.cells = {16, 14, 12};
    config.boundaries = Boundaries::all(BoundaryKind::periodic);
    config.relaxation_time = config.sleep_speed = config.viscosity = 0.0f;
    Wind wind = made(config);
    const ObstacleId sail = *wind.obstacles().add({.position = {-3.1, 0.2, 0.3}, .shape = Plate{{2.0f, 3.0f}}}),
                     fence = *wind.obstacles().add(
                         {.position = {3.4, -1.0, 0.0}, .orientation = turned_about(65.0), .shape = Plate{{2.5f, 2.0f}}});
    if (GetParam().blast) {
        added(wind, PressureMotor{.position = {0.0, 1.0, 2.0}, .radius = 1.5f, .speed = 1e-3f, .duration = 0.3f});
    }
    glm::dvec3 before = momentum(wind);
    double most = 0.0;
    for (int n = 1; n <= 30; ++n) {
        const double way = 7 * n % 4 / 65536.0, dt = n % 3 == 0 ? 0.02 : 0.05;
        if (n < 20) {
            ASSERT_TRUE(wind.obstacles().move(sail, {-3.1 + way, 0.2, 0.3 + 0.5 * way}, turned_about(1e-5 * n)));
        }
        (void)wind.step(dt);
        const glm::dvec3 after = momentum(wind),
                         given = -dt / double(k_air_density) * (force_on(wind, sail) + force_on(wind, fence));
        most = std::max(most, glm::length(given));
        EXPECT_LT(glm::length(after - before - given), 1e-4 * most) << "step " << n;
        before = after;
    }
    EXPECT_GT(most, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Stories, Momentum,
                         ::testing::Values(Story{"second_order", {}}, Story{"sub_steps", {.max_cfl = 2e-5f}},
                                           Story{"stable_fluids", {.scheme = Scheme::stable_fluids}}, Story{"blast", {}, true}));

// --- Known forces --------------------------------------------------------------------------------------------------------------

// A ball that starts in still air (Lamb 1932, art. 92): half of the mass that it displaces.
TEST(ObstacleForces, ABallThatStartsHasHalfItsMassAdded) {
    Wind wind = made({.cells = glm::ivec3(48), .cell_size = 1.0f / 16.0f});
    const ObstacleId ball = *wind.obstacles().add({.position = {0.01, 0.02, 0.0}, .shape = Sphere{0.5f}});
    const double dt = 0.01, speed = 0.2;
    ASSERT_TRUE(wind.obstacles().move(ball, {0.01 + speed * dt, 0.02, 0.0}));
    (void)wind.step(dt);
    const double mass = double(k_air_density) * std::numbers::pi / 6.0;
    EXPECT_NEAR(-force_on(wind, ball).x / (mass * speed / dt), 0.5, 0.04);
}

// A ball that speeds up evenly from rest, with one solve a step, two, and the converged one. The first step has no pressure to
// begin from, so that few solves leave a part of its impulse to the next ones.
TEST(ObstacleForces, ABallThatSpeedsUpHasHalfItsMassAdded) {
    for (const int solves : {1, 2, 40}) {
        Wind wind =
            made({.cells = glm::ivec3(48), .cell_size = 1.0f / 16.0f, .relaxation_time = 0.0f, .pressure_solves = solves});
        const ObstacleId ball = *wind.obstacles().add({.position = {0.01, 0.02, 0.0}, .shape = Sphere{0.5f}});
        const double dt = 0.01, rate = 2.0, mass = double(k_air_density) * std::numbers::pi / 6.0;
        double place = 0.01, first = 0.0, later = 0.0;
        for (int n = 1; n <= 8; ++n) {
            place += rate * dt * n * dt;
            ASSERT_TRUE(wind.obstacles().move(ball, {place, 0.02, 0.0}));
            (void)wind.step(dt);
            const double added = -force_on(wind, ball).x / (mass * rate);
            if (n == 1)
                first = added;
            if (n >= 3)
                later += added / 6.0;
        }
        const std::string name = "forces/ball/solves_" + std::to_string(solves);
        figure(name + "/first_step", first);
        figure(name + "/later", later);
        EXPECT_NEAR(first, 0.5, solves == 40 ? 0.04 : 0.15);
        EXPECT_NEAR(later, 0.5, 0.05);
    }
}

// The force of pressure on a plate is normal to it, whatever way the cells lie. A plate across the wind has a drag of about
// 1.2 times its area and the dynamic pressure (Hoerner 1965, Fluid-Dynamic Drag).
TEST(ObstacleForces, AreNormalToAPlate) {
    for (const double degrees : {0.0, 30.0, 45.0, 60.0}) {
        Wind wind = made({.cells = {40, 24, 32}, .ambient = {8.0f, 0.0f, 0.0f}, .relaxation_time = 0.0f});
        const glm::quat orientation = turned_about(90.0 - degrees);
        const ObstacleId sail =
            *wind.obstacles().add({.position = {-6.0, 0.0, 0.2}, .orientation = orientation, .shape = Plate{{4.0f, 4.0f}}});
        glm::dvec3 sum(0.0);
        for (int n = 0; n < 120; ++n) {
            (void)wind.step(0.1);
            if (n >= 60)
                sum += force_on(wind, sail) / 60.0;
        }
        const glm::dvec3 normal(orientation * glm::vec3(0.0f, 0.0f, 1.0f));
        const double along = glm::dot(sum, normal), off = glm::length(sum - along * normal);
        EXPECT_LT(off, 0.15 * along) << degrees << " degrees";
        const double drag = sum.x / (0.5 * double(k_air_density) * 64.0 * 64.0);
        figure("forces/plate_" + std::to_string(int(degrees)) + "/drag", drag);
        EXPECT_GT(drag, 0.4);
        EXPECT_LT(drag, 2.5);
        if (degrees == 0.0) {
            EXPECT_NEAR(drag, 1.2, 0.5);
        }
    }
}

TEST(ObstacleForces, InGustsFollowTheGusts) {
    Wind wind = made({.cells = {24, 16, 20}, .ambient = {8.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.2f, .length = 16.0f}});
    const ObstacleId sail = *wind.obstacles().add({.orientation = turned_about(90.0), .shape = Plate{{3.0f, 3.0f}}});
    double sum = 0.0, squares = 0.0;
    const int count = 200;
    for (int n = -50; n < count; ++n) {
        (void)wind.step(0.05);
        const double drag = force_on(wind, sail).x / (0.5 * double(k_air_density) * 64.0 * 36.0);
        if (n >= 0) // the wind that meets it at once is over
            sum += drag, squares += drag * drag;
    }
    const double mean = sum / count, deviation = std::sqrt(squares / count - mean * mean);
    EXPECT_GT(mean, 0.5);
    EXPECT_LT(mean, 2.5);
    EXPECT_GT(deviation, 0.05 * mean);
}

// A moment by hand: the pressure x y beside a block. Faces that it touches count as closed, and so do 1e-4 of a cell around it.
TEST(ObstacleForces, TurnABlock) {
    const Box box{.cells = {20, 16, 8}, .cell_size = 1.0f};
    PlacedObstacle block;
    block.shape = Block{{4.0f, 2.0f, 1.0f}};
    block.position = {10.0f, 8.0f, 4.0f};
    auto work = *Workspace::create({.box = box});
    ASSERT_TRUE(work.set_obstacles(std::span(&block, 1)));
    Workspace::State& state = work.state();
    for_each_cell(box.cells, [&](int i, int j, int k) {
        const glm::vec3 off = glm::vec3(i, j, k) + 0.5f - block.position;
        state.potential[std::size_t(k * box.cells.y + j) * std::size_t(state.pressure.pitch()) + std::size_t(i)] =
            off.x * off.y + 3.0f * off.z + 5.0f;
    });
    const PressurePush push = state.solid_flow().push_on(0, state.potential.data());
    // Faces at x = -4, 4 read x = -4.5, 4.5, and those at y, z likewise.
    const double y_squares = 2.0 * (0.25 + 2.25), x_squares = 2.0 * (0.25 + 2.25 + 6.25 + 12.25);
    EXPECT_NEAR(push.twist.z, 2.0 * (2.0 * 4.5 * y_squares - 2.0 * 2.5 * x_squares), 0.1);
    EXPECT_NEAR(push.twist.x, 0.0, 1e-3);
    EXPECT_NEAR(push.impulse.z, -3.0 * 3.0 * 32.0, 0.1);
    EXPECT_NEAR(push.impulse.x, 0.0, 1e-3);
    EXPECT_NEAR(push.potential, 5.0, 1e-4);
}

} // namespace
} // namespace windrow
