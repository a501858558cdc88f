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
