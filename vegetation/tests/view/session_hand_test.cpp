// What a hand, the other solver and a recording do to a session.
#include "coupling/ground_memory.h"
#include "vegetation/program/picture_reader.h"
#include "vegetation/tests/view/session_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace windrow::vegetation::view {
namespace {

class SessionHandTest : public SessionTest {
  protected:
    /// A stroke along x of so many frames of four steps.
    void stroke(Session::Hand hand, glm::dvec3 from, int frames) {
        ASSERT_TRUE(session_->begin_stroke(hand, from, 0.8f));
        for (int frame = 1; frame <= frames; ++frame) {
            session_->stroke_to(from + glm::dvec3(0.4 * frame, 0.0, 0.0));
            ASSERT_TRUE(session_->play(4.0 / 30.0));
        }
        ASSERT_TRUE(session_->end_stroke());
    }
};

// A stroke that is saved without its times, at other places, or with the motor of another moment gives other air.
TEST_F(SessionHandTest, StrokesBlowsAndGustsAreInTheSavedSceneAtTheirOwnTime) {
    std::string scene = k_scene; // with somebody who walks there, and is drawn
    scene.replace(scene.find("\"motors\""), 0, R"("paths": {"way": {"points": [[0, -6, 0, -6], [4, 6, 0, -5]]}}, )");
    scene.replace(scene.rfind("}\n}"), 1, R"(, "ground_memory": {}, "walkers": [{"path": "way"}]})");
    write("yard.json", scene);
    ASSERT_TRUE(session_->reload());
    play_steps(6);
    stroke(Session::Hand::press, {-3.0, 0.5, 2.0}, 5);
    const auto begun = session_->player().frames().begin();
    ASSERT_TRUE(begun);
    EXPECT_TRUE(session_->record(*begun, program::camera_at(session_->scene(), 0.0), false));
    ASSERT_TRUE(session_->player().frames().submit(*begun));
    ASSERT_TRUE(session_->blast({1.0, 0.0, 1.0}, 1.5f, 12.0f));
    play_steps(4);
    ASSERT_TRUE(session_->gust({.position = {0.0, 1.0, 0.0},
                                .region = Sphere{2.0f},
                                .law = Drive{.speed = 8.0f, .rate = 6.0f},
                                .envelope = {.attack = 0.1f, .hold = 0.2f, .decay = 0.2f}}));
    play_steps(10);
    const Cells live = cells();
    const auto steps = static_cast<int>(session_->steps());
    EXPECT_EQ(steps, 6 + 20 + 4 + 10);
    ASSERT_TRUE(session_->save(folder_.path() / "edited.json"));
    EXPECT_TRUE(live == run("edited.json", steps));
    EXPECT_FALSE(live == run("yard.json", steps));
    ASSERT_TRUE(session_->restart());
    play_steps(steps);
    EXPECT_TRUE(cells() == live); // the session as it is played again
    EXPECT_EQ(session_->scene().picture.walkers.size(), 2u);
    EXPECT_TRUE(session_->scene().picture.ground_memory.has_value());
}

TEST_F(SessionHandTest, RejectsAStrokeWhileNoTimePasses) {
    ASSERT_TRUE(session_->begin_stroke(Session::Hand::press, {0.0, 0.0, 0.0}, 0.5f));
    session_->stroke_to({1.0, 0.0, 0.0});
    EXPECT_FALSE(session_->end_stroke());
    EXPECT_EQ(session_->motors().size(), 2u);
}

// Whoever goes back, restarts or saves while the button is down: a motor of a path that the file has not cannot be read again.
TEST_F(SessionHandTest, AStrokeThatIsUnderWayLosesNoSave) {
    const auto file = folder_.path() / "saved.json";
    const auto begin = [&] {
        ASSERT_TRUE(session_->reload());
        play_steps(4);
        ASSERT_TRUE(session_->begin_stroke(Session::Hand::press, {-3.0, 0.0, 2.0}, 0.8f));
        for (int step = 1; step <= 6; ++step) {
            session_->stroke_to({-3.0 + 0.2 * step, 0.0, 2.0});
            play_steps(1);
        }
    };
    const auto expect_saved = [&](const char* after, double until) {
        EXPECT_FALSE(session_->strokes()) << after;
        ASSERT_TRUE(session_->save(file)) << after;
        const auto again = program::read_picture_scene(file);
        ASSERT_TRUE(again) << after << ": " << again.error();
        EXPECT_EQ(again->picture.walkers.size(), 1u) << after;
        ASSERT_EQ(again->air.motors.size(), 3u) << after;
        EXPECT_NEAR(again->air.motors[2].until, until, 1e-6) << after;
    };
    begin();
    for (const auto& saved : {session_->save(file), session_->save_log(folder_.path())}) {
        ASSERT_FALSE(saved);
        EXPECT_NE(saved.error().find("release the button"), std::string::npos) << saved.error();
    }
    EXPECT_FALSE(std::filesystem::exists(file) || std::filesystem::exists(folder_.path() / "events.log"));
    ASSERT_TRUE(session_->end_stroke());
    expect_saved("end", 10.0 / 30.0);
    begin();
    ASSERT_TRUE(session_->seek(session_->time() - 0.1));
    expect_saved("seek", 10.0 / 30.0);
    begin();
    ASSERT_TRUE(session_->restart());
    expect_saved("restart", 10.0 / 30.0);
}

struct Combed {
    float along = 0.0f; ///< the part of the lean that is along x, where the way was
    float least = 1e3f; ///< [rad] lean within 0.4 m of the way
};

/// By the ground's memory that the walkers of the session's scene have pressed.
Combed combed_by(const Session& session) {
    auto ground = GroundMemory::create(*session.scene().picture.ground_memory);
    const double tick = 1.0 / 30.0;
    for (int step = 1; step <= session.steps(); ++step) {
        std::vector<GroundWalker> walkers;
        for (const auto& walker : session.scene().picture.walkers)
            walkers.push_back(program::walker_at(session.scene(), walker, tick * (step - 1), tick * step));
        EXPECT_TRUE(ground->advance({.duration = tick, .walkers = walkers}));
    }
    Combed found;
    glm::vec2 sum(0.0f);
    float length = 0.0f;
    for (double z = 1.6; z < 2.45; z += 0.1) {
        const glm::vec2 lean = ground->at({-2.0, 0.0, z}).lean;
        sum += lean;
        length += glm::length(lean);
        found.least = std::min(found.least, glm::length(lean));
    }
    found.along = sum.x / std::max(length, 1e-6f);
    return found;
}

// A comb whose teeth push aside, as a walker does, lays no blade along its way.
TEST_F(SessionHandTest, ACombLaysGrassAlongItsWayAndAPressDoesNot) {
    stroke(Session::Hand::comb, {-3.0, 0.0, 2.0}, 6);
    const Combed combed = combed_by(*session_);
    EXPECT_GT(combed.along, 0.85f);
    EXPECT_GT(combed.least, 0.2f); // as wide as the row of teeth
    ASSERT_TRUE(session_->reload());
    stroke(Session::Hand::press, {-3.0, 0.0, 2.0}, 6);
    EXPECT_LT(combed_by(*session_).along, combed.along - 0.1f);
}

TEST_F(SessionHandTest, PaintsTheMaskThatTheSavedSceneHas) {
    std::string scene = k_scene;
    scene.replace(scene.rfind("}\n}"), 1, R"(, "ground": {"corner": [-20, 0, -20], "extent": [40, 40]},
        "grass": [{"class": "grass", "mask": {"even": 0.5}}, {"class": "reed", "name": "reed"}]})");
    write("meadow.json", scene);
    open("meadow.json"); // a draft draws the first layer alone
    ASSERT_EQ(session_->scene().picture.grass.size(), 1u);
    EXPECT_FALSE(session_->paint(1, {0.0, 0.0, 0.0}, 2.0f, false));
    ASSERT_TRUE(session_->paint(0, {5.0, 0.0, -5.0}, 2.0f, false));
    ASSERT_TRUE(session_->paint(0, {-5.0, 0.0, 5.0}, 2.0f, true));
    ASSERT_TRUE(session_->end_painting());
    const auto& mask = *session_->scene().picture.grass[0].mask.mask;
    EXPECT_GT(mask.alpha({25.0f, 15.0f}), 0.9f);
    EXPECT_LT(mask.alpha({15.0f, 25.0f}), 0.1f);
    ASSERT_TRUE(session_->save(folder_.path() / "painted.json"));
    const auto again = program::read_picture_scene(folder_.path() / "painted.json");
    ASSERT_TRUE(again) << again.error();
    ASSERT_EQ(again->picture.grass.size(), 2u);
    const auto values = again->picture.grass[0].mask.mask->values();
    EXPECT_TRUE(std::equal(values.begin(), values.end(), mask.values().begin(), mask.values().end()));
    EXPECT_EQ(again->picture.grass[1].mask.strokes.size(), 1u); // which was hidden, and erased with the first
}

