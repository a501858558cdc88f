// Stories that random_stories_test.cpp once found, shrunk: each was a fault, and is told again.

#include "tests/stability/story.h"

#include <gtest/gtest.h>
#include <limits>

namespace {

using namespace windrow;
using namespace windrow::test;

// The step in which the air fell asleep reported the air of before: what had been left of the wind, not what it became.
TEST(ToldStories, TheStepThatFallsAsleepReportsTheAirThatIsLeft) {
    const Story story = story_of({.cells = {1, 1, 1},
                                  .cell_size = 0.133569673f,
                                  .boundaries = {.y_low = {.kind = BoundaryKind::periodic},
                                                 .y_high = {.kind = BoundaryKind::periodic},
                                                 .z_low = {.kind = BoundaryKind::periodic},
                                                 .z_high = {.kind = BoundaryKind::periodic}},
                                  .blend_width = 0.0f,
                                  .viscosity = 0.0f,
                                  .relaxation_time = 0.100000001f,
                                  .max_substeps = 1},
                                 {story::StartAir::Pattern::white, 0.00999999978f, 1u, false},
                                 {story::Steps{2, 0.14060475241299156}, story::Steps{2, 0.031622776601683798}});
    EXPECT_EQ(tell(story).fault, "");
}

// Not a fault of the wind but of its teller, who must know: a box that is told to move in ticks moves in the next step, and
// leaves a broken cell behind, unrepaired.
TEST(ToldStories, ABrokenCellThatTheBoxLeavesBehindIsNotRepaired) {
    const Story story = story_of({.cells = {1, 1, 1},
                                  .cell_size = 0.0500000007f,
                                  .ambient = {-20.0f, -20.0f, -20.0f},
                                  .ticks = {.hz = 5.0, .max_per_call = 1}},
                                 {story::StartAir::Pattern::ambient, 1.0f, 1u, false},
                                 {story::Advances{1, 0.001}, story::Follow{{-1.0, -1.0, -1.0}},
                                  story::Break{0, std::numeric_limits<float>::quiet_NaN()}, story::Steps{1, 0.0001}});
    EXPECT_EQ(tell(story).fault, "");
}

// Gusts of the cells' own size, 4 m over the ground: the stress of the ambient wind kicked air that did not shear to 84 m/s.
TEST(ToldStories, TheStressOfTheWindDoesNotKickAirThatDoesNotShear) {
    const Boundaries slips = {.x_high = {.kind = BoundaryKind::free_slip},
                              .y_high = {.kind = BoundaryKind::free_slip},
                              .z_high = {.kind = BoundaryKind::free_slip}};
    const Story story =
        story_of({.cells = {1, 6, 4},
                  .cell_size = 0.05f,
                  .boundaries = {.y_high = {.kind = BoundaryKind::free_slip},
                                 .z_low = {.kind = BoundaryKind::periodic},
                                 .z_high = {.kind = BoundaryKind::periodic}},
                  .centre = {0.0, 4.0, 0.0},
                  .ambient = {4.0f, 0.0f, 0.0f},
                  .gusts = {.intensity = 0.297f, .length = 0.065f},
                  .roughness = Roughness{.length = 1e-4f},
                  .blend_width = 0.0f,
                  .viscosity = 0.13f,
                  .relaxation_time = 0.1f,
                  .scheme = Scheme::stable_fluids,
                  .interpolation = Interpolation::linear,
                  .max_substeps = 3},
                 {story::StartAir::Pattern::ambient, 0.01f, 1u, false},
                 {story::ChangeSides{slips}, story::Steps{5, 0.000167}, story::ChangeAmbient{{0.0f, 0.0f, 10.0f}},
                  story::ChangeSides{Boundaries{}}, story::Steps{4, 0.000247}, story::Steps{4, 0.01}, story::Steps{2, 1.0}});
    EXPECT_EQ(tell(story).fault, "");
}

// The teller itself: it must see what is wrong.
TEST(ToldStories, AFaultIsTold) {
    const Story still = story_of({.cells = {4, 4, 4}, .ambient = {1.0f, 0.0f, 0.0f}}, {}, {story::Steps{2, 0.1}});
    EXPECT_EQ(tell(still).fault, "");
    EXPECT_EQ(tell(still).steps, 2);
    Story stirred = still;
    stirred.start = {story::StartAir::Pattern::white, 1.0f, 1u, true};
    EXPECT_NE(tell(stirred, {.energy_of_start = 0.1}).fault, ""); // one step does not take nine tenths
    Story rejected = still;
    rejected.config.cell_size = -1.0f;
    EXPECT_NE(tell(rejected).fault, "");
    rejected = still;
    rejected.events.push_back(story::Add{OmniMotor{.radius = -1.0f}});
    EXPECT_NE(tell(rejected).fault, "");
}

TEST(ToldStories, AStoryIsPrintedAsItIsWritten) {
    const Story story =
        story_of({.cells = {1, 2, 3}, .ambient = {0.1f, 0.0f, 0.0f}}, {story::StartAir::Pattern::shear, 2.0f, 7u, true},
                 {story::Steps{2, 0.1}, story::Add{OmniMotor{.radius = 3.0f, .speed = -1.0f}}, story::Move{1, {}}});
    EXPECT_EQ(text_of(story), "story_of({.cells = {1, 2, 3}, .ambient = {0.100000001f, 0.0f, 0.0f}},\n"
                              "         {story::StartAir::Pattern::shear, 2.0f, 7u, true},\n"
                              "         {story::Steps{2, 0.10000000000000001},\n"
                              "          story::Add{OmniMotor{.radius = 3.0f, .speed = -1.0f}},\n"
                              "          story::Move{1, {0.0, 0.0, 0.0}}})");
}

} // namespace
