// Snapshots of winds on a device: from device to device to the bit, from and to the CPU within the bound of parity.
#include "fluid/vulkan/wind_state.h"
#include "fluid/wind_state.h"
#include "tests/parity/wind_parity.h"

#include <cstring>
#include <glm/geometric.hpp>

namespace windrow::vulkan {
namespace {

class WindSaves : public WindParity {
  protected:
    static Config stormy() {
        return {.cells = {14, 10, 12},
                .boundaries = Boundaries::open_over_floor(),
                .centre = {0.0, 5.0, 0.0},
                .ambient = {2.0f, 0.0f, 1.0f},
                .profile = LogProfile{},
                .gusts = {.intensity = 0.3f},
                .viscosity = 1e-3f};
    }
    static constexpr Settings k_settings{.texel = Texel::single, .frames_in_flight = 1, .queries = ReadBack::cells};

    static void add_motors(Motors& motors) {
        ASSERT_TRUE(motors.add(DirectionalMotor{.position = {3.0, 3.0, 1.0}, .direction = {-1.0f, 0.2f, 0.0f}}));
        ASSERT_TRUE(motors.add(PressureMotor{.position = {-3.0, 3.0, 2.0}}));
        ASSERT_TRUE(motors.add(OmniMotor{.position = {1.0, 4.0, -2.0}}));
    }

    // What a host asks for before frame n.
    template <class AnyWind>
    static void ask(AnyWind& wind, int n) {
        EXPECT_TRUE(wind.follow({0.09 * n, 5.0, -0.12 * n}));
        EXPECT_TRUE(wind.motors().move({.slot = 0, .generation = 1}, {3.0 - 0.02 * n, 3.0, 1.0 + 0.01 * n}));
        if (n % 37 == 20) {
            EXPECT_TRUE(wind.set_ambient({2.0f, 0.0f, 1.0f + 0.01f * static_cast<float>(n)}));
        }
    }

    void record(Wind& wind, double dt, bool ticks, bool save = false) {
        run([&](VkCommandBuffer commands) {
            const Frame frame{.dt = dt, .slot = 0, .save = save};
            ticks ? (void)held(wind.record(commands, frame)) : (void)held(wind.record_step(commands, frame));
        });
        (void)wind.collect(0);
    }

    static std::vector<std::byte> bytes_of(Wind& wind) {
        auto bytes = wind.saved();
        EXPECT_TRUE(bytes) << bytes.error();
        return bytes ? *std::move(bytes) : std::vector<std::byte>();
    }

    Wind load(std::span<const std::byte> bytes) {
        auto wind = Wind::load(sharing_host(), bytes, k_settings);
        EXPECT_TRUE(wind) << wind.error();
        return *std::move(wind);
    }

    static bool same_cells(const Wind& a, const Wind& b) {
        const auto x = a.queried(), y = b.queried();
        return x && y && std::memcmp(x->field().data(), y->field().data(), x->field().size_bytes()) == 0;
    }

