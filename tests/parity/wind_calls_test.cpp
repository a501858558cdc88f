// Each call of a wind in the middle of its run, and each way to step it, against the CPU.
#include "tests/parity/wind_parity.h"

namespace windrow::vulkan {
namespace {

class WindCalls : public WindParity {
  protected:
    // A run with something to see, in which `at(pair, n)` acts before frame n; by ticks at another rate than the frames, or by
    // steps.
    void live(const std::string& name, const Config& config, const std::function<void(TwoWinds&, int)>& at, double bound = 1e-5) {
        for (const bool ticks : {true, false}) {
            TwoWinds pair = make(config);
            pair.add(VortexMotor{.position = config.centre, .radius = 3.0f});
            pair.add(DirectionalMotor{.position = config.centre + glm::dvec3(2.0, 0.5, -1.0), .direction = {0.0f, 0.3f, -1.0f}});
            for (int n = 0; n < 60; ++n) {
                at(pair, n);
                if (ticks)
                    frame(pair, 1.0 / 47.0);
                else
                    step(pair, 1.0 / 47.0);
            }
            report(name + (ticks ? ".ticks" : ".steps"), pair, bound);
        }
    }
};

TEST_F(WindCalls, ResetInTheMiddle) {
    live("reset", {.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}}, [](TwoWinds& pair, int n) {
        if (n == 20 || n == 21 || n == 40)
            pair.reset();
        if (n == 40) // and what comes after it
            pair.follow({2.0, 0.0, 0.0});
    });
}

TEST_F(WindCalls, TheFloorMoves) {
    for (const bool gusts : {false, true})
        live(gusts ? "floor_gusts" : "floor",
             {.cells = {12, 10, 11},
              .boundaries = Boundaries::open_over_floor(),
              .centre = {0.0, 5.0, 0.0},
              .ambient = {3.0f, 0.0f, 1.0f},
              .profile = LogProfile{},
              .gusts = {.intensity = gusts ? 0.3f : 0.0f}},
             [](TwoWinds& pair, int n) {
                 if (n % 10 == 5)
                     pair.set_floor(n == 45 ? 40.0 : 0.2 * n);
                 if (n % 20 == 5)
                     pair.set_ambient({3.0f - 0.05f * static_cast<float>(n), 0.0f, 1.0f});
             });
}

TEST_F(WindCalls, GustsComeAndGo) {
    live("gusts", {.cells = {12, 10, 11}, .ambient = {3.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.2f}},
         [](TwoWinds& pair, int n) {
             if (n == 10)
                 pair.set_gusts({});
             if (n == 20)
                 pair.set_gusts({.intensity = 0.4f, .seed = 9});
             if (n >= 30 && n < 40) // a ramp
                 pair.set_gusts({.intensity = 0.04f * static_cast<float>(40 - n), .seed = 9});
         });
}

TEST_F(WindCalls, CellsAreSetInTheMiddle) {
    const Config config{.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}};
    std::vector<glm::vec4> field(12 * 10 * 11);
    for (std::size_t n = 0; n < field.size(); ++n)
        field[n] = glm::vec4(std::sin(0.1f * static_cast<float>(n)), 0.3f, std::cos(0.07f * static_cast<float>(n)), 5.0f);
    live("set_velocity", config, [&](TwoWinds& pair, int n) {
        if (n == 15 || n == 16 || n == 33 || n == 50)
            pair.set_velocity(field);
        if (n == 33)
            pair.follow({0.0, 3.0, 0.0});
    });
}

TEST_F(WindCalls, ManySubSteps) {
    Config config{.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}};
    config.max_cfl = 0.06f; // 2 to 7 parts for these motors
    config.max_substeps = 16;
    live("substeps", config, [](TwoWinds&, int) {});
}

TEST_F(WindCalls, ViscosityInEveryMethod) {
    const auto none = [](TwoWinds&, int) {};
    for (const float viscosity : {2e-3f, 1.0f, 30.0f}) {
        Config config{.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}, .viscosity = viscosity};
        config.max_cfl = 0.1f;
        live("viscosity_" + std::to_string(static_cast<int>(1e3f * viscosity)), config, none);
    }
}

// The ratio of a tick alone lies below the limit of the explicit pass, with what it owes above it.
TEST_F(WindCalls, ViscosityAtTheEdgeOfTheExplicitPass) {
    const double dt = 1.0 / 47.0;
    TwoWinds pair =
        make({.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}, .viscosity = static_cast<float>(0.99999 / 12.0 / dt)});
    pair.add(VortexMotor{.radius = 3.0f});
    for (int n = 0; n < 40; ++n) {
        step(pair, 2e-5); // too short for floats: owed
        step(pair, dt);
    }
    report("viscosity_edge", pair, 1e-5);
}

