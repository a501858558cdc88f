// A scene in C: the air is that of scene/scene_air.h, and what a scene lacks has its class of error.
#include "fluid/wind.h"
#include "scene/scene_air.h"
#include "scene/scene_reader.h"

#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <string_view>
#include <windrow/windrow.h>

namespace {

constexpr std::string_view k_text = R"({
    "duration": 1, "tick_hz": 60, "frames_per_second": 7,
    "air": {"cells": [12, 8, 12], "ambient": [2, 0, 0], "boundaries": {"y_low": "free_slip"}, "gusts": {"intensity": 0.2}},
    "paths": {"way": {"points": [[0, -4, 1, 0], [1, 4, 1, 0]]}},
    "follow": "way",
    "motors": [{"name": "fan", "kind": "directional", "from": 0.5}, {"name": "runner", "kind": "wake", "path": "way"}],
    "obstacles": [{"name": "house", "position": [1, 1, 2], "shape": {"block": {}}},
                  {"name": "car", "path": "way", "until": 0.5, "shape": {"sphere": {}}}]
})";

struct EndScene {
    void operator()(windrow_scene* scene) const { windrow_scene_destroy(scene); }
};
using PlayedScene = std::unique_ptr<windrow_scene, EndScene>;

PlayedScene parsed(std::string_view text) {
    windrow_scene* scene = nullptr;
    EXPECT_EQ(windrow_scene_parse(text.data(), text.size(), "played.json", nullptr, &scene), WINDROW_OK) << windrow_last_error();
    return PlayedScene(scene);
}

TEST(SceneInC, GivesTheBitsOfCpp) {
    const PlayedScene c = parsed(k_text);
    const auto scene = windrow::scene::read_scene_text(k_text, "played.json");
    ASSERT_TRUE(scene) << scene.error();
    auto wind = windrow::Wind::create(scene->air);
    ASSERT_TRUE(wind);
    windrow::scene::SceneAir air(*scene);
    ASSERT_TRUE(air.begin(*wind));
    const auto times = scene->frame_times();
    while (air.time() < scene->duration) {
        const auto next = air.steps() + 1;
        ASSERT_TRUE(air.advance_to(*wind, times.time_of_step(next)));
        (void)wind->step(times.length_of_step(next));
        ASSERT_EQ(windrow_scene_step(c.get(), nullptr), WINDROW_OK) << windrow_last_error();
        ASSERT_EQ(windrow_scene_time(c.get()), air.time());
    }
    const windrow_vec4* cells = nullptr;
    std::uint64_t count = 0;
    ASSERT_EQ(windrow_wind_field(windrow_scene_wind(c.get()), WINDROW_FRAME_NOW, &cells, &count, nullptr), WINDROW_OK);
    const auto field = wind->view().field();
    ASSERT_EQ(count, field.size());
    EXPECT_EQ(std::memcmp(cells, field.data(), field.size_bytes()), 0);
}

TEST(SceneInC, NamesMotorsAndObstacles) {
    const PlayedScene scene = parsed(k_text);
    EXPECT_EQ(windrow_scene_motor_count(scene.get()), 2);
    EXPECT_STREQ(windrow_scene_motor_name(scene.get(), 1), "runner");
    EXPECT_EQ(windrow_scene_motor_name(scene.get(), 2), nullptr);
    EXPECT_STREQ(windrow_scene_obstacle_name(scene.get(), 0), "house");
    EXPECT_EQ(windrow_scene_obstacle_name(scene.get(), -1), nullptr);
    windrow_motor_id fan{};
    windrow_obstacle_id car{};
    EXPECT_EQ(windrow_scene_motor(scene.get(), "fan", &fan), WINDROW_STALE);
    EXPECT_STREQ(windrow_last_error(), "the motor 'fan' is not in the air now.");
    EXPECT_EQ(windrow_scene_motor(scene.get(), "fun", &fan), WINDROW_REJECTED);
    EXPECT_EQ(windrow_scene_obstacle(scene.get(), "car", &car), WINDROW_OK);
    while (windrow_scene_time(scene.get()) < 0.6)
        ASSERT_EQ(windrow_scene_step(scene.get(), nullptr), WINDROW_OK);
    EXPECT_EQ(windrow_scene_obstacle(scene.get(), "car", &car), WINDROW_STALE);
    ASSERT_EQ(windrow_scene_motor(scene.get(), "fan", &fan), WINDROW_OK);
    windrow_motor_kind kind = -1;
    EXPECT_EQ(windrow_wind_motor_kind(windrow_scene_wind(scene.get()), fan, &kind), WINDROW_OK);
    EXPECT_EQ(kind, WINDROW_MOTOR_DIRECTIONAL);
}