// Air that begins again in the other solver, or that the comparison changes, differs at once.
TEST_F(SessionHandTest, TheAirGoesToTheDeviceAndBack) {
    play_steps(12);
    const Cells before = cells();
    const auto difference = session_->compare_solvers(3);
    ASSERT_TRUE(difference) << difference.error();
    EXPECT_EQ(difference->ticks, 3);
    EXPECT_GT(difference->fastest, 3.0f);
    EXPECT_LT(difference->largest, 1e-4f * difference->fastest);
    EXPECT_GT(difference->largest, 0.0f);
    EXPECT_TRUE(cells() == before);
    ASSERT_TRUE(session_->set_solver(program::Backend::vulkan));
    EXPECT_EQ(session_->solver(), program::Backend::vulkan);
    EXPECT_FALSE(session_->seek(0.0));
    ASSERT_TRUE(session_->set_solver(program::Backend::cpu));
    EXPECT_EQ(session_->steps(), 12);
    EXPECT_TRUE(cells() == before);
    play_steps(4);
    const Cells after = cells(), alone = run("yard.json", 16);
    float most = 0.0f;
    for (std::size_t n = 0; n < after.size(); ++n)
        most = std::max(most, glm::length(glm::vec3(after[n] - alone[n])));
    EXPECT_LT(most, 1e-3f);
    ASSERT_TRUE(session_->seek(session_->earliest()));
    EXPECT_TRUE(cells() == before);
}