    static TwoWinds twins(windrow::Wind cpu, Wind gpu) { return {std::move(cpu), std::move(gpu), 1, nullptr}; }
};

// Each replaces the one before, which the device may be copying still.
TEST_F(WindSaves, OfFramesInFlightReplaceEachOther) {
    TwoWinds pair = make(stormy(), 2, {.texel = Texel::single, .queries = ReadBack::cells});
    for (int n = 0; n < 6; ++n)
        pair.submitter->frame([&](VkCommandBuffer commands, int slot) {
            held(pair.device.record_step(commands, {.dt = 0.02, .slot = slot, .save = true}));
        });
    pair.submitter->wait();
    (void)pair.device.collect(1);
    EXPECT_TRUE(windrow::Wind::load(bytes_of(pair.device)));
}

// The box moves between the load and the first recording, which lets no time pass: readers find bodies where they are.
TEST_F(WindSaves, ThatMoveBeforeTheirFirstTickAreReadRight) {
    windrow::Wind cpu = *windrow::Wind::create({.cells = {14, 10, 12}, .ambient = {3.0f, 0.0f, 1.0f}});
    ASSERT_TRUE(cpu.obstacles().add({.position = {0.3, 0.2, -0.4}, .shape = Block{{1.6f, 1.3f, 1.2f}}}));
    for (int n = 0; n < 10; ++n)
        (void)cpu.step(0.05);
    Wind gpu = load(*cpu.save());
    ASSERT_TRUE(cpu.follow({1.0, 0.0, 0.0}) && gpu.follow({1.0, 0.0, 0.0}));
    record(gpu, 0.0, false);
    for (int n = 0; n < 200; ++n) {
        const glm::dvec3 at(-3.0 + 0.03 * n, 0.02 * (n % 50) - 0.5, 0.03 * (n % 61) - 1.0);
        ASSERT_LE(glm::length(gpu.velocity(at) - cpu.velocity(at)), 1e-4f) << n;
    }
}

TEST_F(WindSaves, ContinueToTheBit) {
    for (const bool ticks : {true, false}) {
        auto made = Wind::create(sharing_host(), stormy(), k_settings);
        ASSERT_TRUE(made) << made.error();
        Wind wind = *std::move(made);
        add_motors(wind.motors());
        int n = 0;
        for (; n < 22; ++n) { // viscosity owes time then
            ask(wind, n);
            record(wind, 1.0 / 47.0, ticks, n == 21);
        }
        EXPECT_NE(wind.state().core.source_name, 0u) << "there is no flow of sources";
        const std::vector<std::byte> bytes = bytes_of(wind);
        const auto on_cpu = windrow::Wind::load(bytes);
        ASSERT_TRUE(on_cpu) << on_cpu.error();
        EXPECT_EQ(*on_cpu->save(), bytes) << "ticks " << ticks; // the same text
        Wind again = load(bytes);
        for (int frame = 0; frame < 100; ++frame, ++n) {
            for (Wind* one : {&wind, &again}) {
                ask(*one, n);
                record(*one, n % 11 == 5 ? 0.0 : 1.0 / 47.0, ticks, frame == 99);
            }
            ASSERT_TRUE(same_cells(wind, again)) << "ticks " << ticks << ", frame " << frame;
            EXPECT_EQ(wind.window_block({}).previous_origin, again.window_block({}).previous_origin) << frame;
        }
        EXPECT_EQ(bytes_of(wind), bytes_of(again));
    }
}

TEST_F(WindSaves, OfTheCpuContinueOnTheDevice) {
    for (const bool ticks : {true, false}) {
        auto cpu = windrow::Wind::create(stormy());
        ASSERT_TRUE(cpu);
        add_motors(cpu->motors());
        for (int n = 0; n < 20; ++n) {
            ask(*cpu, n);
            ticks ? (void)cpu->advance(1.0 / 47.0) : (void)cpu->step(1.0 / 47.0);
        }
        Wind loaded = load(*cpu->save()); // before the wind is moved from: arguments are evaluated in any order
        TwoWinds pair = twins(*std::move(cpu), std::move(loaded));
        for (int n = 20; n < 120; ++n) {
            ask(pair.cpu, n);
            ask(pair.device, n);
            ticks ? frame(pair, 1.0 / 47.0) : step(pair, 1.0 / 47.0);
        }
        EXPECT_EQ(pair.compared, 99);
        report(ticks ? "loaded.ticks" : "loaded.steps", pair, 1e-5);
    }
}

TEST_F(WindSaves, OfTheDeviceContinueOnTheCpu) {
    auto made = Wind::create(sharing_host(), stormy(), k_settings);
    ASSERT_TRUE(made) << made.error();
    add_motors(made->motors());
    for (int n = 0; n < 20; ++n) {
        ask(*made, n);
        record(*made, 1.0 / 47.0, true, n == 19);
    }
    auto cpu = windrow::Wind::load(bytes_of(*made));
    ASSERT_TRUE(cpu) << cpu.error();
    TwoWinds pair = twins(*std::move(cpu), *std::move(made));
    for (int n = 20; n < 120; ++n) {
        ask(pair.cpu, n);
        ask(pair.device, n);
        frame(pair, 1.0 / 47.0);
    }
    report("saved", pair, 1e-5);
}

// Asleep, under gusts that drift, and woken again.
TEST_F(WindSaves, OfSleepingAirSleepOn) {
    for (const float gusts : {0.0f, 0.3f}) {
        Config config = stormy();
        config.viscosity = 0.0f;
        config.gusts.intensity = gusts;
        auto made = Wind::create(sharing_host(), config, k_settings);
        ASSERT_TRUE(made) << made.error();
        Wind wind = *std::move(made);
        const auto asleep = [](const Wind& one) { return one.state().core.sleep.asleep(); };
        int n = 0;
        for (; n < 200 && !asleep(wind); ++n)
            record(wind, 1.0 / 47.0, true);
        record(wind, 1.0 / 47.0, true);
        record(wind, 1.0 / 47.0, true, true);
        ASSERT_TRUE(asleep(wind)) << gusts;
        const std::vector<std::byte> bytes = bytes_of(wind);
        auto cpu = windrow::Wind::load(bytes);
        ASSERT_TRUE(cpu) << cpu.error();
        EXPECT_EQ(*cpu->save(), bytes);
        const AmbientWind& around = cpu->state().core.ambient;
        double worst = 0.0;
        for (int k = 0; k < config.cells.z; ++k) // the wind of now, not that of the frame between two ticks
            for (int j = 0; j < config.cells.y; ++j)
                for (int i = 0; i < config.cells.x; ++i) {
                    const glm::vec3 here(cpu->field()[cpu->box().index(i, j, k)]);
                    worst = std::max(worst, static_cast<double>(
                                                glm::length(here - around.velocity(cpu->state().core.window().centre(i, j, k)))));
                }
        EXPECT_LE(worst, 1e-5) << gusts;
        Wind again = load(bytes);
        EXPECT_TRUE(asleep(again));
        for (int frame = 0; frame < 40; ++frame) {
            for (Wind* one : {&wind, &again}) {
                if (frame == 20) {
                    EXPECT_TRUE(one->motors().add(VortexMotor{.position = {0.0, 4.0, 0.0}}));
                }
                record(*one, 1.0 / 47.0, true);
            }
            ASSERT_EQ(asleep(wind), asleep(again)) << gusts << ' ' << frame;
            if (again.queried()) {
                ASSERT_TRUE(same_cells(wind, again)) << gusts << ' ' << frame;
            }
        }
        EXPECT_FALSE(asleep(again));
    }
}

TEST_F(WindSaves, AreInFlightUntilTheirSlotIsDone) {
    auto made = Wind::create(sharing_host(), {.cells = {8, 8, 8}, .ambient = {2.0f, 0.0f, 0.0f}}, {.frames_in_flight = 2});
    ASSERT_TRUE(made) << made.error();
    expect_error(made->saved(), "no wind is saved: record a frame with Frame::save");
    run([&](VkCommandBuffer commands) { held(made->record(commands, {.dt = 0.02, .slot = 1, .save = true})); });
    expect_error(made->saved(), "still in flight: record or collect its slot 1 again");
    run([&](VkCommandBuffer commands) { held(made->record(commands, {.dt = 0.02, .slot = 0})); });
    expect_error(made->saved(), "still in flight");
    run([&](VkCommandBuffer commands) { held(made->record(commands, {.dt = 0.02, .slot = 1})); });
    auto bytes = made->saved();
    ASSERT_TRUE(bytes) << bytes.error();
    expect_error(made->saved(), "no wind is saved");
    EXPECT_TRUE(Wind::load(sharing_host(), *bytes));
    expect_error(Wind::load(sharing_host(), std::span(*bytes).first(100)), "snapshot is truncated");
    expect_error(Wind::load(sharing_host(), {}), "not a Windrow snapshot");
    bytes->at(200) ^= std::byte{1};
    expect_error(Wind::load(sharing_host(), *bytes), "checksum does not match");
    run([&](VkCommandBuffer commands) { held(made->record(commands, {.dt = 0.02, .slot = 0, .save = true})); });
    made->forget();
    expect_error(made->saved(), "no wind is saved");
}

// Air that is faster than all that acts, and a body that moves in it: the number of sub-steps follows from speeds that the snapshot
// holds. A pause after loading measures none, and must not take their place.
TEST_F(WindSaves, APauseAfterLoadKeepsTheSpeeds) {
    auto cpu = windrow::Wind::create({.cells = {14, 10, 12}, .cell_size = 0.5f});
    ASSERT_TRUE(cpu);
    cpu->set_velocity([](glm::dvec3 p) { return glm::vec3(glm::length(p) < 2.0 ? 200.0f : 0.0f, 0.0f, 0.0f); });
    const auto ball = cpu->obstacles().add({.position = {-1.0, 0.0, 2.0}, .shape = Sphere{0.7f}});
    ASSERT_TRUE(ball);
    const auto move = [&](auto& wind, int n) {
        EXPECT_TRUE(wind.obstacles().move({.slot = ball->slot, .generation = ball->generation}, {-1.0 + 0.02 * n, 0.0, 2.0}));
    };
    int n = 0;
    for (; n < 4; ++n) {
        move(*cpu, n);
        (void)cpu->step(1.0 / 60.0);
    }
    Wind loaded = load(*cpu->save());
    record(loaded, 0.0, false);
    int most = 0;
    for (; n < 14; ++n) {
        move(*cpu, n);
        move(loaded, n);
        const int on_cpu = cpu->step(1.0 / 60.0).substeps;
        record(loaded, 1.0 / 60.0, false);
        EXPECT_EQ(loaded.diagnostics().substeps, on_cpu) << "step " << n;
        most = std::max(most, on_cpu);
    }
    EXPECT_GT(most, 1);
}

// Nothing acts on this air, but it moves: a pause after loading measures nothing, which is not the same as rest.
TEST_F(WindSaves, APauseAfterLoadPutsNoAirToSleep) {
    auto cpu = windrow::Wind::create({.cells = {14, 10, 12}, .cell_size = 0.5f});
    ASSERT_TRUE(cpu);
    cpu->set_velocity([](glm::dvec3 p) { return glm::vec3(glm::length(p) < 2.0 ? 5.0f : 0.0f, 0.0f, 0.0f); });
    for (int n = 0; n < 4; ++n)
        (void)cpu->step(1.0 / 60.0);
    Wind loaded = load(*cpu->save()); // before the wind is moved from
    TwoWinds pair = twins(*std::move(cpu), std::move(loaded));
    record(pair.device, 0.0, false);
    for (int n = 0; n < 6; ++n) {
        step(pair, 1.0 / 60.0);
        ASSERT_FALSE(pair.device_sleeps) << "step " << n;
    }
    report("paused_after_load", pair, 1e-5);
}

TEST_F(WindSaves, AreReadWhileTheySleep) {
    auto cpu = windrow::Wind::create({.cells = {8, 6, 7}});
    ASSERT_TRUE(cpu);
    for (int n = 0; n < 3; ++n)
        (void)cpu->advance(1.0 / 30.0);
    ASSERT_TRUE(cpu->diagnostics().asleep);
    Wind wind = load(*cpu->save());
    for (int n = 0; n < 2; ++n)
        record(wind, 1.0 / 30.0, true);
    const auto cells = wind.cells();
    ASSERT_TRUE(cells) << cells.error();
    EXPECT_EQ(apart(*cells, cpu->field(), 1.0), 0.0);
}

// What is read back and the cells in obstacles are of one place, also after a change that waits for the next recording.
TEST_F(WindSaves, ObstaclesAreInTheBoxThatWasRead) {
    auto wind = Wind::create(sharing_host(), {.cells = {14, 10, 12}, .ambient = {3.0f, 0.0f, 0.0f}}, k_settings);
    ASSERT_TRUE(wind) << wind.error();
    ASSERT_TRUE(wind->obstacles().add({.shape = Block{{4.0f, 4.0f, 4.0f}}}));
    record(*wind, 1.0 / 30.0, false);
    std::vector<float> before(wind->box().cell_count()), after(before.size());
    ASSERT_TRUE(wind->write_obstacles(before));
    EXPECT_TRUE(wind->follow({3.0, 0.0, 0.0}));
    ASSERT_TRUE(wind->write_obstacles(after));
    EXPECT_EQ(before, after) << "the view still is of the box before";
    record(*wind, 0.0, false);
    ASSERT_TRUE(wind->write_obstacles(after));
    const auto view = wind->view();
    ASSERT_TRUE(view);
    EXPECT_EQ(view->origin(), wind->origin());
    EXPECT_NE(before, after);
    EXPECT_EQ(std::count(after.begin(), after.end(), 1.0f), 8 * 8 * 8);
}

// The pressure's history at the bodies is part of it: without it the wind goes on otherwise, and so do the forces.
TEST_F(WindSaves, ObstaclesGoOn) {
    const Config config{.cells = {16, 10, 12}, .ambient = {5.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.2f}};
    const Settings settings{.texel = Texel::single, .queries = ReadBack::cells, .forces = 2};
    auto made = Wind::create(sharing_host(), config, settings);
    ASSERT_TRUE(made) << made.error();
    const auto ball = made->obstacles().add({.position = {-3.0, 0.0, 0.0}, .shape = Sphere{2.0f}});
    ASSERT_TRUE(ball && made->obstacles().add({.position = {3.0, 0.0, 1.0}, .shape = Plate{{2.0f, 3.0f}}}));
    const auto go = [&](Wind& wind, int n, bool save) {
        EXPECT_TRUE(wind.obstacles().move(*ball, {-3.0 + 0.1 * n, 0.0, 0.0}) && wind.follow({0.1 * n, 0.0, 0.0}));
        run([&](VkCommandBuffer commands) { held(wind.record(commands, {.dt = 1.0 / 30.0, .slot = 0, .save = save})); });
        EXPECT_TRUE(wind.collect(0));
    };
    for (int n = 1; n < 10; ++n)
        go(*made, n, n == 9);
    const auto bytes = made->saved();
    ASSERT_TRUE(bytes) << bytes.error();
    auto loaded = Wind::load(sharing_host(), *bytes, settings);
    ASSERT_TRUE(loaded) << loaded.error();
    auto on_cpu = windrow::Wind::load(*bytes);
    ASSERT_TRUE(on_cpu) << on_cpu.error();
    EXPECT_EQ(on_cpu->obstacles().count(), 2);
    const auto off = [&](const auto& one, const auto& other) {
        const auto a = one.force_on(*ball), b = other.force_on(*ball);
        EXPECT_TRUE(a && b);
        return a && b ? static_cast<double>(glm::length(a->force - b->force) / glm::length(b->force)) : 1.0;
    };
    EXPECT_LE(off(*on_cpu, *made), 1e-6) << "before a step";
    for (int n = 10; n < 20; ++n) {
        go(*made, n, false);
        go(*loaded, n, false);
        const auto a = made->queried()->field(), b = loaded->queried()->field();
        ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end())) << "frame " << n;
        EXPECT_TRUE(on_cpu->obstacles().move(*ball, {-3.0 + 0.1 * n, 0.0, 0.0}) && on_cpu->follow({0.1 * n, 0.0, 0.0}));
        (void)on_cpu->advance(1.0 / 30.0);
        EXPECT_EQ(off(*loaded, *made), 0.0) << "frame " << n;
        EXPECT_LE(off(*on_cpu, *made), 1e-4) << "frame " << n;
    }
}

} // namespace
} // namespace windrow::vulkan