TEST(SceneInC, GoesOnWhereItWasSaved) {
    const PlayedScene scene = parsed(k_text), other = parsed(k_text);
    while (windrow_scene_time(scene.get()) < 0.6)
        ASSERT_EQ(windrow_scene_step(scene.get(), nullptr), WINDROW_OK);
    const auto saved = [](const windrow_scene* from) {
        windrow_bytes* bytes = nullptr;
        EXPECT_EQ(windrow_scene_save(from, &bytes), WINDROW_OK);
        std::string copy(reinterpret_cast<const char*>(windrow_bytes_data(bytes)), windrow_bytes_size(bytes));
        windrow_bytes_destroy(bytes);
        return copy;
    };
    const std::string file = saved(scene.get());
    ASSERT_EQ(windrow_scene_restore(other.get(), file.data(), file.size()), WINDROW_OK) << windrow_last_error();
    for (int step = 0; step < 10; ++step)
        for (windrow_scene* const played : {scene.get(), other.get()})
            ASSERT_EQ(windrow_scene_step(played, nullptr), WINDROW_OK);
    EXPECT_EQ(saved(scene.get()), saved(other.get()));
    windrow_motor_id fan{};
    EXPECT_EQ(windrow_scene_motor(other.get(), "fan", &fan), WINDROW_OK);

    const PlayedScene empty = parsed("{}");
    const std::string before = saved(empty.get());
    EXPECT_EQ(windrow_scene_restore(empty.get(), file.data(), file.size()), WINDROW_REJECTED);
    EXPECT_EQ(saved(empty.get()), before); // a scene of another file is as it was
    EXPECT_EQ(windrow_scene_restore(empty.get(), file.data(), file.size() - 1), WINDROW_REJECTED);
}

