// A session at a small yard with a fan, a hut and a meadow, on a device of its own.
#pragma once

#include "fluid/wind.h"
#include "scene/scene_levels.h"
#include "scene/scene_reader.h"
#include "tests/own_folder.h"
#include "vegetation/view/session.h"

#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace windrow::vegetation::view {

inline constexpr const char* k_scene = R"({
    "name": "yard", "duration": 4, "tick_hz": 30, "frames_per_second": 10,
    "air": {"cells": [16, 8, 16], "cell_size": 1, "boundaries": {"y_low": "free_slip"}, "ambient": [3, 0, 1],
            "gusts": {"intensity": 0.2, "length": 6}},
    "motors": [
        {"name": "fan", "kind": "jet", "position": [-3, 1.5, 0], "direction": [1, 0, 0], "length": 5},
        {"name": "late", "kind": "omni", "from": 0.5, "position": [2, 2, 2], "radius": 2, "speed": 4}],
    "obstacles": [{"name": "hut", "position": [3, 1, 3], "shape": {"block": {"half_size": [1, 1, 1]}}}],
    "picture": {"size": [64, 36], "warm_up": 0, "camera": {"position": [10, 4, 10], "target": [0, 1, 0]}}
})";

using Cells = std::vector<glm::vec4>;

class SessionTest : public testing::Test {
  protected:
    void SetUp() override {
        auto device = engine::Device::create();
        ASSERT_TRUE(device) << device.error();
        device_ = *std::move(device);
        write("yard.json", k_scene);
        open("yard.json");
    }
    void write(const char* name, const std::string& text) { std::ofstream(folder_.path() / name) << text; }
    void open(const char* name) {
        auto opened =
            Session::open(*device_, folder_.path() / name, {.draft = true, .backend = program::Backend::cpu, .size = {64, 36}});
        ASSERT_TRUE(opened) << opened.error();
        session_ = *std::move(opened);
    }
    void play_steps(int steps) {
        for (int n = 0; n < steps; ++n)
            ASSERT_TRUE(session_->step());
    }
    [[nodiscard]] Cells cells() const {
        const auto field = session_->reader().cells();
        return {field->begin(), field->end()};
    }
    /// As `windrow run` plays a file.
    [[nodiscard]] Cells run(const char* name, int steps) const {
        const auto scene = scene::read_scene(folder_.path() / name);
        EXPECT_TRUE(scene) << scene.error();
        if (!scene)
            return {};
        auto levels = scene::SceneLevels::create(*scene, {});
        EXPECT_TRUE(levels) << levels.error();
        auto wind = Wind::create(levels->inner_config(), levels->nearest());
        auto air = scene::SceneAir::within(*scene);
        EXPECT_TRUE(air.begin(*wind));
        for (int step = 1; step <= steps; ++step) {
            EXPECT_TRUE(levels->advance_to(scene->frame_times().time_of_step(step)));
            EXPECT_TRUE(air.advance_to(*wind, scene->frame_times().time_of_step(step)));
            (void)wind->step(scene->frame_times().length_of_step(step));
        }
        return {wind->field().begin(), wind->field().end()};
    }

    test::OwnFolder folder_{};
    std::unique_ptr<engine::Device> device_{};
    std::unique_ptr<Session> session_{};
};

} // namespace windrow::vegetation::view
