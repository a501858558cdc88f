// The stories that `windrow check` and `windrow verify` tell: that they hold what they say, and that a device which is off would
// be found out.
#include "cases/parity_run.h"
#include "cli/playback.h"
#include "fluid/vulkan/passes.h"
#include "fluid/vulkan/wind.h"
#include "scene/scene_reader.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"
#include "tests/tier.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

namespace windrow::cli {

using namespace cases;

namespace {

ParityStory story_named(const std::string& name) {
    for (const ParityStory& story : parity_stories())
        if (story.name == name)
            return story;
    ADD_FAILURE() << "there is no story " << name;
    return {};
}

class Stories : public vulkan::Gpu {
  protected:
    Result<ParityResult> tell(ParityStory story, int steps) {
        story.steps = std::min(story.steps, steps);
        return run_parity(*own, story);
    }

    // Names of the passes of three steps.
    std::set<std::string> passes_of(const ParityStory& story) {
        std::set<std::string> ran;
        auto wind = vulkan::Wind::create(sharing_host(), story.config, {.frames_in_flight = 1, .timestamps = true});
        EXPECT_TRUE(wind) << wind.error();
        for (const StoryMotor& one : story.motors)
            EXPECT_TRUE(wind->motors().add(one.motor));
        for (const StoryObstacle& one : story.obstacles)
            EXPECT_TRUE(wind->obstacles().add(one.obstacle));
        for (int n = 0; n < 3; ++n) {
            EXPECT_TRUE(wind->follow(static_cast<double>(n) * story.dt * story.walk));
            EXPECT_TRUE(wind->set_ambient({1.0f, 0.0f, 0.1f * static_cast<float>(n)}));
            if (story.config.rows && n > 0) { // a change of the story's own that comes later
                EXPECT_TRUE(wind->set_floor(0.7 + 0.8 * n));
            }
            run([&](VkCommandBuffer commands) { held(wind->record_step(commands, {.dt = story.dt})); });
            if (const auto times = wind->pass_times())
                for (const vulkan::PassTimes::Pass& pass : times->passes)
                    ran.insert(pass.name);
        }
        return ran;
    }
};

// The large grids are for devices that are fast: `windrow check --full`, `windrow verify --backend vulkan`.
TEST_F(Stories, SmallOnesAreWithinTheirBounds) {
    int n = 0;
    for (const ParityStory& story : parity_stories()) {
        // A third of them, and the storm: rows of WindScenarios have the other features.
        if (!test::whole_sweeps() && story.name != "storm" && n++ % 3 != 0)
            continue;
        if (Box{.cells = story.config.cells}.cell_count() > 20000 || story.name == k_every_pass_story)
            continue;
        const bool to_its_change = story.name == "frames_and_a_jump" || story.name == "mixed_16x16x16";
        const auto result = tell(story, test::k_sanitized ? 5 : to_its_change ? 100 : test::whole_sweeps() ? 25 : 10);
        ASSERT_TRUE(result) << result.error();
        EXPECT_TRUE(result->pass()) << story.name;
        EXPECT_GT(result->largest, 0.0) << story.name << ": nothing was compared";
        EXPECT_GE(result->steps, test::k_sanitized ? 4 : test::whole_sweeps() ? 23 : 8) << story.name;
        EXPECT_GT(result->largest_component, 0.1) << story.name << ": nothing moved";
        if (story.name == "storm") {
            EXPECT_GT(result->max_substeps, 1);
        }
        WINDROW_EXPECT_FIGURE("stories.first_step." + story.name, result->first, story.first_bound);
        WINDROW_EXPECT_FIGURE("stories." + story.name, result->largest, story.bound);
    }
}

// What `./dev validate` runs under GPU-assisted validation: one wind, since a software device compiles for minutes.
TEST_F(Stories, EachKindOfPassIsWithinItsBounds) {
    const ParityStory story = story_named(k_every_pass_story);
    const auto result = tell(story, story.steps);
    ASSERT_TRUE(result) << result.error();
    EXPECT_TRUE(result->pass());
    EXPECT_EQ(result->max_substeps, 2);
    EXPECT_GT(result->max_limited_cells, 0) << "no speed was cut";
    // Ten of a step, four of viscosity and a solve more for each component, sub-steps, blast, shifts.
    EXPECT_GT(result->dispatches, 40);
    WINDROW_EXPECT_FIGURE("stories.every_pass", result->largest, story.bound);
}

// That it does run each kind, by the device's own account.
TEST_F(Stories, TheStoryOfEachKindOfPassLeavesNoneOut) {
    std::set<std::string> ran = passes_of(story_named(k_every_pass_story));
    ran.merge(passes_of(story_named(k_obstacles_story)));
    ran.merge(passes_of(story_named(k_rows_story)));
    using vulkan::Pass;
    // Where the host asks for them, the report without ticks or textures.
    const std::set<Pass> others = {Pass::read_cells, Pass::read_points, Pass::loads, Pass::report};
    for (std::size_t n = 0; n < vulkan::k_passes; ++n)
        if (const auto pass = static_cast<Pass>(n); !others.contains(pass)) {
            EXPECT_TRUE(ran.contains(name_of(pass))) << name_of(pass);
        }
}

// Whatever the device: a tile is of a fixed size.
TEST_F(Stories, PlanesAreWholeInOneAndSplitInAnother) {
    const char* const split = name_of(vulkan::Pass::modes_between);
    EXPECT_FALSE(passes_of(story_named("whole_long_planes")).contains(split));
    EXPECT_TRUE(passes_of(story_named("split_long_planes")).contains(split));
}

TEST_F(Stories, ADifferenceAboveItsBoundFailsAStory) {
    ParityStory story = parity_stories().front();
    story.bound = story.first_bound = 1e-9; // below rounding, which stands for the fault
    const auto result = tell(story, 3);
    ASSERT_TRUE(result) << result.error();
    EXPECT_FALSE(result->pass());
}

TEST_F(Stories, AFaultNamesTheStory) {
    ParityStory story = parity_stories().front();
    story.config.cell_size = 0.0f;
    const auto result = tell(story, 1);
    ASSERT_FALSE(result);
    EXPECT_TRUE(result.error().starts_with("The story walk_16x16x16: ")) << result.error();
    EXPECT_NE(result.error().find("cell_size"), std::string::npos) << result.error();
}

TEST(ParityResult, PassesOnlyWithinItsBoundsAndInSilence) {
    const ParityResult well{.steps = 2, .first = 1e-7, .last = 1e-6, .largest = 1e-6, .first_bound = 1e-5, .bound = 1e-4};
    EXPECT_TRUE(well.pass());
    const auto but = [&](auto change) {
        ParityResult result = well;
        change(result);
        return result.pass();
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(but([](ParityResult& r) { r.largest = 2e-4; }));
    EXPECT_FALSE(but([](ParityResult& r) { r.first = 2e-5; }));
    EXPECT_FALSE(but([](ParityResult& r) { r.largest = nan; }));
    EXPECT_FALSE(but([](ParityResult& r) { r.messages = 1; }));
    EXPECT_FALSE(but([](ParityResult& r) { r.steps = 0; }));
}

TEST(ParityStories, HaveNamesOfTheirOwnAndConfigsThatAreValid) {
    std::set<std::string> names;
    std::set<int> sizes;
    for (const ParityStory& story : parity_stories()) {
        EXPECT_TRUE(names.insert(story.name).second) << story.name;
        EXPECT_FALSE(story.text.empty()) << story.name;
        const auto valid = validate(story.config);
        EXPECT_TRUE(valid) << story.name << ": " << valid.error();
        sizes.insert(story.config.cells.x);
    }
    for (const int x : {16, 17, 32, 64, 128})
        EXPECT_TRUE(sizes.contains(x)) << x;
}

// A scene with winds around its box plays on a device as on the CPU: of `windrow run --backend vulkan`.
TEST_F(Stories, OfASceneWithLevelsAreThoseOfTheCpu) {
    auto scene = scene::read_scene(WINDROW_SOURCE_DIR "/examples/scenes/nested.json");
    ASSERT_TRUE(scene) << scene.error();
    const Backend backend(own, "device");
    auto device = Playback::create(*scene, {}, backend), cpu = Playback::create(*scene, {});
    ASSERT_TRUE(device && cpu) << device.error();
    EXPECT_EQ(device->levels().size(), 2u);
    for (int n = 0; n < (test::whole_sweeps() ? 60 : 8); ++n) {
        ASSERT_TRUE(cpu->tick());
        ASSERT_TRUE(device->tick());
    }
    ASSERT_EQ(backend.fault(), "");
    double worst = 0.0, fastest = 0.0;
    const auto field = device->wind().field(), wanted = cpu->wind().field();
    for (std::size_t at = 0; at < wanted.size(); ++at) {
        worst = std::max(worst, static_cast<double>(glm::length(glm::vec3(field[at] - wanted[at]))));
        fastest = std::max(fastest, static_cast<double>(glm::length(glm::vec3(wanted[at]))));
    }
    WINDROW_EXPECT_FIGURE("stories.levels", worst / fastest, 1e-5);
    const glm::dvec3 hill{-100.0, 30.0, 10.0}; // of the outermost wind
    EXPECT_EQ(device->wind().velocity(hill), cpu->wind().velocity(hill));
}

} // namespace
} // namespace windrow::cli