// A handle that names the level of before the scene went back has other air.
TEST(SceneInC, GivesTheWindsAroundItsOwn) {
    std::string text(k_text);
    const std::string_view air = R"("air": {)";
    text.insert(text.find(air) + air.size(), R"("outer": {"cells": [12, 5, 12], "cell_size": 3, "outer": {"cell_size": 6}}, )");
    const PlayedScene scene = parsed(text);
    ASSERT_EQ(windrow_scene_outer_count(scene.get()), 2);
    windrow_wind* const nearest = windrow_scene_outer_wind(scene.get(), 0);
    EXPECT_EQ(windrow_scene_outer_wind(scene.get(), 2), nullptr);
    EXPECT_EQ(windrow_scene_outer_wind(scene.get(), -1), nullptr);
    EXPECT_EQ(windrow_scene_outer_count(parsed(k_text).get()), 0);
    const auto size_of_cells = [](const windrow_wind* wind) {
        windrow_box box;
        EXPECT_EQ(windrow_box_init(&box, sizeof box), WINDROW_OK);
        EXPECT_EQ(windrow_wind_box(wind, &box), WINDROW_OK);
        return box.cell_size;
    };
    EXPECT_EQ(size_of_cells(nearest), 3.0f);
    EXPECT_EQ(size_of_cells(windrow_scene_outer_wind(scene.get(), 1)), 6.0f);

    const auto bytes_of = [](const windrow_wind* wind) {
        windrow_bytes* bytes = nullptr;
        EXPECT_EQ(windrow_wind_save(wind, &bytes), WINDROW_OK);
        std::string copy(reinterpret_cast<const char*>(windrow_bytes_data(bytes)), windrow_bytes_size(bytes));
        windrow_bytes_destroy(bytes);
        return copy;
    };
    for (int step = 0; step < 12; ++step)
        ASSERT_EQ(windrow_scene_step(scene.get(), nullptr), WINDROW_OK);
    // All of them as winds of the host's own.
    windrow_wind *far = nullptr, *near = nullptr, *own = nullptr;
    const std::string far_bytes = bytes_of(windrow_scene_outer_wind(scene.get(), 1)), near_bytes = bytes_of(nearest),
                      own_bytes = bytes_of(windrow_scene_wind(scene.get()));
    EXPECT_EQ(windrow_wind_load(far_bytes.data(), far_bytes.size(), nullptr, &far), WINDROW_OK) << windrow_last_error();
    EXPECT_EQ(windrow_wind_load_inside(near_bytes.data(), near_bytes.size(), nullptr, far, &near), WINDROW_OK);
    EXPECT_EQ(windrow_wind_load_inside(own_bytes.data(), own_bytes.size(), nullptr, near, &own), WINDROW_OK);
    EXPECT_EQ(bytes_of(own), own_bytes);

    windrow_bytes* saved = nullptr;
    ASSERT_EQ(windrow_scene_save(scene.get(), &saved), WINDROW_OK);
    for (int step = 0; step < 12; ++step)
        ASSERT_EQ(windrow_scene_step(scene.get(), nullptr), WINDROW_OK);
    EXPECT_NE(bytes_of(nearest), near_bytes);
    const auto restore = [&] { return windrow_scene_restore(scene.get(), windrow_bytes_data(saved), windrow_bytes_size(saved)); };
    windrow_wind* inside = nullptr;
    windrow_config config;
    ASSERT_EQ(windrow_config_init(&config, sizeof config), WINDROW_OK);
    config.cells = {4, 4, 4};
    config.centre = {-3.0, 2.0, 0.0};
    ASSERT_EQ(windrow_wind_create_inside(&config, nearest, &inside), WINDROW_OK) << windrow_last_error();
    EXPECT_EQ(restore(), WINDROW_REJECTED);
    windrow_wind_destroy(inside);
    ASSERT_EQ(restore(), WINDROW_OK) << windrow_last_error();
    EXPECT_EQ(windrow_scene_outer_wind(scene.get(), 0), nearest);
    EXPECT_EQ(bytes_of(nearest), near_bytes);
    EXPECT_EQ(restore(), WINDROW_OK) << windrow_last_error();                // no use of it is counted twice
    EXPECT_EQ(windrow_scene_advance(scene.get(), 1e8, nullptr), WINDROW_OK); // at once: the levels drop what the box drops
    windrow_bytes_destroy(saved);
    for (windrow_wind* const wind : {own, near, far})
        windrow_wind_destroy(wind);
}

