// What a window plays, changes, goes back in and saves.
#include "vegetation/tests/view/session_stage.h"

#include <algorithm>
#include <iterator>

namespace windrow::vegetation::view {
namespace {

TEST_F(SessionTest, PlaysTheBitsOfARun) {
    play_steps(40);
    EXPECT_NEAR(session_->time(), 4.0 / 3.0, 1e-9);
    EXPECT_TRUE(cells() == run("yard.json", 40));
}

TEST_F(SessionTest, MakesWholeStepsOfTheTimeThatPassed) {
    ASSERT_TRUE(session_->play(0.05));
    EXPECT_EQ(session_->steps(), 1);
    ASSERT_TRUE(session_->play(0.05)); // what was left of the first counts
    EXPECT_EQ(session_->steps(), 3);
}

TEST_F(SessionTest, SavesAChangedSceneThatRunsToTheSameBits) {
    play_steps(10);
    ASSERT_TRUE(session_->move_motor(0, {-2.0, 1.5, 2.0}));
    const auto house = session_->add_obstacle({.position = {0.0, 1.5, -3.0}, .shape = Block{{1.0f, 1.5f, 2.0f}}}, "house");
    ASSERT_TRUE(house);
    ASSERT_TRUE(session_->add_motor(VortexMotor{.position = {0.0, 2.0, 4.0}, .radius = 3.0f}, "whirl"));
    ASSERT_TRUE(session_->remove_motor(1));
    ASSERT_TRUE(session_->move_obstacle(0, {3.0, 1.0, 1.0}, glm::angleAxis(0.7f, glm::vec3(0.0f, 1.0f, 0.0f))));
    Config air = session_->air();
    air.ambient = {5.0f, 0.0f, -1.0f};
    ASSERT_TRUE(session_->set_air(air));
    play_steps(10);
    ASSERT_TRUE(session_->save(folder_.path() / "edited.json"));
    ASSERT_TRUE(session_->restart());
    play_steps(40);
    const Cells played = cells();
    EXPECT_TRUE(played == run("edited.json", 40)); // the session as it goes on, and the file
    EXPECT_FALSE(played == run("yard.json", 40));
    open("edited.json"); // and the file in a window
    EXPECT_EQ(session_->motors().size(), 2u);
    EXPECT_EQ(session_->obstacles().size(), 2u);
    play_steps(40);
    EXPECT_TRUE(cells() == played);
}

TEST_F(SessionTest, GoesBackToTheBitsThatWereAndOnAgain) {
    std::vector<Cells> was;
    for (int step = 0; step < 100; ++step) {
        if (step == 20) {
            ASSERT_TRUE(session_->move_motor(0, {-2.0, 2.0, 2.0}));
        }
        if (step == 45) {
            ASSERT_TRUE(session_->add_obstacle({.position = {0.0, 1.0, -3.0}}, "house"));
        }
        if (step == 70) {
            ASSERT_TRUE(session_->remove_motor(0));
        }
        play_steps(1);
        was.push_back(cells());
    }
    for (const int step : {99, 71, 69, 46, 44, 30, 19, 1}) {
        ASSERT_TRUE(session_->seek(session_->scene().air.frame_times().time_of_step(step)));
        EXPECT_EQ(session_->steps(), step);
        EXPECT_TRUE(cells() == was[static_cast<std::size_t>(step - 1)]) << step;
    }
    ASSERT_TRUE(session_->seek(0.0));
    EXPECT_EQ(session_->steps(), 0);
    ASSERT_TRUE(session_->seek(session_->scene().air.frame_times().time_of_step(60)));
    play_steps(5);
    EXPECT_TRUE(cells() == was[64]);
    EXPECT_EQ(session_->latest(), session_->time()); // the future that was is forgotten
}

TEST_F(SessionTest, RejectsWhatValidationRejectsAndStaysAsItWas) {
    play_steps(5);
    const Cells before = cells();
    EXPECT_FALSE(session_->set_motor(0, JetMotor{.length = -1.0f}));
    EXPECT_FALSE(session_->add_obstacle({.shape = Block{{0.0f, 1.0f, 1.0f}}}, "flat"));
    Config air = session_->air();
    air.viscosity = -1.0f;
    EXPECT_FALSE(session_->set_air(air));
    EXPECT_EQ(session_->obstacles().size(), 1u);
    EXPECT_GT(std::get<JetMotor>(session_->motors()[0].motor).length, 0.0f);
    EXPECT_TRUE(cells() == before);
}

TEST_F(SessionTest, KeepsItsSceneWhereTheFileOnDiskIsWrong) {
    play_steps(5);
    write("yard.json", R"({"name": "yard", "air": {"cells": [0, 8, 16]}})");
    const auto read = session_->reload();
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().find("cells"), std::string::npos);
    EXPECT_EQ(session_->steps(), 5);
    play_steps(1);
    write("yard.json", std::string(k_scene).replace(std::string(k_scene).find("[3, 0, 1]"), 9, "[1, 0, 0]"));
    ASSERT_TRUE(session_->reload());
    EXPECT_EQ(session_->steps(), 0);
    EXPECT_EQ(session_->air().ambient, glm::vec3(1.0f, 0.0f, 0.0f));
}

TEST_F(SessionTest, SavesALogThatReplaysTheMinute) {
    play_steps(20);
    ASSERT_TRUE(session_->move_motor(0, {-2.0, 2.0, 2.0}));
    play_steps(20);
    ASSERT_TRUE(session_->save_log(folder_.path()));
    const auto bytes = [&](const char* name) {
        std::ifstream file(folder_.path() / name, std::ios::binary);
        const std::vector<char> read(std::istreambuf_iterator<char>(file), {});
        const auto* begin = reinterpret_cast<const std::byte*>(read.data());
        return std::vector<std::byte>(begin, begin + read.size());
    };
    auto wind = Wind::load(bytes("start.wind"));
    ASSERT_TRUE(wind) << wind.error();
    const auto log = EventLog::from_bytes(bytes("events.log"));
    ASSERT_TRUE(log) << log.error();
    ASSERT_TRUE(replay(*log, *wind));
    EXPECT_TRUE(cells() == Cells(wind->field().begin(), wind->field().end()));
}

TEST_F(SessionTest, DrawsFramesOfAnySizeAndViewWhileItPlays) {
    for (int frame = 0; frame < 24; ++frame) {
        play_steps(1);
        if (frame % 4 == 3) {
            ASSERT_TRUE(session_->player().change({.size = glm::ivec2(64 + 4 * frame, 36 + frame)}));
        }
        if (frame == 9) {
            ASSERT_TRUE(session_->player().change({.show = program::Show::arrows}));
        }
        const auto begun = session_->player().frames().begin();
        ASSERT_TRUE(begun);
        ASSERT_TRUE(session_->record(*begun, program::camera_at(session_->scene(), 0.0), frame == 23));
        ASSERT_TRUE(session_->player().frames().submit(*begun));
    }
    ASSERT_TRUE(session_->player().frames().wait());
    const render::Picture8 picture = session_->player().images().picture();
    EXPECT_EQ(picture.width, 64 + 4 * 23);
    EXPECT_GT(*std::max_element(picture.values.begin(), picture.values.end()), 60);
}

// Hills are drawn as ground: as a body they have no triangle.
TEST_F(SessionTest, DrawsHillsThatAreAnObstacle) {
    write("hill.pgm", "P5 4 4 255\n" + std::string(16, '\x40'));
    std::string scene = k_scene;
    const std::string block = R"("shape": {"block": {"half_size": [1, 1, 1]}})";
    scene.replace(scene.find(block), block.size(), R"("shape": {"ground": {"file": "hill.pgm", "scale": [8, 2, 8]}})");
    write("hills.json", scene);
    open("hills.json");
    play_steps(2);
    const auto begun = session_->player().frames().begin();
    ASSERT_TRUE(begun);
    ASSERT_TRUE(session_->record(*begun, program::camera_at(session_->scene(), 0.0), true));
    ASSERT_TRUE(session_->player().frames().submit(*begun));
    ASSERT_TRUE(session_->player().frames().wait());
}

// A furred body that stays where it was before the slider went back is drawn there.
TEST_F(SessionTest, DrawsFurWhereItIsAfterASeek) {
    std::string scene = k_scene;
    scene.replace(scene.find("\"motors\""), 0, R"("paths": {"go": {"points": [[0, -1.5, 0, 0], [2, 1.5, 0, 0]]}}, )");
    scene.replace(scene.find(R"("camera")"), std::string::npos, R"("camera": {"position": [0, 1.5, 5], "target": [0, 0.7, 0]},
        "bodies": [{"name": "ball", "mesh": {"cube_sphere": {"radius": 0.5, "cells": 6}}, "place": {"position": [0, 0.7, 0]},
                    "motion": {"path": "go"}, "coats": [{"layers": {"shells": 4, "length": 0.1}}]}]}})");
    write("ball.json", scene);
    open("ball.json");
    const auto drawn = [&] {
        const auto begun = session_->player().frames().begin();
        EXPECT_TRUE(begun && session_->record(*begun, program::camera_at(session_->scene(), 0.0), true) &&
                    session_->player().frames().finish(*begun));
        return session_->player().images().picture();
    };
    play_steps(6);
    const render::Picture8 first = drawn();
    play_steps(39);
    const render::Picture8 later = drawn();
    ASSERT_TRUE(session_->seek(6.0 / 30.0));
    EXPECT_EQ(session_->steps(), 6);
    const render::Picture8 again = drawn();
    const auto apart = [&](const render::Picture8& other) {
        double sum = 0.0;
        for (std::size_t n = 0; n < first.values.size(); ++n)
            sum += std::abs(first.values[n] - other.values[n]);
        return sum / static_cast<double>(first.values.size());
    };
    EXPECT_GT(apart(later), 2.0);
    EXPECT_LT(apart(again), 0.3); // tips that have come along lag, tips that are placed rest
}

TEST_F(SessionTest, ChangesItsSizeFiftyTimesWithoutALeak) {
    std::uint64_t first = 0;
    for (int n = 0; n < 50; ++n) {
        ASSERT_TRUE(session_->player().change({.size = n % 2 == 0 ? glm::ivec2(96, 54) : glm::ivec2(64, 36)}));
        if (n == 1)
            first = device_->memory_bytes();
    }
    EXPECT_EQ(device_->memory_bytes(), first);
}

} // namespace
} // namespace windrow::vegetation::view
