// What moves in a scene moves alike in any wind.
#include "cli/playback.h"
#include "scene/scene_motion.h"
#include "scene/scene_reader.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>

namespace windrow::scene {
namespace {

static_assert(MovableWind<Wind> && MovableWind<cases::BackendWind>);

TEST(SceneMotion, PlaysTheWalkInAPlainWindToTheBitsOfTheCommand) {
    const auto scene = read_scene(std::filesystem::path(WINDROW_SOURCE_DIR) / "examples" / "scenes" / "walk.json");
    ASSERT_TRUE(scene) << scene.error();
    auto playback = cli::Playback::create(*scene, {});
    ASSERT_TRUE(playback) << playback.error();
    auto wind = Wind::create(scene->air);
    ASSERT_TRUE(wind) << wind.error();
    SceneMotion motion(*scene);
    ASSERT_TRUE(motion.begin(*wind));
    wind->reset();
    for (int tick = 0; tick < 20; ++tick) {
        ASSERT_TRUE(motion.place(*wind, tick / scene->tick_hz, (tick + 1) / scene->tick_hz));
        (void)wind->step(1.0 / scene->tick_hz);
        const auto ticked = playback->tick();
        ASSERT_TRUE(ticked) << ticked.error();
    }
    const auto cells = wind->field(), same = playback->wind().field();
    ASSERT_EQ(cells.size(), same.size());
    EXPECT_TRUE(std::equal(cells.begin(), cells.end(), same.begin()));
    EXPECT_EQ(motion.acting(wind->motors(), 20 / scene->tick_hz).size(), playback->acting().size());
    EXPECT_FALSE(playback->acting().empty());
}

TEST(SceneMotion, RejectionsNameTheSceneTheKeyAndTheTime) {
    auto scene = read_scene_text(R"({"follow": [0, 0, 0]})", "a.json");
    ASSERT_TRUE(scene) << scene.error();
    auto wind = Wind::create(scene->air);
    ASSERT_TRUE(wind) << wind.error();
    scene->follow = glm::dvec3(std::numeric_limits<double>::quiet_NaN()); // no reader lets it through
    SceneMotion motion(*scene);
    const auto rejected = motion.place(*wind, 0.0, 0.5);
    ASSERT_FALSE(rejected);
    EXPECT_TRUE(rejected.error().starts_with("a.json: $.follow at 0.5 s: ")) << rejected.error();
}

} // namespace
} // namespace windrow::scene