TEST(SceneInC, AWindIsWrittenAsASceneThatPlaysItToTheBit) {
    windrow_config config;
    ASSERT_EQ(windrow_config_init(&config, sizeof config), WINDROW_OK);
    windrow_gusts gusts;
    ASSERT_EQ(windrow_gusts_init(&gusts, sizeof gusts), WINDROW_OK);
    gusts.intensity = 0.2f;
    windrow_log_profile profile;
    ASSERT_EQ(windrow_log_profile_init(&profile, sizeof profile), WINDROW_OK);
    config.cells = {14, 8, 12};
    config.cell_size = 0.75f;
    config.ambient = {2.0f, 0.0f, 0.1f};
    config.boundaries = windrow_boundaries_open_over_floor();
    config.gusts = &gusts;
    config.profile = &profile;
    config.centre = {3.0, 0.0, -1.5};
    windrow_wind* wind = nullptr;
    ASSERT_EQ(windrow_wind_create(&config, &wind), WINDROW_OK) << windrow_last_error();
    const std::unique_ptr<windrow_wind, void (*)(windrow_wind*)> held(wind, windrow_wind_destroy);
    windrow_obstacle obstacle;
    ASSERT_EQ(windrow_obstacle_init(&obstacle, sizeof obstacle), WINDROW_OK);
    obstacle.position = {4.0, 1.0, -1.0};
    obstacle.shape = windrow_shape_cylinder(0.9f, 1.1f);
    windrow_obstacle_id body{};
    ASSERT_EQ(windrow_wind_add_obstacle(wind, &obstacle, &body), WINDROW_OK);
    windrow_directional_motor fan;
    ASSERT_EQ(windrow_directional_motor_init(&fan, sizeof fan), WINDROW_OK);
    fan.position = {1.0, 1.0, -1.0};
    windrow_motor_id id{};
    ASSERT_EQ(windrow_wind_add_directional(wind, &fan, &id), WINDROW_OK);

    const std::string file = testing::TempDir() + "windrow_written_scene.json";
    ASSERT_EQ(windrow_wind_write_scene(wind, file.c_str(), 2.0, 60.0), WINDROW_OK) << windrow_last_error();
    windrow_scene* read = nullptr;
    ASSERT_EQ(windrow_scene_load(file.c_str(), nullptr, &read), WINDROW_OK) << windrow_last_error();
    const PlayedScene scene(read);
    EXPECT_EQ(windrow_scene_duration(read), 2.0);
    for (int step = 0; step < 30; ++step) {
        ASSERT_EQ(windrow_wind_step(wind, 1.0 / 60.0, nullptr), WINDROW_OK);
        ASSERT_EQ(windrow_scene_step(read, nullptr), WINDROW_OK);
    }
    const windrow_vec4 *host = nullptr, *played = nullptr;
    std::uint64_t count = 0;
    ASSERT_EQ(windrow_wind_field(wind, WINDROW_FRAME_NOW, &host, &count, nullptr), WINDROW_OK);
    ASSERT_EQ(windrow_wind_field(windrow_scene_wind(read), WINDROW_FRAME_NOW, &played, &count, nullptr), WINDROW_OK);
    EXPECT_EQ(std::memcmp(host, played, count * sizeof(windrow_vec4)), 0);

    EXPECT_EQ(windrow_wind_write_scene(wind, file.c_str(), 0.0, 60.0), WINDROW_REJECTED);
    EXPECT_NE(std::string_view(windrow_last_error()).find("$.duration is 0"), std::string_view::npos) << windrow_last_error();
    EXPECT_EQ(windrow_wind_write_scene(wind, "no/such/folder.json", 1.0, 60.0), WINDROW_REJECTED);
    windrow_wake_motor wake;
    ASSERT_EQ(windrow_wake_motor_init(&wake, sizeof wake), WINDROW_OK);
    ASSERT_EQ(windrow_wind_add_wake(wind, &wake, &id), WINDROW_OK);
    EXPECT_EQ(windrow_wind_write_scene(wind, file.c_str(), 1.0, 60.0), WINDROW_REJECTED);
    EXPECT_NE(std::string_view(windrow_last_error()).find("a wake has a path"), std::string_view::npos);
}

TEST(SceneInC, RejectsWhatTheReaderDoes) {
    windrow_scene* scene = nullptr;
    EXPECT_EQ(windrow_scene_load("no/such.json", nullptr, &scene), WINDROW_REJECTED);
    EXPECT_NE(std::string_view(windrow_last_error()).find("no/such.json"), std::string_view::npos) << windrow_last_error();
    constexpr std::string_view k_wrong = R"({"air": {"cells": [0, 1, 1], "ambience": 1}})";
    EXPECT_EQ(windrow_scene_parse(k_wrong.data(), k_wrong.size(), "a.json", nullptr, &scene), WINDROW_REJECTED);
    EXPECT_EQ(scene, nullptr);
    EXPECT_NE(std::string_view(windrow_last_error()).find("$.air.ambience is not a known key"), std::string_view::npos);
    EXPECT_EQ(windrow_scene_advance(parsed("{}").get(), -1.0, nullptr), WINDROW_REJECTED);
    EXPECT_EQ(windrow_scene_wind(nullptr), nullptr);
}

} // namespace
