// A session in a box that is inside another wind.
#include "vegetation/tests/view/session_stage.h"

#include <algorithm>
#include <filesystem>

namespace windrow::vegetation::view {
namespace {

class SessionLevelsTest : public SessionTest {
  protected:
    void SetUp() override {
        SessionTest::SetUp();
        std::string scene = k_scene;
        const std::string air = R"("air": {)";
        scene.insert(scene.find(air) + air.size(), R"("outer": {"cells": [14, 6, 14], "cell_size": 3, "ticks": {"hz": 10}}, )");
        write("nested.json", scene);
        open("nested.json");
    }
    [[nodiscard]] Cells around() const { return {session_->level(0).field().begin(), session_->level(0).field().end()}; }
    void see(int step) { ASSERT_TRUE(session_->seek(session_->scene().air.frame_times().time_of_step(step))); }
    [[nodiscard]] Result<std::size_t> add_barn() {
        return session_->add_obstacle({.position = {-7.0, 2.0, 4.0}, .shape = Block{{2.0f, 2.0f, 3.0f}}}, "barn");
    }
};

// Without the level: other air. With a change in the box alone: the level has no barn, or the burst of its place.
TEST_F(SessionLevelsTest, PlaysChangesGoesBackAndSavesWithTheWindAroundIt) {
    ASSERT_EQ(session_->levels(), 1u);
    std::vector<Cells> was, was_around;
    for (int step = 1; step <= 75; ++step) {
        if (step == 20) {
            ASSERT_TRUE(add_barn());
        }
        if (step == 24) {
            ASSERT_TRUE(session_->move_motor(1, {-2.0, 2.0, -2.0}));
        }
        if (step == 40) {
            Config air = session_->air();
            air.ambient = {5.0f, 0.0f, -1.0f};
            ASSERT_TRUE(session_->set_air(air));
        }
        if (step == 50) {
            ASSERT_TRUE(session_->set_motor(1, OmniMotor{.position = {-2.0, 2.0, -2.0}, .radius = 1.0f}));
        }
        play_steps(1);
        was.push_back(cells());
        was_around.push_back(around());
    }
    EXPECT_EQ(session_->level(0).config().ambient, glm::vec3(5.0f, 0.0f, -1.0f));
    EXPECT_EQ(session_->level(0).motors().count(), 0); // no wider than a cell from 50 on
    EXPECT_EQ(session_->level(0).obstacles().count(), 1);
    for (const int step : {75, 52, 45, 33, 21, 19, 3}) {
        see(step);
        EXPECT_TRUE(cells() == was[static_cast<std::size_t>(step - 1)]) << step;
        EXPECT_TRUE(around() == was_around[static_cast<std::size_t>(step - 1)]) << step;
    }
    see(36); // in the middle of a second: what is changed from there on is another future
    ASSERT_TRUE(session_->move_obstacle(1, {-7.0, 2.0, -4.0}, glm::quat(1.0f, 0.0f, 0.0f, 0.0f)));
    play_steps(3);
    const Cells other = cells();
    EXPECT_FALSE(other == was[38]);
    play_steps(2);
    see(39);
    EXPECT_TRUE(cells() == other);
    EXPECT_EQ(session_->latest(), session_->scene().air.frame_times().time_of_step(41));

    ASSERT_TRUE(session_->save(folder_.path() / "edited.json"));
    ASSERT_TRUE(session_->restart());
    play_steps(30);
    EXPECT_TRUE(cells() == run("edited.json", 30));
    EXPECT_FALSE(cells() == run("nested.json", 30));
}

TEST_F(SessionLevelsTest, RejectsABoxThatTheWindAroundItDoesNotHold) {
    play_steps(2);
    const Cells before = cells();
    Config air = session_->air();
    air.cells.x = 64;
    ASSERT_TRUE(session_->set_air(air)); // a setting that waits
    const auto restarted = session_->restart();
    ASSERT_FALSE(restarted);
    EXPECT_NE(restarted.error().find("outer wind"), std::string::npos) << restarted.error();
    EXPECT_TRUE(cells() == before);
    play_steps(1);
    EXPECT_EQ(session_->steps(), 3);
}

TEST_F(SessionLevelsTest, GoesToADeviceAndBackInTheWindAroundIt) {
    play_steps(20);
    const auto found = session_->compare_solvers(4);
    ASSERT_TRUE(found) << found.error();
    EXPECT_LE(found->largest, 1e-4f * found->fastest);
    EXPECT_GT(found->fastest, 1.0f);
    const Cells before = cells();
    ASSERT_TRUE(session_->set_solver(program::Backend::vulkan));
    ASSERT_EQ(session_->levels(), 1u);
    for (int frame = 0; frame < 6; ++frame) {
        if (frame == 2) {
            ASSERT_TRUE(add_barn());
        }
        ASSERT_TRUE(session_->play(2.0 / 30.0));
        const auto begun = session_->player().frames().begin();
        ASSERT_TRUE(begun);
        ASSERT_TRUE(session_->record(*begun, program::camera_at(session_->scene(), 0.0), false));
        ASSERT_TRUE(session_->player().frames().submit(*begun));
    }
    EXPECT_EQ(session_->level(0).obstacles().count(), 1);
    ASSERT_TRUE(session_->set_solver(program::Backend::cpu));
    EXPECT_EQ(session_->steps(), 32);
    EXPECT_FALSE(cells() == before);
    play_steps(3);
    see(33);
    EXPECT_EQ(session_->steps(), 33);
}

// A recording without the wind around it, or with that a frame late, gives other air.
TEST_F(SessionLevelsTest, SavesALogThatPlaysWithTheWindAroundIt) {
    std::vector<Cells> was;
    for (int step = 1; step <= 40; ++step) {
        if (step == 10) {
            ASSERT_TRUE(add_barn());
        }
        play_steps(1);
        was.push_back(cells());
    }
    write("outer_2.wind", "of an earlier log");
    ASSERT_TRUE(session_->save_log(folder_.path()));
    open("events.log");
    ASSERT_TRUE(session_->is_recording());
    ASSERT_EQ(session_->levels(), 1u);
    play_steps(12);
    EXPECT_TRUE(cells() == was[11]);
    play_steps(28);
    EXPECT_TRUE(cells() == was[39]);
    see(11);
    EXPECT_TRUE(cells() == was[10]);
    ASSERT_TRUE(session_->restart());
    play_steps(11);
    EXPECT_TRUE(cells() == was[10]);
    std::filesystem::remove(folder_.path() / "outer_1.wind");
    const auto alone = Session::open(*device_, folder_.path() / "events.log", {.draft = true, .size = {64, 36}});
    ASSERT_FALSE(alone);
    EXPECT_NE(alone.error().find("start.wind"), std::string::npos) << alone.error();
}

} // namespace
} // namespace windrow::vegetation::view