// A step of several seconds is beyond what the device prepares for: what one explicit pass may not carry is owed, and not lost.
// The CPU takes the same time in steps of a second, whose passes are as long as the device's to one part in 25.
TEST_F(WindCalls, ViscosityOfALongStepIsOwed) {
    Config config{.cells = {12, 10, 11}, .ambient = {0.0f, 0.0f, 0.0f}, .viscosity = 0.08f, .relaxation_time = 0.0f};
    config.stages.advection = false;
    TwoWinds pair = make(config);
    std::vector<glm::vec4> field(12 * 10 * 11);
    for (std::size_t n = 0; n < field.size(); ++n)
        field[n].x = std::sin(1.0472f * static_cast<float>(n / 12 % 10));
    pair.set_velocity(field);
    run([&](VkCommandBuffer commands) { held(pair.device.record_step(commands, {.dt = 8.0})); });
    for (int n = 0; n < 8; ++n)
        (void)pair.cpu.step(1.0);
    for (int n = 0; n < 30; ++n) // in which it is paid back
        step(pair, 0.1);
    (void)pair.cpu.step(0.1);
    run([&](VkCommandBuffer commands) { held(pair.device.record_step(commands, {.dt = 0.1})); });
    run([&](VkCommandBuffer commands) { held(pair.device.record(commands, {.dt = 0.0})); });
    WINDROW_EXPECT_FIGURE("wind_parity.viscosity_owed", apart(pair.device.queried()->field(), pair.cpu.field()), 0.02);
}

TEST_F(WindCalls, StagesLeftOut) {
    for (const int left_out : {0, 1, 2, 3, 4}) {
        Config config{.cells = {12, 10, 11},
                      .boundaries = Boundaries::open_over_floor(),
                      .centre = {0.0, 5.0, 0.0},
                      .ambient = {2.0f, 0.0f, 1.0f},
                      .profile = LogProfile{},
                      .viscosity = 0.5f,
                      .relaxation_time = 2.0f};
        bool* const stages[] = {&config.stages.sources, &config.stages.relaxation, &config.stages.diffusion,
                                &config.stages.advection, &config.stages.projection};
        *stages[left_out] = false;
        live("without_stage_" + std::to_string(left_out), config, [](TwoWinds& pair, int n) {
            if (n == 5)
                pair.set_ambient({1.0f, 0.0f, 2.0f});
        });
    }
}

// What half textures round away is gone from them alone: not from the air, nor from queries.
TEST_F(WindCalls, HalfTexturesLeaveTheAirAsItIs) {
    TwoWinds pair = make({.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}}, 0, {.texel = Texel::half});
    pair.add(VortexMotor{});
    for (int n = 0; n < 60; ++n)
        frame(pair, 1.0 / 47.0);
    report("half", pair, 1e-5);
}

// Air that sleeps reports its ambient wind, and cells that were repaired are told once.
TEST_F(WindCalls, ReportsAreToldOnceAndSleepReportsAmbient) {
    Config config{.cells = {10, 10, 10}, .ambient = {1.0f, 0.0f, 0.5f}, .relaxation_time = 0.2f};
    TwoWinds pair = make(config);
    std::vector<glm::vec4> field(1000, glm::vec4(1.5f, 0.2f, 0.0f, 0.0f));
    field[100].x = std::nanf("");
    field[777].z = std::nanf("");
    field[778].z = std::nanf("");
    pair.set_velocity(field);
    std::int64_t repaired = 0;
    Diagnostics last;
    for (int n = 0; n < 400 && !last.asleep; ++n) { // some frames have no tick, others two
        const double dt = n % 3 == 0 ? 1.0 / 14.0 : 1.0 / 61.0;
        run([&](VkCommandBuffer commands) {
            const Advance done = held(pair.device.record(commands, {.dt = dt, .slot = 0}));
            if (done.ticks > 0)
                last = done.last;
            repaired += done.last.repaired_cells;
        });
    }
    EXPECT_EQ(repaired, 3);
    ASSERT_TRUE(last.asleep);
    EXPECT_EQ(last.max_speed, 1.0f);
    EXPECT_NEAR(last.energy, 0.5 * 1.25 * 1000.0, 1e-3);
    EXPECT_EQ(last.divergence_rms, 0.0);
}

// Whatever a frame holds, its report has the cells that were repaired: two ticks, of which the second counts none; a step; or
// the answer to a host that asks.
TEST_F(WindCalls, RepairedCellsAreToldToEveryHost) {
    enum class HostKind { two_ticks, one_tick, steps, asks };
    for (const HostKind host : {HostKind::two_ticks, HostKind::one_tick, HostKind::steps, HostKind::asks}) {
        TwoWinds pair = make({.cells = {10, 10, 10}, .ambient = {1.0f, 0.0f, 0.5f}});
        std::vector<glm::vec4> field(1000, glm::vec4(1.5f, 0.2f, 0.0f, 0.0f));
        field[777].z = std::nanf("");
        ASSERT_TRUE(pair.device.set_velocity(field));
        std::int64_t repaired = 0;
        for (int n = 0; n < 4; ++n) {
            run([&](VkCommandBuffer commands) {
                if (host == HostKind::steps) {
                    repaired += held(pair.device.record_step(commands, {.dt = 1.0 / 30.0})).repaired_cells;
                    return;
                }
                const double dt = host == HostKind::two_ticks ? 2.0 / 30.0 : 1.0 / 30.0;
                const Advance done = held(pair.device.record(commands, {.dt = dt}));
                EXPECT_EQ(done.ticks, host == HostKind::two_ticks ? 2 : 1);
                repaired += done.last.repaired_cells;
            });
            if (host == HostKind::asks && n == 0) {
                EXPECT_TRUE(pair.device.collect(0));
                repaired += pair.device.reported().repaired_cells;
            }
        }
        EXPECT_EQ(repaired, 1) << static_cast<int>(host);
    }
}

} // namespace
} // namespace windrow::vulkan
