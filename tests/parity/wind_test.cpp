// windrow::vulkan::Wind against windrow::Wind through their public calls: the same config, the same story, frame by frame.
#include "tests/parity/wind_parity.h"

#include <array>
#include <limits>

namespace windrow::vulkan {
namespace {

TEST_F(WindParity, AWalkWithGustsAFanAndATurningWind) {
    TwoWinds pair = make({.cells = {24, 12, 20},
                          .boundaries = Boundaries::open_over_floor(),
                          .centre = {0.0, 6.0, 0.0},
                          .ambient = {3.0f, 0.0f, 1.0f},
                          .profile = LogProfile{},
                          .gusts = {.intensity = 0.25f}});
    pair.add(DirectionalMotor{.position = {4.0, 2.0, 1.0}, .direction = {-1.0f, 0.2f, 0.0f}});
    for (int n = 0; n < 90; ++n) {
        pair.follow({0.05 * n, 0.0, -0.08 * n});
        if (n == 40)
            pair.set_ambient({2.0f, 0.0f, 2.0f});
        frame(pair, 1.0 / 60.0);
    }
    report("walk", pair, 1e-5);
}

TEST_F(WindParity, ABlastAVentAndAWakeInABoxThatFollows) {
    TwoWinds pair = make({.cells = {16, 16, 16}, .ambient = {1.0f, 0.0f, 0.0f}});
    pair.add(OmniMotor{.position = {2.0, 0.5, 0.0}});
    pair.add(PressureMotor{.position = {-3.0, 0.0, 2.0}});
    const auto wake = pair.add(WakeMotor{.position = {-4.0, 0.0, -2.0}, .radius = 1.0f});
    for (int n = 0; n < 90; ++n) {
        pair.move(wake, {-4.0 + 0.2 * n, std::sin(0.1 * n), -2.0});
        pair.follow({0.1 * n, 0.03 * n, 0.0});
        frame(pair, 1.0 / 45.0);
    }
    report("blast", pair, 1e-5);
}

TEST_F(WindParity, SidesThatChangeAndAJumpBeyondTheBox) {
    TwoWinds pair = make({.cells = {12, 10, 14}, .ambient = {2.0f, 0.0f, 1.0f}});
    pair.add(VortexMotor{.position = {0.0, 0.0, 0.0}, .radius = 3.0f});
    for (int n = 0; n < 80; ++n) {
        if (n == 20)
            pair.set_boundaries(Boundaries::open_over_floor());
        if (n == 35)
            pair.set_boundaries(Boundaries::all(BoundaryKind::periodic));
        if (n == 50)
            pair.set_boundaries(Boundaries::all(BoundaryKind::free_slip));
        if (n == 60)
            pair.set_boundaries({});
        if (n == 70)
            pair.follow({1e6, 0.0, 5.0});
        frame(pair, 1.0 / 30.0);
    }
    report("boundaries", pair, 1e-5);
}

// In free air a vent blows beyond the box and into it from outside; walls mirror and cut it, and between two of them, or in a
// periodic box, there is no free air.
TEST_F(WindParity, AVentInEverySortOfFreeAir) {
    const Boundary wall{.kind = BoundaryKind::free_slip}, rough{.kind = BoundaryKind::no_slip};
    const Boundaries corner{.x_low = wall, .y_high = rough, .z_low = wall}, slab{.z_low = wall, .z_high = rough};
    const Boundaries sequence[] = {
        {}, Boundaries::open_over_floor(), corner, slab, {.x_high = wall}, Boundaries::all(BoundaryKind::free_slip), {}};
    TwoWinds pair = make({.cells = {12, 10, 14}, .ambient = {2.0f, 0.0f, 1.0f}});
    pair.add(OmniMotor{.position = {-4.5, -3.5, 1.0}});
    pair.add(OmniMotor{.position = {9.0, 0.0, 0.0}, .speed = -4.0f});
    int n = 0;
    for (const Boundaries& boundaries : sequence) {
        pair.set_boundaries(boundaries);
        for (int frames = 0; frames < 8; ++frames, ++n) {
            pair.follow({0.4 * n, 0.0, -0.2 * n});
            frame(pair, 1.0 / 30.0);
        }
    }
    report("vent_in_free_air", pair, 1e-5);
}

// Everything at once, a hundred steps: uneven ones, gusts over a profile, plants, drives and a force with eddies, a fan and a vent
// that move, a burst.
TEST_F(WindParity, UnevenStepsDrivesEddiesAndGustsTogether) {
    Config config{.cells = {32, 16, 32}, .boundaries = Boundaries::open_over_floor(), .ambient = {4.0f, 0.0f, 1.5f}};
    config.profile = LogProfile{};
    config.gusts.intensity = 0.3f;
    config.canopy = Canopy{.height = 1.5f, .drag = 0.4f};
    TwoWinds pair = make(config);
    pair.add(JetMotor{.position = {-8.0, 2.0, 3.0}, .start_radius = 2.5f, .end_radius = 2.5f});
    pair.add(DirectionalMotor{.position = {5.0, 0.0, -6.0}, .direction = {0.2f, 1.0f, 0.3f}, .law = Force{.acceleration = 8.0f}});
    pair.add(VortexMotor{.position = {2.0, 0.0, 8.0}});
    pair.add(PressureMotor{.position = {-3.0, 1.0, -9.0}, .speed = 8.0f});
    const auto fan = pair.add(DirectionalMotor{.position = {0.0, 1.0, 0.0}, .direction = {0.0f, 0.2f, 1.0f}}),
               wake = pair.add(WakeMotor{.position = {-10.0, -5.0, 0.0}, .radius = 1.5f, .turbulence = {.intensity = 0.1f}}),
               vent = pair.add(OmniMotor{.position = {9.0, -6.0, 4.0}});
    double time = 0.0;
    for (int n = 0; n < 100; ++n) {
        const double dt = (n % 2 == 0 ? 1.0 : 1.7) / 90.0 * (n % 7 == 0 ? 1.8 : 1.0);
        time += dt;
        pair.move(fan, {3.0 * std::sin(time), 1.0, 2.0 * time});
        pair.move(wake, {-10.0 + 5.0 * time, -5.0, 2.0 * std::sin(2.0 * time)});
        pair.move(vent, {9.0 - time, -6.0, 4.0});
        pair.follow({0.8 * time, 0.0, -0.5 * time});
        step(pair, dt);
    }
    report("together", pair, 1e-4);
}

// The device counts its own sub-steps, and cuts speeds as the CPU does.
TEST_F(WindParity, AStormInSubStepsThatTheDeviceChooses) {
    for (const int most : {8, 2}) {
        TwoWinds pair = make({.cells = {16, 12, 16}, .ambient = {4.0f, 0.0f, 0.0f}, .max_substeps = most});
        pair.add(DirectionalMotor{
            .position = {0.0, 0.0, 0.0}, .direction = {0.0f, 0.0f, 1.0f}, .law = Drive{.speed = 900.0f, .rate = 30.0f}});
        pair.add(DirectionalMotor{
            .position = {3.0, 1.0, 2.0}, .direction = {1.0f, 0.5f, 0.0f}, .law = Force{.acceleration = 3000.0f}});
        int max_cpu = 0;
        Diagnostics last;
        for (int n = 0; n < 12; ++n) {
            Advance recorded, cpu;
            frame_of(
                pair,
                [&](VkCommandBuffer commands, int slot) {
                    recorded = held(pair.device.record(commands, {.dt = 1.0 / 30.0, .slot = slot}));
                },
                [&] { cpu = pair.cpu.advance(1.0 / 30.0); });
            if (n > 0) {
                EXPECT_EQ(recorded.last.substeps, last.substeps);
                EXPECT_EQ(recorded.last.substeps_capped, last.substeps_capped);
                EXPECT_NEAR(recorded.last.cfl, last.cfl, 1e-4f * last.cfl);
                EXPECT_NEAR(recorded.last.max_speed, last.max_speed, 1e-4f * last.max_speed);
                EXPECT_NEAR(recorded.last.energy, last.energy, 1e-4 * last.energy);
                EXPECT_NEAR(recorded.last.divergence_rms, last.divergence_rms, 1e-3 * last.divergence_rms);
            }
            last = cpu.last;
            max_cpu = std::max(max_cpu, cpu.last.substeps);
        }
        EXPECT_GE(max_cpu, most == 8 ? 4 : 2);
        report(most == 8 ? "storm" : "storm_capped", pair, 1e-5);
    }
}

TEST_F(WindParity, CellsThatAreNoNumberBecomeAmbient) {
    const Config config{.cells = {12, 12, 12}, .ambient = {1.0f, 0.0f, 0.5f}};
    TwoWinds pair = make(config);
    std::vector<glm::vec4> field(12 * 12 * 12, glm::vec4(1.5f, 0.2f, 0.0f, 0.0f));
    field[100].x = std::numeric_limits<float>::quiet_NaN();
    field[777].z = std::numeric_limits<float>::infinity();
    pair.set_velocity(field);
    for (int n = 0; n < 20; ++n)
        frame(pair, 1.0 / 30.0);
    report("repaired", pair, 1e-5);
}

// Still air costs nothing: nothing is recorded. What wakes it finds the wind as a fresh one.
TEST_F(WindParity, StillAirSleepsAndWakes) {
    const Config config{.cells = {12, 12, 12}, .ambient = {0.0f, 0.0f, 0.0f}, .relaxation_time = 0.3f};
    TwoWinds pair = make(config);
    std::vector<glm::vec4> field(12 * 12 * 12, glm::vec4(0.5f, 0.1f, 0.0f, 0.0f));
    pair.set_velocity(field);
    int asleep_after = 0;
    for (int n = 0; n < 240 && asleep_after == 0; ++n) {
        Advance done;
        run([&](VkCommandBuffer commands) { done = held(pair.device.record(commands, {.dt = 1.0 / 30.0})); });
        asleep_after = done.last.asleep ? n : 0;
    }
    ASSERT_GT(asleep_after, 0);
    for (int n = 0; n < 4; ++n)
        run([&](VkCommandBuffer commands) { held(pair.device.record(commands, {.dt = 1.0 / 30.0})); });
    EXPECT_EQ(pair.device.dispatches(), 0);
    EXPECT_EQ(pair.device.barriers(), 0);
    for (int n = 0; n < 300; ++n)
        (void)pair.cpu.advance(1.0 / 30.0);
    pair.add(DirectionalMotor{.position = {0.0, 0.0, 0.0}});
    forget_frames(pair);
    for (int n = 0; n < 10; ++n)
        frame(pair, 1.0 / 30.0);
    report("woken", pair, 1e-5);
}

// What the host asks for between two frames acts in the order of asking, each with the wind of its moment.
TEST_F(WindParity, AskedForBetweenTwoFrames) {
    TwoWinds pair = make({.cells = {12, 10, 12}, .ambient = {1.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.3f}});
    pair.add(VortexMotor{.position = {0.0, 0.0, 0.0}, .radius = 3.0f});
    for (int n = 0; n < 40; ++n) {
        if (n == 10) // no mean wind carries no gusts
            pair.set_ambient({});
        if (n == 20)
            pair.set_ambient({5.0f, 0.0f, 1.0f});
        if (n == 25) {
            pair.follow({3.0, 0.0, 2.0});
            pair.set_ambient({2.0f, 0.0f, -1.0f});
            pair.set_gusts({.intensity = 0.2f, .seed = 5});
        }
        frame(pair, 1.0 / 30.0);
    }
    report("asked_between_frames", pair, 1e-5);
}

// Walls that open on sleeping air let the wind in; they do not throw it.
TEST_F(WindParity, WallsThatOpenWakeTheAir) {
    const Boundaries walls = Boundaries::all(BoundaryKind::free_slip);
    TwoWinds pair = make({.cells = {10, 8, 10}, .boundaries = walls, .ambient = {3.0f, 0.0f, 0.0f}, .relaxation_time = 5.0f});
    for (int n = 0; n < 10; ++n)
        frame(pair, 1.0 / 30.0);
    pair.set_boundaries({});
    forget_frames(pair);
    for (int n = 0; n < 30; ++n)
        frame(pair, 1.0 / 30.0);
    report("walls_that_open", pair, 1e-5);
}

// Boxes of one cell along one axis or two, which some devices run in groups of another shape.
TEST_F(WindParity, ThinBoxes) {
    for (const glm::ivec3 cells : {glm::ivec3(1, 1, 70), glm::ivec3(24, 1, 1), glm::ivec3(1, 40, 2), glm::ivec3(1, 1, 1)}) {
        TwoWinds pair = make({.cells = cells, .ambient = {1.0f, 0.2f, 2.0f}});
        pair.add(DirectionalMotor{.direction = {0.0f, 1.0f, 0.3f}});
        for (int n = 0; n < 12; ++n)
            frame(pair, 1.0 / 30.0);
        WINDROW_EXPECT_FIGURE("wind_parity.thin_" + std::to_string(cells.x) + "_" + std::to_string(cells.y) + "_" +
                                  std::to_string(cells.z),
                              pair.largest, 1e-5);
    }
}

// What is too large for the device is rejected before anything of its size is made.
TEST_F(WindParity, ABoxThatNoDeviceHoldsIsRejected) {
    if (const auto made = Wind::create(own->host(), {.cells = {2048, 16, 2048}}); made)
        EXPECT_FALSE(own->facts().software) << "only a large GPU has buffers for it";
    else
        EXPECT_NE(made.error().find("2048 x 16 x 2048"), std::string::npos) << made.error();
    expect_error(Wind::create(own->host(), {}, {.frames_in_flight = 0}), "frames_in_flight is 0");
}

} // namespace
} // namespace windrow::vulkan