// A player that misses a call, or that goes back to another state, has other air at the end.
TEST_F(SessionHandTest, PlaysTheRecordingOfAHostAndGoesToAnyMoment) {
    std::vector<Cells> was;
    for (int step = 0; step < 70; ++step) {
        if (step == 20) {
            ASSERT_TRUE(session_->move_motor(0, {-2.0, 2.0, 2.0}));
        }
        if (step == 40) {
            ASSERT_TRUE(session_->add_obstacle({.position = {0.0, 1.0, -3.0}}, "house"));
        }
        play_steps(1);
        was.push_back(cells());
    }
    ASSERT_TRUE(session_->save_log(folder_.path()));
    open("."); // the folder, with the scene beside the log
    ASSERT_TRUE(session_->is_recording());
    EXPECT_NEAR(session_->latest(), 70.0 / 30.0, 1e-9);
    ASSERT_TRUE(session_->play(1.0));
    EXPECT_EQ(session_->steps(), 30);
    EXPECT_TRUE(cells() == was[29]);
    ASSERT_TRUE(session_->seek(65.5 / 30.0)); // what has not been played yet is played now
    for (int n = 0; n < 3 && session_->chases(); ++n)
        ASSERT_TRUE(session_->play(0.0));
    EXPECT_FALSE(session_->chases());
    EXPECT_TRUE(cells() == was[static_cast<std::size_t>(session_->steps()) - 1]);
    EXPECT_NEAR(static_cast<double>(session_->steps()), 65.0, 1.0);
    ASSERT_TRUE(session_->seek(11.0 / 30.0));
    EXPECT_TRUE(cells() == was[10]);
    ASSERT_TRUE(session_->play(10.0)); // no further than its end
    ASSERT_TRUE(session_->play(1.0));
    EXPECT_EQ(session_->steps(), 70);
    EXPECT_TRUE(cells() == was[69]);
    const auto changed = session_->add_motor(VortexMotor{}, "whirl");
    ASSERT_FALSE(changed);
    EXPECT_NE(changed.error().find("recording"), std::string::npos);

    std::filesystem::remove(folder_.path() / "scene.json"); // a level meadow then
    open("events.log");
    play_steps(20);
    EXPECT_TRUE(cells() == was[19]);
    write("events.log", "no log");
    const auto broken = Session::open(*device_, folder_.path() / "events.log", {.draft = true, .size = {64, 36}});
    ASSERT_FALSE(broken);
    EXPECT_NE(broken.error().find("events.log"), std::string::npos);
}

} // namespace
} // namespace windrow::vegetation::view
