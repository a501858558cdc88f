// Recordings that are never submitted, slots out of turn, winds without queries, and what waits while nothing is recorded.
#include "fluid/vulkan/work_queue.h"
#include "tests/parity/wind_parity.h"

namespace windrow::vulkan {
namespace {

using WindRecordings = WindParity;

// The host throws a command buffer away: the wind begins anew, as a reset one, with its motors and its sides.
TEST_F(WindRecordings, ThatAreNeverSubmittedAreForgotten) {
    Pair pair = make({.cells = {24, 20, 24}, .ambient = {2.0f, 0.0f, 1.0f}}, 2); // tables of more than 64 KiB
    pair.add(VortexMotor{});
    for (int n = 0; n < 16; ++n) {
        if (n == 5 || n == 9) {
            pair.both([&](auto& wind) { return wind.set_sides(n == 5 ? Sides::open_over_floor() : Sides{}); });
            pair.submitter->discard(
                [&](VkCommandBuffer commands, int slot) { (void)pair.device.record_step(commands, {.dt = 0.03, .slot = slot}); });
            pair.device.forget();
            (void)pair.cpu.step(0.03); // the motors of both have lived through it
            pair.cpu.reset();
            forget_frames(pair);
        }
        step(pair, 1.0 / 30.0);
    }
    EXPECT_GT(pair.compared, 6);
    report("forgotten", pair, 1e-5);
    pair.submitter->wait();
}

// A slot that is not named is the next in turn, and what is older than what was taken is not taken.
TEST_F(WindRecordings, TakeTheirSlotsInAnyOrder) {
    auto wind = Wind::create(own->host(), {.cells = {8, 8, 8}, .ambient = {2.0f, 0.0f, 1.0f}}, {.frames_in_flight = 3});
    ASSERT_TRUE(wind) << wind.error();
    ASSERT_TRUE(wind->motors().add(VortexMotor{}));
    const auto age_after = [&](int slot) {
        run([&](VkCommandBuffer commands) { (void)wind->record(commands, {.dt = 1.0 / 30.0, .slot = slot}); });
        return 30.0 * wind->query_age();
    };
    for (const int slot : {0, 1, 2})
        (void)age_after(slot);
    EXPECT_NEAR(age_after(2), 1.0, 1e-9);  // that of the third is taken
    EXPECT_NEAR(age_after(0), 2.0, 1e-9);  // not that of the first
    EXPECT_NEAR(age_after(-1), 3.0, 1e-9); // slot 1, not that of the second
    EXPECT_NEAR(age_after(-1), 3.0, 1e-9); // slot 2: the fourth
    run([&](VkCommandBuffer commands) { EXPECT_FALSE(wind->record(commands, {.dt = 0.1, .slot = 3}).last.stepped); });
}

TEST_F(WindRecordings, WithoutQueriesTellTheirReportsAlone) {
    const Config config{.cells = {16, 16, 16}, .ambient = {2.0f, 0.0f, 1.0f}};
    auto with = Wind::create(own->host(), config), without = Wind::create(own->host(), config, {.queries = false});
    ASSERT_TRUE(with && without);
    EXPECT_GE(with->memory_bytes(), without->memory_bytes() + 2 * 16 * 4096);
    Diagnostics told;
    for (int n = 0; n < 5; ++n) {
        run([&](VkCommandBuffer commands) { told = without->record_step(commands, {.dt = 1.0 / 30.0}); });
        EXPECT_FALSE(without->queried());
    }
    EXPECT_EQ(told.max_speed, 2.0f);
    EXPECT_EQ(without->velocity({0.0, 0.0, 0.0}), glm::vec3(2.0f, 0.0f, 1.0f)); // the ambient wind
}

// A window that is minimised for an hour: what waits stays small.
TEST_F(WindRecordings, ThatWaitAreFolded) {
    const AmbientWind calm = *AmbientWind::create({.mean = {1.0f, 0.0f, 0.0f}});
    WorkQueue queue;
    const Window window{.cells = {8, 8, 8}, .cell_size = 1.0f, .origin_cells = {}};
    const auto work = [&](Work::Kind kind) { return Work{.kind = kind, .ambient = calm, .window = window}; };
    for (int n = 0; n < 100; ++n) {
        Work shift = work(Work::Kind::shift);
        shift.move.by = {1, 0, -2};
        queue.push(shift);
    }
    EXPECT_EQ(queue.size(), 1u);
    Work back = work(Work::Kind::shift); // loses what left the box
    back.move.by = {-1, 0, 0};
    queue.push(back);
    EXPECT_EQ(queue.size(), 2u);
    for (int n = 0; n < 100; ++n) {
        Work change = work(Work::Kind::add_change);
        change.change = {0.1f, 0.0f, 0.0f};
        queue.push(change);
    }
    EXPECT_EQ(queue.size(), 3u);
    for (int n = 0; n < 100; ++n) // a ramp: the old wind goes, the new one comes
        for (const int step : {0, 1}) {
            Work wind = work(Work::Kind::add_wind);
            wind.factor = step == 0 ? -1.0f : 1.0f;
            ASSERT_TRUE(wind.ambient.set_mean({0.1f * static_cast<float>(n + step), 0.0f, 0.0f}));
            queue.push(wind);
        }
    EXPECT_EQ(queue.size(), 5u); // the first goes, the last comes
    for (int n = 0; n < 100; ++n)
        queue.push(work(Work::Kind::set));
    EXPECT_EQ(queue.size(), 3u); // the shifts move what stays, the flow of sources
    queue.push(work(Work::Kind::fill));
    EXPECT_EQ(queue.size(), 1u);
}

} // namespace
} // namespace windrow::vulkan
