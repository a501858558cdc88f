// What comes back to the host: the report alone, all cells, halves, a box or points, each against the CPU's query of its frame.
#include "fluid/vulkan/air.h"
#include "tests/parity/wind_parity.h"

#include <glm/geometric.hpp>

namespace windrow::vulkan {
namespace {

class WindReads : public WindParity {
  protected:
    static Config walk() {
        return {.cells = {24, 14, 20},
                .boundaries = Boundaries::open_over_floor(),
                .centre = {0.0, 7.0, 0.0},
                .ambient = {3.0f, 0.0f, 1.0f},
                .profile = LogProfile{},
                .gusts = {.intensity = 0.25f}};
    }

    // Places around a player: within 2.4 cells, and some far away.
    static std::vector<glm::dvec3> places(glm::dvec3 player, bool far) {
        std::vector<glm::dvec3> all;
        for (int n = 0; n < 20; ++n)
            all.push_back(player + 2.4 * glm::dvec3(std::sin(1.7 * n), std::sin(2.3 * n + 1.0), std::sin(3.1 * n + 2.0)));
        if (far) {
            all.emplace_back(60.0, 3.0, -80.0);
            all.emplace_back(player.x + 11.0, 0.1, player.z);
            all.emplace_back(0.0, -5.0, 0.0);
            all.emplace_back(std::nan(""), 0.0, 0.0);
        }
        return all;
    }

    static constexpr int k_frames = 45;

    struct Expected {
        std::vector<glm::dvec3> places;
        std::vector<glm::vec3> winds;
    };

    // [m/s] Largest difference from the CPU in a walk of 45 frames, with pauses where the places differ from frame to frame.
    double walk_through(Settings settings, int in_flight, bool pauses, bool ticks = true) {
        TwoWinds pair = make(walk(), in_flight, settings);
        pair.add(DirectionalMotor{.position = {4.0, 2.0, 1.0}, .direction = {-1.0f, 0.2f, 0.0f}});
        std::deque<Expected> expected;
        double worst = 0.0;
        int compared = 0;
        for (int n = 0; n < k_frames; ++n) {
            const glm::dvec3 point(0.11 * n, 7.0, -0.13 * n), player = point + glm::dvec3(0.35 * n - 7.0, -3.0, 0.28 * n - 6.0);
            pair.follow(point);
            if (n == 25)
                pair.set_ambient({2.0f, 0.0f, 2.0f});
            const double dt = pauses && n % 5 == 3 ? 0.0 : 1.0 / 50.0;
            Expected now{.places = places(player, settings.queries != ReadBack::box), .winds = {}};
            pair.submitter->frame([&](VkCommandBuffer commands, int slot) {
                const Frame frame{.dt = dt, .slot = slot, .around = player, .points = now.places};
                ticks ? (void)held(pair.device.record(commands, frame)) : (void)held(pair.device.record_step(commands, frame));
            });
            if (expected.size() == static_cast<std::size_t>(in_flight)) {
                worst = std::max(worst, difference(pair.device, expected.front()));
                expected.pop_front();
                ++compared;
            }
            ticks ? (void)pair.cpu.advance(dt) : (void)pair.cpu.step(dt);
            now.winds.resize(now.places.size());
            pair.cpu.velocity(now.places, now.winds);
            expected.push_back(std::move(now));
        }
        pair.submitter->wait();
        EXPECT_EQ(compared, k_frames - in_flight);
        return worst;
    }

