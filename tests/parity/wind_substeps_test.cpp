// What is recorded: as many sub-steps as the air can need, and no command that does nothing.
#include "fluid/core/speed_bound.h"
#include "fluid/event_log.h"
#include "fluid/vulkan/wind_state.h"
#include "tests/parity/wind_parity.h"
#include "tests/tier.h"

namespace windrow::vulkan {
namespace {

struct Counts {
    int dispatches = 0, barriers = 0, transfers = 0;
};

class WindSubsteps : public WindParity {
  protected:
    // The most of one tick, after the first. A software device takes a second for each of the largest grid.
    Counts counts(const Config& config, const std::function<void(Wind&, int)>& before) {
        auto wind = Wind::create(sharing_host(), config);
        EXPECT_TRUE(wind) << wind.error();
        Counts most;
        for (int n = 0; n < (config.cells.x < 128 ? 5 : 2); ++n) {
            before(*wind, n);
            const Air& air = *wind->state().cells.air;
            const int transfers = air.transfers();
            run([&](VkCommandBuffer commands) { EXPECT_TRUE(wind->record(commands, {.dt = 1.0 / 30.0})); });
            if (n < 1)
                continue;
            most.dispatches = std::max(most.dispatches, wind->dispatches());
            most.barriers = std::max(most.barriers, wind->barriers());
            most.transfers = std::max(most.transfers, air.transfers() - transfers);
        }
        return most;
    }
};

// One solve around bodies at rest takes one dispatch more than the empty box; each further one four.
TEST_F(WindSubsteps, ObstaclesTakeOneDispatchMoreAndFourASolve) {
    const Config empty{.cells = {32, 16, 32}, .boundaries = Boundaries::open_over_floor(), .ambient = {3.0f, 0.0f, 1.0f}};
    const auto with = [&](const Obstacle& obstacle, int solves) {
        Config config = empty;
        config.pressure_solves = solves;
        return counts(config, [&](Wind& wind, int n) {
            if (n == 0) {
                EXPECT_TRUE(wind.obstacles().add(obstacle) && wind.motors().add(DirectionalMotor{}));
            }
        });
    };
    const int none = counts(empty,
                            [](Wind& wind, int n) { // a fan keeps it awake
                                if (n == 0) {
                                    EXPECT_TRUE(wind.motors().add(DirectionalMotor{}));
                                }
                            })
                         .dispatches;
    const Obstacle house{.shape = Block{{3.0f, 3.0f, 2.0f}}}, fence{.shape = Plate{{3.0f, 3.0f}}};
    EXPECT_EQ(with(house, 1).dispatches, none + 1);
    EXPECT_EQ(with(fence, 1).dispatches, none + 1);
    EXPECT_EQ(with(fence, 0).dispatches, none + 1 + 4) << "two solves by default";
    EXPECT_EQ(with(fence, 2).dispatches, none + 1 + 4);
    EXPECT_EQ(with(fence, 5).dispatches, none + 1 + 4 * 4);
}

// Ticks of 30 Hz in air of 1 m. Quiet: a fan. Walk: shifts, a profile, gusts, a fan, a wake, a canopy. Storm: 150 m/s, of which a
// sub-step carries 60.
TEST_F(WindSubsteps, ATickRecordsWhatItNeeds) {
    for (const glm::ivec3 cells : {glm::ivec3(32, 16, 32), glm::ivec3(64, test::whole_sweeps() ? 32 : 8, 64),
                                   glm::ivec3(128, test::whole_sweeps() ? 64 : 4, 128)}) {
        const std::string grid = std::to_string(cells.x);
        const Config quiet{.cells = cells, .boundaries = Boundaries::open_over_floor(), .ambient = {3.0f, 0.0f, 1.0f}};
        Config air = quiet, walk = quiet, storm = quiet, unlike = quiet;
        air.sleep_speed = 0.0f;
        walk.profile = LogProfile{};
        walk.gusts.intensity = 0.2f;
        walk.canopy = Canopy{.height = 1.0f};
        storm.ambient = {150.0f, 0.0f, 0.0f};
        unlike.boundaries.x_low.kind = BoundaryKind::free_slip;
        const auto fan = [](Wind& wind, int n) {
            if (n == 0) {
                EXPECT_TRUE(wind.motors().add(DirectionalMotor{}));
            }
        };
        MotorId wake{};
        const Counts in_quiet = counts(quiet, fan), in_walk = counts(walk, [&](Wind&wind, int n) {
                                                        const glm::dvec3 at{1.3 * n, 0.5, 0.4 * n};
                                                        fan(wind, n);
                                                        if (n == 0)
                                                            wake = *wind.motors().add(WakeMotor{.position = at});
                                                        EXPECT_TRUE(wind.motors().move(wake, at) && wind.follow(at));
                                                    });
        const Counts in_storm = counts(storm, fan), in_unlike = counts(unlike, fan),
                     in_air = counts(air, [](Wind&wind, int n) {
                         if (n > 0)
                             return;
                         std::vector<glm::vec4> waves(wind.box().cell_count());
                         for (std::size_t cell = 0; cell < waves.size(); ++cell)
                             waves[cell].x = 3.0f + std::sin(0.1f * static_cast<float>(cell));
                         EXPECT_TRUE(wind.set_velocity(waves));
                     });
        for (const auto& [name, count] : {std::pair{"air", in_air}, std::pair{"quiet", in_quiet}, std::pair{"walk", in_walk},
                                          std::pair{"storm", in_storm}, std::pair{"unlike", in_unlike}}) {
            test::figure("recorded.dispatches_" + grid + "." + name, count.dispatches);
            test::figure("recorded.barriers_" + grid + "." + name, count.barriers);
            EXPECT_EQ(count.barriers, count.dispatches) << name << ": one behind each";
            EXPECT_EQ(count.transfers, 0) << name;
        }
        constexpr int k_solve = 3;
        EXPECT_EQ(in_air.dispatches, 4 + k_solve);             // pad, advect, solve, gradient, show, which reports
        EXPECT_EQ(in_quiet.dispatches, 5 + k_solve);           // and sources
        EXPECT_EQ(in_walk.dispatches, 5 + k_solve);            // which write what a shift exposes
        EXPECT_EQ(in_storm.dispatches, 3 + 3 * (3 + k_solve)); // with the plan; 150 m/s are three sub-steps of 60
        // A solve by planes, where the ends of x differ: x and z in passes of their own where no plane fits in shared memory.
        EXPECT_EQ(in_unlike.dispatches, 5 + (cells.x * cells.z > WINDROW_TILE_FLOATS ? 5 : 3));
    }
}

// A log in which the host foresees one sub-step for a fan of 300 m/s, which needs five.
TEST_F(WindSubsteps, AStormThatNobodyForesawIsCarriedOverAndReplayed) {
    const Config config{.cells = {24, 16, 20}, .ambient = {4.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.2f}};
    const DirectionalMotor storm{
        .position = {-4.0, 0.0, 0.0}, .region = Sphere{.radius = 4.0f}, .law = Drive{.speed = 300.0f, .rate = 60.0f}};
    auto wind = Wind::create(sharing_host(), config, {.texel = Texel::single, .frames_in_flight = 1, .queries = ReadBack::cells});
    ASSERT_TRUE(wind) << wind.error();
    EventLog log;
    wind->record_to(&log);
    const auto frame = [&] {
        Advance done;
        run([&](VkCommandBuffer commands) { done = *wind->record(commands, {.dt = 1.0 / 30.0, .slot = 0}); });
        EXPECT_TRUE(wind->collect(0));
        return done;
    };
    for (int n = 0; n < 5; ++n)
        (void)frame();
    const auto fan = wind->motors().add(storm);
    ASSERT_TRUE(fan);
    double longest = 0.0;
    for (int n = 0; n < 40; ++n) {
        if (n < 6)
            wind->state().cells.dictate({.substeps = 1, .limits = false, .rests = false});
        if (n == 12) {
            ASSERT_TRUE(wind->motors().remove(*fan));
        }
        ASSERT_TRUE(wind->follow({0.7 * n, 0.0, 0.2 * n}));
        (void)frame();
        const Diagnostics report = wind->reported();
        EXPECT_EQ(report.limited_cells, 0);
        EXPECT_EQ(report.repaired_cells, 0);
        longest = std::max(longest, static_cast<double>(report.carried_time));
        EXPECT_TRUE(report.carried_time == 0.0f || n < 20) << n;
    }
    test::figure("recorded.longest_carried_s", longest);
    EXPECT_GT(longest, 2.0 / 30.0);
    wind->record_to(nullptr);

    auto bytes = log.to_bytes();
    ASSERT_TRUE(bytes) << bytes.error();
    const auto read = EventLog::from_bytes(*bytes);
    ASSERT_TRUE(read) << read.error();
    for (const int in_flight : {1, 3}) {
        auto again = Wind::create(sharing_host(), config,
                                  {.texel = Texel::single, .frames_in_flight = in_flight, .queries = ReadBack::cells});
        ASSERT_TRUE(again) << again.error();
        const auto done = replay(*read, *again, [&](const auto& record) { return own->run(record); });
        ASSERT_TRUE(done) << done.error();
        ASSERT_TRUE(again->collect((static_cast<int>(45) - 1) % in_flight));
        const auto a = wind->queried()->field(), b = again->queried()->field();
        ASSERT_EQ(a.size(), b.size());
        EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0);
    }
    // What a device recorded is nothing to the CPU.
    auto on_cpu = windrow::Wind::create(config);
    ASSERT_TRUE(on_cpu);
    EXPECT_TRUE(windrow::replay(*read, *on_cpu));
}

} // namespace
} // namespace windrow::vulkan
