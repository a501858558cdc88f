// Each allocation of each call of the C interface fails in turn: the call returns WINDROW_OUT_OF_MEMORY, no exception leaves it, and
// nothing is lost. The functions of C are extern "C" and this test has no handler: an exception would end the program.
#include "tests/unit/counted_new.h"

#include <cstdint>
#include <cstdio>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <windrow/windrow.h>

namespace {

using windrow::test::Failing;
using windrow::test::FailingMemory;

template <class Struct, class Init>
Struct counted_initial(const Init& init) {
    Struct value;
    EXPECT_EQ(init(&value, sizeof value), WINDROW_OK);
    return value;
}

/// Calls until no allocation fails any more; `undo` takes back what a call made that worked.
void fail_each(
    const char* name, const std::function<windrow_result()>& call, const std::function<void()>& undo = [] {}) {
    int failed = 0;
    for (int after = 0;; ++after) {
        windrow_result result = WINDROW_OK;
        bool any = false;
        {
            const FailingMemory none(after, Failing::from_then_on);
            result = call();
            any = none.failed();
        }
        if (result == WINDROW_OK)
            undo();
        if (!any) {
            ASSERT_EQ(result, WINDROW_OK) << name << ": " << windrow_last_error();
            break;
        }
        ++failed;
        ASSERT_TRUE(result == WINDROW_OK || result == WINDROW_OUT_OF_MEMORY)
            << name << " without its allocation " << after << ": " << result;
        if (result == WINDROW_OUT_OF_MEMORY) {
            ASSERT_TRUE(std::string(windrow_last_error()).starts_with("out of memory")) << name << ": " << windrow_last_error();
        }
        ASSERT_LT(after, 5000) << name;
    }
    std::printf("%s: %d allocations failed in turn\n", name, failed);
}

TEST(CApiAllocation, EachFailsInTurn) {
    const std::int64_t before = windrow::test::live_bytes;
    auto config = counted_initial<windrow_config>(windrow_config_init);
    auto profile = counted_initial<windrow_log_profile>(windrow_log_profile_init);
    config.cells = {12, 8, 12};
    config.ambient = {2.0f, 0.0f, 0.0f};
    config.profile = &profile;
    windrow_wind* wind = nullptr;
    fail_each(
        "windrow_wind_create", [&] { return windrow_wind_create(&config, &wind); }, [&] { windrow_wind_destroy(wind); });
    ASSERT_EQ(windrow_wind_create(&config, &wind), WINDROW_OK);

    const auto wake = counted_initial<windrow_wake_motor>(windrow_wake_motor_init);
    windrow_motor_id id;
    fail_each(
        "windrow_wind_add_wake", [&] { return windrow_wind_add_wake(wind, &wake, &id); },
        [&] { (void)windrow_wind_remove_motor(wind, id); });
    const auto block = counted_initial<windrow_obstacle>(windrow_obstacle_init);
    windrow_obstacle_id house;
    fail_each(
        "windrow_wind_add_obstacle", [&] { return windrow_wind_add_obstacle(wind, &block, &house); },
        [&] { (void)windrow_wind_remove_obstacle(wind, house); });
    fail_each("windrow_wind_step", [&] { return windrow_wind_step(wind, 0.02, nullptr); });
    fail_each("windrow_wind_advance", [&] { return windrow_wind_advance(wind, 0.04, nullptr, nullptr); });
    const float heights[4] = {0.0f, 1.0f, 2.0f, 1.0f};
    windrow_height_map* map = nullptr;
    fail_each(
        "windrow_height_map_create_with_holes",
        [&] {
            const std::uint8_t open[4] = {0, 1, 0, 0};
            return windrow_height_map_create_with_holes({2, 2}, 1.0f, heights, 4, {2, 2}, open, 4, &map);
        },
        [&] { windrow_height_map_destroy(map); });
    windrow_bytes* bytes = nullptr;
    fail_each(
        "windrow_wind_save", [&] { return windrow_wind_save(wind, &bytes); }, [&] { windrow_bytes_destroy(bytes); });
    ASSERT_EQ(windrow_wind_save(wind, &bytes), WINDROW_OK);
    windrow_wind* loaded = nullptr;
    fail_each(
        "windrow_wind_load",
        [&] { return windrow_wind_load(windrow_bytes_data(bytes), windrow_bytes_size(bytes), nullptr, &loaded); },
        [&] { windrow_wind_destroy(loaded); });
    windrow_bytes_destroy(bytes);
    windrow_event_log* log = nullptr;
    fail_each(
        "windrow_event_log_create", [&] { return windrow_event_log_create(&log); }, [&] { windrow_event_log_destroy(log); });
    auto got = counted_initial<windrow_config>(windrow_config_init);
    fail_each("windrow_wind_config", [&] { return windrow_wind_config(wind, &got); });
    windrow_ambient_wind* around = nullptr;
    fail_each(
        "windrow_ambient_wind_of", [&] { return windrow_ambient_wind_of(wind, 0, &around); },
        [&] { windrow_ambient_wind_destroy(around); });
    const auto blades_settings = counted_initial<windrow_blade_settings>(windrow_blade_settings_init);
    windrow_blades* blades = nullptr;
    fail_each(
        "windrow_blades_create", [&] { return windrow_blades_create(&blades_settings, &blades); },
        [&] { windrow_blades_destroy(blades); });
    auto ground_config = counted_initial<windrow_ground_config>(windrow_ground_config_init);
    ground_config.texels = 16;
    ground_config.blend_width = 0.5f;
    windrow_ground* ground = nullptr;
    fail_each(
        "windrow_ground_create", [&] { return windrow_ground_create(&ground_config, nullptr, &ground); },
        [&] { windrow_ground_destroy(ground); });
    windrow_wind_destroy(wind);
    // All is given back, except the last sentence, which is kept for windrow_last_error.
    EXPECT_LE(windrow::test::live_bytes - before, 512);
}

// A sentence that does not fit into memory is still a sentence.
TEST(CApiAllocation, OfASentence) {
    auto config = counted_initial<windrow_config>(windrow_config_init);
    config.cell_size = -1.0f;
    windrow_wind* wind = nullptr;
    const FailingMemory none(0, Failing::from_then_on);
    EXPECT_LT(windrow_wind_create(&config, &wind), 0);
    EXPECT_STREQ(windrow_last_error(), "out of memory");
}

} // namespace