    static double difference(const Wind& device, const Expected& expected) {
        double worst = 0.0;
        const auto points = device.queried_points();
        if (points) {
            EXPECT_TRUE(std::equal(points->positions.begin(), points->positions.end(), expected.places.begin(),
                                   [](glm::dvec3 a, glm::dvec3 b) { return a == b || std::isnan(a.x); }));
        }
        for (std::size_t n = 0; n < expected.places.size(); ++n) {
            const glm::vec3 wind = points ? glm::vec3(points->velocities[n]) : device.velocity(expected.places[n]);
            worst = std::max(worst, static_cast<double>(glm::length(wind - expected.winds[n])));
        }
        return worst;
    }
};

constexpr double k_bound = 8e-5; // [m/s] 1e-5 of the fastest air, 8 m/s

TEST_F(WindReads, OfCellsAreTheCpusQuery) {
    for (const int in_flight : {1, 2, 3})
        WINDROW_EXPECT_FIGURE("wind_reads.cells",
                              walk_through({.texel = Texel::single, .queries = ReadBack::cells}, in_flight, false), k_bound);
}

TEST_F(WindReads, OfHalvesAreTheCpusQueryRounded) {
    const double worst = walk_through({.texel = Texel::single, .queries = ReadBack::halves}, 2, false);
    WINDROW_EXPECT_FIGURE("wind_reads.halves", worst, 8.0 * std::sqrt(3.0) / 4096.0 + k_bound); // 4096: half a unit of 11 bits
    EXPECT_GT(worst, 2e-4) << "these are not halves";
}

TEST_F(WindReads, OfABoxAreTheCpusQueryAroundAPlayer) {
    const Settings settings{.texel = Texel::single, .queries = ReadBack::box, .read_cells = {7, 7, 8}};
    for (const int in_flight : {1, 2, 3})
        WINDROW_EXPECT_FIGURE("wind_reads.box", walk_through(settings, in_flight, true), k_bound);
    WINDROW_EXPECT_FIGURE("wind_reads.box_by_steps", walk_through(settings, 2, false, false), k_bound);
}

TEST_F(WindReads, OfPointsAreTheCpusQuery) {
    const Settings settings{.texel = Texel::single, .queries = ReadBack::points, .read_points = 24};
    for (const int in_flight : {1, 2, 3})
        WINDROW_EXPECT_FIGURE("wind_reads.points", walk_through(settings, in_flight, true), k_bound);
    WINDROW_EXPECT_FIGURE("wind_reads.points_by_steps", walk_through(settings, 2, false, false), k_bound);
}

// The boundaries of the box that are not its own are open; periodic ones stay where it spans the axis.
TEST_F(WindReads, OfABoxKeepTheBoundariesThatAreItsOwn) {
    Config config{.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}};
    config.boundaries = Boundaries::open_over_floor();
    config.boundaries.x_low.kind = config.boundaries.x_high.kind = BoundaryKind::periodic;
    config.boundaries.z_low.kind = config.boundaries.z_high.kind = BoundaryKind::periodic;
    TwoWinds pair = make(config, 0, {.queries = ReadBack::box, .read_cells = {12, 4, 5}});
    pair.add(VortexMotor{.radius = 3.0f});
    for (int n = 0; n < 3; ++n)
        run([&](VkCommandBuffer commands) {
            held(pair.device.record_step(commands, {.dt = 0.02, .around = glm::dvec3(0.0, -100.0, -100.0)}));
        });
    (void)pair.cpu.step(0.02);
    (void)pair.cpu.step(0.02);
    const auto view = pair.device.queried();
    ASSERT_TRUE(view);
    const Boundaries& sides = view->box().boundaries;
    EXPECT_TRUE(sides.periodic(0));
    EXPECT_EQ(sides.y_low.kind, config.boundaries.y_low.kind);
    EXPECT_EQ(sides.y_high.kind, BoundaryKind::open);
    EXPECT_EQ(sides.z_low.kind, BoundaryKind::open);
    EXPECT_EQ(sides.z_high.kind, BoundaryKind::open);
    EXPECT_EQ(view->origin().y, pair.device.origin().y);
    for (const double x : {-50.0, 0.3, 5.9, 6.1, 40.0}) { // around the ring, and below the floor
        const glm::dvec3 place(x, pair.device.origin().y + 0.2, view->origin().z + 2.0);
        EXPECT_LE(glm::length(view->velocity(place) - pair.cpu.velocity(place)), 3e-5f) << x;
    }
}

TEST_F(WindReads, AreTheReportAloneByDefault) {
    const Config config{.cells = {16, 16, 16}, .ambient = {2.0f, 0.0f, 1.0f}};
    auto cells = Wind::create(sharing_host(), config, {.queries = ReadBack::cells}), none = Wind::create(sharing_host(), config);
    ASSERT_TRUE(cells && none);
    EXPECT_GE(cells->memory_bytes(), none->memory_bytes() + 3 * 16 * 4096);
    EXPECT_EQ(Air::slot_bytes({}), 64u);
    EXPECT_EQ(Air::slot_bytes({.kind = ReadBack::cells, .cells = {16, 16, 16}}), 64u + 16 * 4096);
    EXPECT_EQ(Air::slot_bytes({.kind = ReadBack::halves, .cells = {16, 16, 16}}), 64u + 8 * 4096);
    EXPECT_EQ(Air::slot_bytes({.kind = ReadBack::box, .cells = {8, 8, 8}}), 64u + 16 * 512);
    EXPECT_EQ(Air::slot_bytes({.kind = ReadBack::points, .points = 64}), 64u + 16 * 64);
    Diagnostics diagnostics;
    for (int n = 0; n < 5; ++n) {
        run([&](VkCommandBuffer commands) { diagnostics = held(none->record_step(commands, {.dt = 1.0 / 30.0})); });
        EXPECT_FALSE(none->queried() || none->queried_halves() || none->queried_points());
    }
    EXPECT_EQ(diagnostics.max_speed, 2.0f);
    EXPECT_NEAR(diagnostics.energy, 0.5 * 5.0 * 4096.0, 1e-2);
    // Of more work groups than the report has invocations.
    auto large = Wind::create(sharing_host(), {.cells = {48, 24, 40}, .ambient = {2.0f, 0.0f, 1.0f}});
    ASSERT_TRUE(large) << large.error();
    run([&](VkCommandBuffer commands) { held(large->record_step(commands, {.dt = 1.0 / 30.0, .slot = 0})); });
    ASSERT_TRUE(large->collect(0));
    EXPECT_NEAR(large->reported().energy, 0.5 * 5.0 * 46080.0, 1e-1);
    EXPECT_EQ(none->velocity({0.0, 0.0, 0.0}), glm::vec3(2.0f, 0.0f, 1.0f)); // the ambient wind
}

// What the host holds is not written until it is taken back: the device runs on meanwhile.
TEST_F(WindReads, ThatAreHeldAreNotWritten) {
    for (const int in_flight : {1, 2, 3}) {
        TwoWinds pair = make({.cells = {8, 8, 8}, .ambient = {2.0f, 0.0f, 1.0f}}, in_flight);
        pair.add(VortexMotor{});
        std::vector<glm::vec4> before;
        for (int n = 0; n < 12; ++n) {
            std::span<const glm::vec4> kept;
            std::vector<glm::vec4> copy;
            pair.submitter->frame([&](VkCommandBuffer commands, int slot) {
                held(pair.device.record_step(commands, {.dt = 0.03, .slot = slot}));
                if (const auto view = pair.device.queried()) {
                    kept = view->field();
                    copy.assign(kept.begin(), kept.end());
                }
            });
            pair.submitter->wait();
            ASSERT_EQ(kept.size(), n < in_flight ? 0u : 512u);
            EXPECT_TRUE(std::equal(kept.begin(), kept.end(), copy.begin())) << n;
            if (n > in_flight) {
                EXPECT_NE(copy, before) << n;
            }
            before = copy;
        }
    }
}

// Points come back while the air sleeps, and in a pause.
TEST_F(WindReads, OfPointsComeBackFromSleepingAir) {
    TwoWinds pair = make({.cells = {12, 10, 12},
                          .boundaries = Boundaries::open_over_floor(),
                          .centre = {0.0, 5.0, 0.0},
                          .ambient = {3.0f, 0.0f, 0.0f},
                          .profile = LogProfile{}},
                         0, {.queries = ReadBack::points, .read_points = 1});
    for (int n = 0; n < 12; ++n) {
        const std::vector<glm::dvec3> points = {{0.1 * n, 0.5 + 0.4 * n, 0.0}, {0.0, 0.0, 0.0}}; // one more than fits
        run([&](VkCommandBuffer commands) { held(pair.device.record(commands, {.dt = n < 8 ? 0.05 : 0.0, .points = points})); });
        ASSERT_TRUE(pair.device.collect(0)) << n;
        const auto winds = pair.device.queried_points();
        ASSERT_TRUE(winds);
        ASSERT_EQ(winds->velocities.size(), 1u);
        EXPECT_EQ(winds->positions.front(), points.front());
        EXPECT_LE(glm::length(glm::vec3(winds->velocities.front()) - pair.cpu.velocity(points.front())), 3e-6f) << n;
    }
}

TEST_F(WindReads, RejectWhatDoesNotFit) {
    const Config config{.cells = {8, 8, 8}};
    const auto with = [&](const Settings& settings) { return Wind::create(sharing_host(), config, settings); };
    expect_error(with({.queries = ReadBack::box, .read_cells = {9, 8, 8}}), "read_cells is 9 x 8 x 8");
    expect_error(with({.queries = ReadBack::box, .read_cells = {8, 0, 8}}), "read_cells is 8 x 0 x 8");
    expect_error(with({.queries = ReadBack::points, .read_points = 0}), "read_points is 0");
    expect_error(with({.queries = ReadBack::points, .read_points = 4097}), "give 1 to 4096");
}

} // namespace
} // namespace windrow::vulkan
