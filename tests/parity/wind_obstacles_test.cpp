// Obstacles on the device against those on the CPU: the same story, frame by frame, with as many direct solves.
#include "tests/parity/wind_parity.h"
#include "tests/shapes.h"
#include "tests/tier.h"

#include <glm/gtc/quaternion.hpp>

namespace windrow::vulkan {
namespace {

class WindObstacles : public WindParity {
  protected:
    using Ids = std::pair<ObstacleId, ObstacleId>;
    static Ids add(TwoWinds& pair, const Obstacle& obstacle) {
        const auto on_cpu = pair.cpu.obstacles().add(obstacle), on_device = pair.device.obstacles().add(obstacle);
        EXPECT_TRUE(on_cpu && on_device) << (on_device ? "" : on_device.error());
        return on_cpu && on_device ? Ids{*on_cpu, *on_device} : Ids{};
    }
    static void move(TwoWinds& pair, const Ids& ids, glm::dvec3 to, glm::quat turned = {1, 0, 0, 0}) {
        EXPECT_TRUE(pair.cpu.obstacles().move(ids.first, to, turned) && pair.device.obstacles().move(ids.second, to, turned));
    }
    static glm::quat about_y(float angle) { return glm::angleAxis(angle, glm::vec3(0.0f, 1.0f, 0.0f)); }
    static constexpr glm::ivec3 k_cells{24, 12, 20};
    static Config gusty_over_floor() {
        return {.cells = k_cells,
                .boundaries = Boundaries::open_over_floor(),
                .centre = {0.0, 6.0, 0.0},
                .ambient = {5.0f, 0.0f, 1.0f},
                .profile = LogProfile{},
                .gusts = {.intensity = 0.2f},
                .pressure_solves = 2};
    }
};

TEST_F(WindObstacles, ASteadyWindAroundABallAndAHouse) {
    for (const int solves : {1, 3}) {
        TwoWinds pair = make({.cells = k_cells,
                              .boundaries = Boundaries::open_over_floor(),
                              .centre = {0.0, 6.0, 0.0},
                              .ambient = {4.0f, 0.0f, 1.0f},
                              .pressure_solves = solves});
        add(pair, {.position = {-4.0, 4.0, 1.0}, .shape = Sphere{2.6f}});
        add(pair, {.position = {4.3, 3.0, -2.0}, .orientation = about_y(0.4f), .shape = Block{{2.5f, 3.0f, 2.7f}}});
        for (int n = 0; n < 30; ++n)
            frame(pair, 1.0 / 30.0);
        report(solves == 1 ? "one solve" : "three solves", pair, 1e-5);
    }
}

// Device memory holds what was there before, not zeros. A ball within one cell closes no face, so nothing of the tables grows; and
// the recording in which a body comes may be thrown away.
TEST_F(WindObstacles, InMemoryThatIsNotZero) {
    Memory blocks(own->host(), device->functions());
    Host host = sharing_host();
    host.memory = memory_of(blocks);
    const Config config{.cells = k_cells,
                        .boundaries = Boundaries::open_over_floor(),
                        .centre = {0.0, 6.0, 0.0},
                        .ambient = {4.0f, 0.0f, 1.0f},
                        .pressure_solves = 1};
    for (const bool thrown_away : {false, true}) {
        auto gpu = Wind::create(host, config, {.texel = Texel::single, .queries = ReadBack::cells});
        ASSERT_TRUE(gpu) << gpu.error();
        TwoWinds pair{*windrow::Wind::create(config), *std::move(gpu), 1, std::make_unique<Submitter>(own->host(), 1)};
        frame(pair, 1.0 / 30.0);
        add(pair, {.position = {0.5, 3.5, 0.5}, .shape = Sphere{thrown_away ? 2.0f : 0.4f}});
        if (thrown_away) {
            pair.submitter->discard(
                [&](VkCommandBuffer commands, int slot) { held(pair.device.record_step(commands, {.dt = 0.03, .slot = slot})); });
            pair.device.forget();
            (void)pair.cpu.step(0.03);
            pair.cpu.reset();
            forget_frames(pair);
        }
        for (int n = 0; n < 10; ++n)
            frame(pair, 1.0 / 30.0);
        pair.submitter->wait();
        report(thrown_away ? "not_zero_and_thrown_away" : "not_zero", pair, 1e-5);
    }
}

// Passes that are made for obstacles read the tables of none.
TEST_F(WindObstacles, NoneAtFirstInMemoryThatIsNotZero) {
    Memory blocks(own->host(), device->functions());
    Host host = sharing_host();
    host.memory = memory_of(blocks);
    auto wind =
        Wind::create(host, {.cells = {8, 6, 8}, .ambient = {3.0f, 0.0f, 1.0f}}, {.queries = ReadBack::points, .obstacles = true});
    ASSERT_TRUE(wind) << wind.error();
    const glm::dvec3 places[] = {{0.3, 0.2, -1.0}, {-2.0, 1.0, 2.0}};
    for (int n = 0; n < 2; ++n)
        run([&](VkCommandBuffer commands) { held(wind->record_step(commands, {.dt = 0.03, .slot = 0, .points = places})); });
    ASSERT_TRUE(wind->collect(0));
    const auto found = wind->queried_points();
    ASSERT_TRUE(found);
    for (const glm::vec4& u : found->velocities)
        EXPECT_NEAR(glm::length(glm::vec3(u) - glm::vec3(3.0f, 0.0f, 1.0f)), 0.0f, 1e-5f);
}

TEST_F(WindObstacles, AWalkAlongFencesInGusts) {
    TwoWinds pair = make(gusty_over_floor());
    for (int n = 0; n < 3; ++n)
        add(pair, {.position = {6.0 * n, 2.0, 0.4 * n},
                   .orientation = about_y(1.2f - 0.5f * static_cast<float>(n)),
                   .shape = Plate{{3.0f, 2.0f}}});
    add(pair, {.position = {3.0, 2.0, -5.0}, .shape = Cylinder{.radius = 1.4f, .half_length = 2.0f}});
    for (int n = 0; n < 40; ++n) {
        pair.follow({0.15 * n, 6.0, 0.05 * n});
        frame(pair, 1.0 / 30.0);
    }
    report("fences", pair, 1e-5);
}

TEST_F(WindObstacles, AWalkOverHills) {
    TwoWinds pair = make(gusty_over_floor());
    add(pair, {.position = {-30.0, 3.0, -30.0}, .shape = Ground{test::heights_of({61, 61}, 1.0f, [](double x, double z) {
                                                    return 2.0 * std::sin(0.3 * x) * std::cos(0.4 * z);
                                                })}});
    for (int n = 0; n < 25; ++n) {
        pair.follow({0.35 * n, 6.0 + 0.1 * n, -0.15 * n});
        frame(pair, 1.0 / 30.0);
    }
    // The start against thousands of cells at the surface: sums of floats here, of doubles there. Later it is 2e-6.
    report("hills", pair, 1e-5);
}

TEST_F(WindObstacles, ABallThatFliesAndADoorThatTurns) {
    TwoWinds pair = make({.cells = k_cells, .ambient = {1.0f, 0.0f, 0.0f}, .pressure_solves = 2});
    const Ids ball = add(pair, {.position = {-6.0, 0.0, 3.0}, .shape = Sphere{2.3f}});
    const Ids door = add(pair, {.position = {4.0, 0.0, -2.0}, .shape = Plate{{2.4f, 3.0f}}});
    const Ids wall = add(pair, {.position = {8.0, 0.0, 2.0}, .shape = Block{{0.6f, 4.0f, 4.0f}}});
    for (int n = 0; n < 40; ++n) {
        move(pair, ball, {-6.0 + 0.2 * n, 0.3 * std::sin(0.2 * n), 3.0});
        move(pair, door, {4.0, 0.0, -2.0}, about_y(0.05f * static_cast<float>(n)));
        if (n == 20) {
            EXPECT_TRUE(pair.cpu.obstacles().remove(wall.first) && pair.device.obstacles().remove(wall.second));
        }
        frame(pair, 1.0 / 30.0);
    }
    report("ball and door", pair, 1e-5);
}

// A room with walls of plates, a fan and a vent in it, in gusts.
TEST_F(WindObstacles, AClosedRoomInGusts) {
    for (const bool works : {true, false}) {
        if (!works && !test::whole_sweeps()) // has less to do
            continue;
        TwoWinds pair =
            make({.cells = k_cells, .ambient = {6.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.15f}, .pressure_solves = 2});
        for (const int side : {-1, 1}) {
            const float s = static_cast<float>(side);
            add(pair,
                {.position = {4.0 * side + 0.5, 0.0, 0.0}, .orientation = about_y(1.57079633f), .shape = Plate{{4.6f, 4.6f}}});
            add(pair, {.position = {0.5, 0.0, 4.0 * side + 0.5}, .shape = Block{{4.6f, 4.6f, 0.6f}}});
            add(pair, {.position = {0.5, 4.0 * side, 0.0},
                       .orientation = glm::angleAxis(1.57079633f * s, glm::vec3(1.0f, 0.0f, 0.0f)),
                       .shape = Plate{{4.6f, 4.6f}}});
        }
        if (works) {
            pair.add(DirectionalMotor{.position = {0.5, 0.0, 0.0}});
            pair.add(OmniMotor{.position = {1.5, 0.5, 0.0}});
        }
        for (int n = 0; n < 12; ++n)
            frame(pair, 1.0 / 30.0);
        report(works ? "a room that blows" : "a still room", pair, 1e-5);
    }
}

TEST_F(WindObstacles, AVentAndAFanBesideAWall) {
    TwoWinds pair = make({.cells = k_cells, .ambient = {1.0f, 0.0f, 0.0f}, .pressure_solves = 2});
    add(pair, {.position = {2.0, 0.0, 0.0}, .orientation = about_y(0.3f), .shape = Block{{1.2f, 4.0f, 5.0f}}});
    pair.add(OmniMotor{.position = {-1.0, 0.0, 0.0}});
    pair.add(DirectionalMotor{.position = {5.0, 0.0, 2.0}, .direction = {-1.0f, 0.0f, 0.0f}});
    pair.add(PressureMotor{.position = {4.0, 0.0, -5.0}});
    for (int n = 0; n < 30; ++n)
        frame(pair, 1.0 / 30.0);
    report("vent", pair, 1e-5);
}

// With sub-steps, bodies that move, come and go, and a vent that begins to blow and ends.
TEST_F(WindObstacles, ForcesAreThoseOfTheCpu) {
    TwoWinds pair = make(gusty_over_floor(), 0, {.texel = Texel::single, .forces = 8});
    std::vector<Ids> bodies = {
        add(pair, {.position = {-4.0, 4.0, 1.0}, .shape = Sphere{2.6f}}),
        add(pair, {.position = {4.3, 3.0, -2.0}, .orientation = about_y(0.4f), .shape = Block{{2.5f, 3.0f, 2.7f}}}),
        add(pair, {.position = {0.0, 3.0, 6.0}, .orientation = about_y(0.9f), .shape = Plate{{2.0f, 3.0f}}})};
    double largest = 0.0, off = 0.0, moment = 0.0, moment_off = 0.0;
    TwoWinds::Ids vent{};
    for (int n = 0; n < (test::k_sanitized ? 16 : 40); ++n) {
        if (n >= 10)
            move(pair, bodies[0], {-4.0 + 0.1 * (n - 10), 4.0, 1.0});
        if (n >= 10 && n < 30)
            move(pair, bodies[2], {0.0, 3.0, 6.0}, about_y(0.9f + 0.03f * static_cast<float>(n - 10)));
        if (n == 15)
            bodies.push_back(add(pair, {.position = {9.0, 2.0, 3.0}, .shape = Cylinder{.radius = 1.2f, .half_length = 2.0f}}));
        if (n == 20)
            vent = pair.add(OmniMotor{.position = {0.5, 3.0, -1.0}});
        if (n == 23) // the vent's flow begins anew
            pair.reset();
        if (n == 28) {
            EXPECT_TRUE(pair.cpu.motors().remove(vent.first) && pair.device.motors().remove(vent.second));
        }
        frame(pair, n % 5 == 4 ? 1.0 / 15.0 : 1.0 / 30.0);
        (void)pair.device.collect(0);
        for (const Ids& body : bodies) {
            const auto on_cpu = pair.cpu.force_on(body.first), on_device = pair.device.force_on(body.second);
            ASSERT_TRUE(on_cpu && on_device) << on_device.error();
            EXPECT_EQ(on_cpu->in_box, on_device->in_box) << n;
            const auto length = [](glm::vec3 v) { return static_cast<double>(glm::length(v)); };
            largest = std::max(largest, length(on_cpu->force));
            moment = std::max(moment, length(on_cpu->moment));
            off = std::max(off, length(on_cpu->force - on_device->force));
            moment_off = std::max(moment_off, length(on_cpu->moment - on_device->moment));
            EXPECT_NEAR(on_device->pressure, on_cpu->pressure, 1e-3f * std::max(1.0f, std::abs(on_cpu->pressure))) << n;
        }
    }
    EXPECT_GT(largest, 1.0);
    WINDROW_EXPECT_FIGURE("wind_parity.forces", off / largest, 1e-4);
    WINDROW_EXPECT_FIGURE("wind_parity.moments", moment_off / moment, 1e-4);
    TwoWinds without = make(gusty_over_floor());
    const Ids ball = add(without, {.position = {0.0, 4.0, 0.0}, .shape = Sphere{2.0f}});
    const auto none = without.device.force_on(ball.second);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error(), "no forces come back from the device: create the wind with Settings::forces.");
}

// Several ticks in a frame, of which the device's host learns together: each tick begins from the speeds that the CPU's does.
TEST_F(WindObstacles, AHitchTakesTheSubstepsOfTheCpu) {
    TwoWinds pair = make({.cells = {14, 10, 12}, .cell_size = 0.25f, .ambient = {2.0f, 0.0f, 0.5f}});
    const Ids ball = add(pair, {.position = {-0.7, 0.0, 0.0}, .shape = Sphere{0.5f}});
    double time = 0.0;
    for (int n = 0; n < 24; ++n) {
        if (n % 8 == 1) // its air slows down, past what a sub-step less carries
            (void)pair.add(PressureMotor{.position = {0.6, 0.0, 0.3}, .radius = 0.8f, .speed = 40.0f});
        const double dt = n % 2 == 0 ? 0.1 : 0.02;
        time += dt;
        move(pair, ball, {-0.7 + 0.4 * time, 0.0, 0.2 * std::sin(3.0 * time)});
        frame(pair, dt);
    }
    report("hitch", pair, 1e-4);
}

// It stands near enough to be placed, and meets no cell.
TEST_F(WindObstacles, NoForceIsOnABodyBesideTheBox) {
    TwoWinds pair = make({.cells = {12, 8, 10}, .ambient = {5.0f, 0.0f, 0.0f}}, 0, {.texel = Texel::single, .forces = 4});
    const Ids inside = add(pair, {.shape = Sphere{2.0f}}),
              beside = add(pair, {.position = {7.6, 0.0, 0.0}, .shape = Sphere{1.0f}});
    for (int n = 0; n < 8; ++n) {
        if (n == 4) {
            EXPECT_TRUE(pair.cpu.obstacles().remove(inside.first) && pair.device.obstacles().remove(inside.second));
        }
        frame(pair, 1.0 / 30.0);
        (void)pair.device.collect(0);
        const auto on_cpu = pair.cpu.force_on(beside.first), on_device = pair.device.force_on(beside.second);
        ASSERT_TRUE(on_cpu && on_device) << on_device.error();
        EXPECT_EQ(on_cpu->force, glm::vec3(0.0f)) << n;
        EXPECT_EQ(on_device->force, glm::vec3(0.0f)) << n;
    }
}

TEST_F(WindObstacles, ViscousAirThatSticks) {
    for (const float viscosity : {0.5f, 20.0f}) { // one pass; a direct solve
        TwoWinds pair = make({.cells = k_cells,
                              .boundaries = Boundaries::open_over_floor(),
                              .ambient = {3.0f, 0.0f, 0.0f},
                              .viscosity = viscosity,
                              .pressure_solves = 2});
        add(pair, {.position = {0.0, -2.0, 0.0}, .shape = Block{{2.0f, 4.0f, 2.0f}}, .surface = Surface::no_slip});
        add(pair, {.position = {-6.0, 0.0, 4.0}, .shape = Sphere{2.0f}, .surface = Surface::no_slip});
        for (int n = 0; n < 12; ++n)
            frame(pair, 1.0 / 30.0);
        report("viscous", pair, 1e-5);
    }
}

TEST_F(WindObstacles, TheClassicSplit) {
    TwoWinds pair = make({.cells = k_cells,
                          .ambient = {3.0f, 0.0f, 1.0f},
                          .scheme = Scheme::stable_fluids,
                          .interpolation = Interpolation::linear,
                          .pressure_solves = 2});
    add(pair, {.position = {0.0, 0.0, 0.0}, .shape = Sphere{3.0f}});
    add(pair, {.position = {6.0, 0.0, 0.0}, .orientation = about_y(1.2f), .shape = Plate{{3.0f, 3.0f}}});
    pair.add(DirectionalMotor{.position = {-6.0, 0.0, 2.0}});
    for (int n = 0; n < 30; ++n)
        frame(pair, 1.0 / 30.0);
    report("classic", pair, 1e-5);
}

} // namespace
} // namespace windrow::vulkan
