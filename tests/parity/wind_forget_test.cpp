// Recordings that are never submitted, slots out of turn, and what waits while nothing is recorded.
#include "fluid/vulkan/work_queue.h"
#include "tests/parity/wind_parity.h"

namespace windrow::vulkan {
namespace {

using WindRecordings = WindParity;

// The host throws a command buffer away: the wind begins again, as a reset one, with its motors and its sides.
TEST_F(WindRecordings, ThatAreNeverSubmittedAreForgotten) {
    TwoWinds pair = make({.cells = {24, 20, 24}, .ambient = {2.0f, 0.0f, 1.0f}}, 2, // tables of more than 64 KiB
                         {.texel = Texel::single, .timestamps = true});
    pair.add(VortexMotor{});
    for (int n = 0; n < 16; ++n) {
        if (n == 5 || n == 9) {
            pair.set_boundaries(n == 5 ? Boundaries::open_over_floor() : Boundaries{});
            pair.submitter->discard(
                [&](VkCommandBuffer commands, int slot) { held(pair.device.record_step(commands, {.dt = 0.03, .slot = slot})); });
            pair.device.forget();
            (void)pair.cpu.step(0.03); // the motors of both have lived through it
            pair.cpu.reset();
            forget_frames(pair);
        }
        step(pair, 1.0 / 30.0);
    }
    EXPECT_GT(pair.compared, 6);
    EXPECT_TRUE(pair.device.pass_times());
    report("forgotten", pair, 1e-5);
    pair.submitter->wait();
}

// A house is taken away in a recording that is thrown away: nothing of it is left to read.
TEST_F(WindRecordings, ThatAreForgottenLeaveNoHouseBehind) {
    auto wind = Wind::create(sharing_host(), {.cells = {10, 8, 10}, .ambient = {3.0f, 0.0f, 0.0f}},
                             {.frames_in_flight = 1, .queries = ReadBack::points});
    ASSERT_TRUE(wind) << wind.error();
    const auto house = wind->obstacles().add({.shape = Block{{1.5f, 1.5f, 1.5f}}});
    ASSERT_TRUE(house);
    const glm::dvec3 places[] = {{1.2, 0.3, 0.2}, {-1.8, 0.1, 0.0}};
    const auto record = [&](VkCommandBuffer commands) {
        held(wind->record_step(commands, {.dt = 1.0 / 30.0, .slot = 0, .points = places}));
    };
    run(record);
    ASSERT_TRUE(wind->obstacles().remove(*house));
    Submitter(own->host(), 1).discard([&](VkCommandBuffer commands, int) { record(commands); });
    wind->forget();
    run(record);
    (void)wind->collect(0);
    const auto found = wind->queried_points();
    ASSERT_TRUE(found);
    for (const glm::vec4& u : found->velocities)
        EXPECT_NEAR(glm::length(glm::vec3(u) - glm::vec3(3.0f, 0.0f, 0.0f)), 0.0f, 1e-4f);
}

// What a recording that is thrown away has replaced, the frame in flight before it still uses: the layer says where not.
TEST_F(WindRecordings, ThatAreForgottenEndNothingInFlight) {
    TwoWinds pair = make({.cells = {16, 10, 16}, .ambient = {2.0f, 0.0f, 1.0f}}, 2);
    const auto add_block = [&](auto& wind, double at) {
        ASSERT_TRUE(wind.obstacles().add({.position = {at, 0.3 * at, -at}, .shape = Block{{0.7f, 0.8f, 0.6f}}}));
    };
    add_block(pair.device, 0.0);
    for (int n = 0; n < 3; ++n)
        pair.submitter->frame(
            [&](VkCommandBuffer commands, int slot) { held(pair.device.record_step(commands, {.dt = 0.03, .slot = slot})); });
    for (int n = 1; n < 13; ++n)
        add_block(pair.device, 0.55 * (n % 2 == 0 ? n : -n));
    pair.submitter->discard(
        [&](VkCommandBuffer commands, int slot) { held(pair.device.record_step(commands, {.dt = 0.03, .slot = slot})); });
    pair.device.forget();
    for (int n = 0; n < 3; ++n)
        pair.submitter->frame(
            [&](VkCommandBuffer commands, int slot) { held(pair.device.record_step(commands, {.dt = 0.03, .slot = slot})); });
    pair.submitter->wait();
    EXPECT_TRUE(pair.device.collect(0));
}

// What was thrown away counts as no recording: the next unnamed one takes its slot, whose turn it still is.
TEST_F(WindRecordings, ThatAreForgottenLeaveTheTurnOfTheirSlot) {
    auto wind = Wind::create(sharing_host(), {.cells = {8, 8, 8}, .ambient = {2.0f, 0.0f, 1.0f}}, {.frames_in_flight = 2});
    ASSERT_TRUE(wind) << wind.error();
    const auto record = [&](VkCommandBuffer commands) { held(wind->record(commands, {.dt = 1.0 / 30.0})); };
    run(record); // slot 0
    Submitter(own->host(), 1).discard([&](VkCommandBuffer commands, int) { record(commands); });
    wind->forget();
    wind->forget(); // what is forgotten already is not forgotten twice
    run(record);
    EXPECT_FALSE(wind->collect(0));
    EXPECT_TRUE(wind->collect(1));
}

// The moments that the slot's queries still hold are those of the recording before it.
TEST_F(WindRecordings, ThatAreForgottenHaveNoTimes) {
    auto wind = Wind::create(sharing_host(), {.cells = {8, 8, 8}, .ambient = {2.0f, 0.0f, 1.0f}},
                             {.frames_in_flight = 1, .timestamps = true});
    ASSERT_TRUE(wind) << wind.error();
    ASSERT_TRUE(wind->motors().add(VortexMotor{}));
    const auto timed = [&] {
        int dispatches = 0;
        if (const auto times = wind->pass_times())
            for (const PassTimes::Pass& pass : times->passes)
                dispatches += pass.dispatches;
        return dispatches;
    };
    run([&](VkCommandBuffer commands) { held(wind->record_step(commands, {.dt = 1.0 / 30.0})); });
    const int submitted = wind->dispatches();
    Submitter(own->host(), 1).discard([&](VkCommandBuffer commands, int) { held(wind->record_step(commands, {.dt = 0.0})); });
    ASSERT_NE(wind->dispatches(), submitted);
    wind->forget();
    (void)wind->collect(0);
    EXPECT_EQ(timed(), submitted);
}

// A slot that is not named is the next in turn, and what is older than what was taken is not taken.
TEST_F(WindRecordings, TakeTheirSlotsInAnyOrder) {
    auto wind = Wind::create(sharing_host(), {.cells = {8, 8, 8}, .ambient = {2.0f, 0.0f, 1.0f}}, {.frames_in_flight = 3});
    ASSERT_TRUE(wind) << wind.error();
    ASSERT_TRUE(wind->motors().add(VortexMotor{}));
    const auto age_after = [&](int slot) {
        run([&](VkCommandBuffer commands) { held(wind->record(commands, {.dt = 1.0 / 30.0, .slot = slot})); });
        return 30.0 * wind->query_age();
    };
    for (const int slot : {0, 1, 2})
        (void)age_after(slot);
    EXPECT_NEAR(age_after(2), 1.0, 1e-9);  // that of the third is taken
    EXPECT_NEAR(age_after(0), 2.0, 1e-9);  // not that of the first
    EXPECT_NEAR(age_after(-1), 3.0, 1e-9); // slot 1, not that of the second
    EXPECT_NEAR(age_after(-1), 3.0, 1e-9); // slot 2: the fourth
}

// Bad input records nothing, changes nothing and is named.
TEST_F(WindRecordings, ThatAreRejectedSayWhyAndLeaveTheWindAsItWas) {
    auto wind = Wind::create(sharing_host(), {.cells = {8, 8, 8}, .ambient = {2.0f, 0.0f, 1.0f}}, {.frames_in_flight = 2});
    ASSERT_TRUE(wind) << wind.error();
    const double infinity = std::numeric_limits<double>::infinity();
    run([&](VkCommandBuffer commands) {
        held(wind->record(commands, {.dt = 1.0 / 30.0})); // slot 0
        const VkImage shown = wind->textures().vectors.image;
        expect_error(wind->record(commands, {.dt = -1.0}), "dt is -1: give");
        expect_error(wind->record(commands, {.dt = infinity}), "dt is inf: give");
        expect_error(wind->record(commands, {.dt = std::nan("")}), "dt is nan: give");
        expect_error(wind->record_step(commands, {.dt = 1e60}), "dt is 1e+60: give");
        expect_error(wind->record(commands, {.dt = 0.1, .slot = 2}), "slot is 2: give one from 0 to 1 (Settings::");
        expect_error(wind->record_step(commands, {.dt = 0.0, .slot = -2}), "slot is -2: give one from 0 to 1 (Settings::");
        expect_error(wind->record(VK_NULL_HANDLE, {.dt = -0.1}), "commands is null: give a command buffer");
        expect_error(wind->record(VK_NULL_HANDLE, {.dt = -0.1}), "dt is -0.1: give");
        EXPECT_EQ(wind->textures().vectors.image, shown);
    });
    EXPECT_EQ(wind->query_age(), 0.0);                                                        // nothing was read yet
    run([&](VkCommandBuffer commands) { held(wind->record(commands, {.dt = 1.0 / 30.0})); }); // slot 1, whose turn it is
    EXPECT_TRUE(wind->collect(1));
    EXPECT_EQ(wind->query_age(), 0.0);
}

// A window that is minimised for an hour: what waits stays small.
TEST_F(WindRecordings, ThatWaitAreFolded) {
    const AmbientWind calm = *AmbientWind::create({.mean = {1.0f, 0.0f, 0.0f}});
    WorkQueue queue;
    const Window window{.cells = {8, 8, 8}, .cell_size = 1.0f, .origin_cells = {}};
    const auto work = [&](CellChange::Kind kind) {
        return CellChange{.kind = kind, .ambient = calm, .window = window, .has_source_flow = true};
    };
    for (int n = 0; n < 100; ++n) {
        CellChange shift = work(CellChange::Kind::shift);
        shift.by = {1, 0, -2};
        queue.push(shift);
    }
    EXPECT_EQ(queue.size(), 1u);
    CellChange back = work(CellChange::Kind::shift); // loses what left the box
    back.by = {-1, 0, 0};
    queue.push(back);
    EXPECT_EQ(queue.size(), 2u);
    for (int n = 0; n < 100; ++n) {
        CellChange change = work(CellChange::Kind::add_change);
        change.change = {0.1f, 0.0f, 0.0f};
        queue.push(change);
    }
    EXPECT_EQ(queue.size(), 3u);
    for (int n = 0; n < 100; ++n) // a ramp: the old wind goes, the new one comes
        for (const int step : {0, 1}) {
            CellChange wind = work(CellChange::Kind::add_wind);
            wind.factor = step == 0 ? -1.0f : 1.0f;
            ASSERT_TRUE(wind.ambient.set_mean({0.1f * static_cast<float>(n + step), 0.0f, 0.0f}));
            queue.push(wind);
        }
    EXPECT_EQ(queue.size(), 5u); // the first goes, the last comes
    for (int n = 0; n < 100; ++n)
        queue.push(work(CellChange::Kind::set));
    EXPECT_EQ(queue.size(), 3u); // the shifts move what stays, the flow of sources
    queue.push(work(CellChange::Kind::fill));
    EXPECT_EQ(queue.size(), 1u);
}

// The same of a host with ticks, where what is kept of the air changes by itself.
TEST_F(WindRecordings, ThatWaitWithTicksAreFolded) {
    AmbientWind wind = *AmbientWind::create({.mean = {1.0f, 0.0f, 0.0f}});
    Window window{.cells = {8, 8, 8}, .cell_size = 1.0f, .origin_cells = {}};
    WorkQueue queue;
    const auto work = [&](CellChange::Kind kind) {
        return CellChange{.kind = kind, .ambient = wind, .window = window, .kept = true, .has_source_flow = true};
    };
    const auto change = [&](bool to_air) {
        CellChange one = work(CellChange::Kind::add_change);
        const glm::vec3 mean = wind.mean();
        EXPECT_TRUE(wind.set_mean(mean + glm::vec3(0.01f, 0.0f, 0.0f)));
        one.ambient = wind;
        one.change = wind.mean() - mean;
        one.to_air = to_air;
        return one;
    };
    const auto shift = [&] {
        CellChange one = work(CellChange::Kind::shift);
        one.by = {1, 0, 0};
        return one;
    };
    for (int n = 0; n < 100; ++n) { // set_ambient on calm air
        queue.push(change(false));
        queue.push(work(CellChange::Kind::fill));
    }
    EXPECT_EQ(queue.size(), 2u);
    for (int n = 0; n < 100; ++n) { // set_floor on sleeping air
        window.origin_cells.y = n;
        queue.push(work(CellChange::Kind::fill_before));
    }
    EXPECT_EQ(queue.size(), 2u); // the air, and what is kept of it
    queue.push(work(CellChange::Kind::fill));
    queue.push(work(CellChange::Kind::fill_before)); // a reset
    EXPECT_EQ(queue.size(), 2u);
    for (int n = 0; n < 100; ++n) { // a walk while the wind turns
        queue.push(shift());
        queue.push(change(true));
    }
    EXPECT_EQ(queue.size(), 4u);
    queue.push(work(CellChange::Kind::fill));
    EXPECT_EQ(queue.size(), 4u); // fill_before, the change and the shift of what is kept, the air again
    queue.clear();
    for (int n = 0; n < 100; ++n) { // cells set in a box that walks
        queue.push(work(CellChange::Kind::set));
        CellChange walk = shift();
        ASSERT_TRUE(wind.set_mean({0.01f * static_cast<float>(n), 0.0f, 0.0f}));
        queue.push(walk);
    }
    EXPECT_EQ(queue.size(), 3u); // the shifts of the sources' flow, the last cells, the last shift
}

// Folded or recorded one by one, the air is the CPU's. It does not sleep, which would begin later on the device.
TEST_F(WindRecordings, ThatAreFoldedMakeTheSameAir) {
    for (const bool ticks : {false, true}) {
        TwoWinds pair = make({.cells = {12, 10, 11},
                              .boundaries = Boundaries::open_over_floor(),
                              .centre = {0.0, 5.0, 0.0},
                              .ambient = {2.0f, 0.0f, 1.0f},
                              .profile = LogProfile{},
                              .relaxation_time = 0.0f});
        const auto frames = [&](int count) {
            for (int n = 0; n < count; ++n)
                ticks ? frame(pair, 1.0 / 47.0) : step(pair, 1.0 / 47.0);
        };
        std::vector<glm::vec4> cells(pair.cpu.box().cell_count());
        for (std::size_t n = 0; n < cells.size(); ++n)
            cells[n] = glm::vec4(std::sin(0.1f * static_cast<float>(n)), 0.3f, std::cos(0.07f * static_cast<float>(n)), 0.0f);
        const auto ramp = [&](float from) {
            for (int n = 0; n < 5; ++n) {
                pair.set_ambient({from + 0.1f * static_cast<float>(n), 0.0f, 1.0f});
                pair.follow({0.9 * n, 5.0, from});
            }
        };
        frames(3); // calm
        ramp(2.0f);
        frames(3);
        ramp(2.5f);
        pair.set_floor(3.0);
        pair.set_floor(0.0);
        ramp(3.0f);
        frames(3);
        pair.add(VortexMotor{.position = {0.0, 5.0, 0.0}, .radius = 3.0f});
        pair.add(OmniMotor{.position = {1.0, 4.0, 1.0}});
        frames(6);
        ramp(2.0f);
        frames(4);
        for (int n = 0; n < 3; ++n) {
            cells[0].x = static_cast<float>(n);
            pair.set_velocity(cells);
            ramp(1.0f);
        }
        frames(4);
        pair.set_velocity(cells);
        pair.reset();
        ramp(2.0f);
        frames(6);
        report(ticks ? "folded.ticks" : "folded.steps", pair, 1e-5);
    }
}

} // namespace
} // namespace windrow::vulkan
