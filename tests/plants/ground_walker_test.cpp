// Who stands, who is small, who is one too many, who jumps: walkers on the ground beside the plain walk of ground_test.cpp.
#include "coupling/ground_memory.h"
#include "coupling/motion_numerics.h"
#include "coupling/plant_numerics.h"
#include "tests/figure.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace windrow {
namespace {

const glm::dvec3 k_texel(0.125, 0.0, 0.125); // a texel's centre

GroundMemory walked_ground(const GroundConfig& config) {
    auto made = GroundMemory::create(config);
    EXPECT_TRUE(made) << (made ? "" : made.error());
    return *std::move(made);
}

void walk_on(GroundMemory& ground, double duration, std::span<const GroundWalker> walkers = {}) {
    const auto done = ground.advance({.duration = duration, .walkers = walkers});
    ASSERT_TRUE(done) << done.error();
}

GroundWalker walker_at(glm::dvec3 place, float weight = 1.0f) {
    return {.position = place, .previous = place, .weight = weight};
}

// --- The trail of who stays -------------------------------------------------------------------------------------------------

// A walker passes 5 cm from a texel, stops 20 cm on and stands there for three of the trail's times: then what it passed with has
// faded below what it stands with, and that is what lies there, as for one who has only stood. Bound: the share by which a trail
// must be behind before it is renewed.
TEST(GroundWalkers, WhoStopsOnATrailHoldsIt) {
    GroundMemory passed = walked_ground({}), fresh = walked_ground({});
    const glm::dvec3 stop = k_texel + glm::dvec3(0.2, 0.0, 0.05);
    GroundWalker walker = walker_at(stop - glm::dvec3(1.5, 0.0, 0.0));
    for (int frame = 0; frame < 60; ++frame) {
        walker.previous = walker.position;
        walker.position.x = stop.x - 1.5 * (59 - frame) / 60.0;
        walk_on(passed, 1.0 / 60.0, std::span(&walker, 1));
    }
    walker = walker_at(stop);
    for (int frame = 0; frame < 3600; ++frame) {
        walk_on(passed, 1.0 / 60.0, std::span(&walker, 1));
        walk_on(fresh, 1.0 / 60.0, std::span(&walker, 1));
    }
    const double stood = static_cast<double>(fresh.at(k_texel).trail), held = static_cast<double>(passed.at(k_texel).trail);
    test::figure("ground/stands/trail_of_who_only_stood", stood);
    EXPECT_GT(stood, 0.3);
    WINDROW_EXPECT_FIGURE("ground/stands/lost_by_who_passed_first", 1.0 - held / stood, 1e-5);
}

// One who stops right on a texel's centre pushes it nowhere; what the way there has left is held.
TEST(GroundWalkers, WhoStopsRightOnATexelHoldsItsTrail) {
    GroundMemory ground = walked_ground({});
    GroundWalker walker = walker_at(k_texel - glm::dvec3(0.5, 0.0, 0.0));
    walker.position = k_texel;
    walk_on(ground, 1.0 / 60.0, std::span(&walker, 1));
    const double before = static_cast<double>(ground.at(k_texel).trail);
    walker = walker_at(k_texel);
    for (int frame = 0; frame < 3600; ++frame)
        walk_on(ground, 1.0 / 60.0, std::span(&walker, 1));
    const double held = static_cast<double>(ground.at(k_texel).trail);
    WINDROW_EXPECT_FIGURE("ground/stands/lost_right_under", 1.0 - held / before, 1e-5);
}

// One who treads hard and leaves, while another who treads lightly stays.
TEST(GroundWalkers, InACrowdTheTrailIsOfTheStrongestThatHasNotFaded) {
    GroundMemory crowd = walked_ground({}), alone = walked_ground({});
    const GroundWalker light = walker_at(k_texel + glm::dvec3(0.0, 0.0, 0.1), 0.4f);
    const GroundWalker both[] = {walker_at(k_texel + glm::dvec3(0.1, 0.0, 0.0)), light};
    walk_on(crowd, 1.0 / 60.0, both);
    for (int frame = 0; frame < 3600; ++frame) {
        walk_on(crowd, 1.0 / 60.0, std::span(&light, 1));
        walk_on(alone, 1.0 / 60.0, std::span(&light, 1));
    }
    const double held = static_cast<double>(crowd.at(k_texel).trail), stood = static_cast<double>(alone.at(k_texel).trail);
    EXPECT_GT(stood, 0.1);
    WINDROW_EXPECT_FIGURE("ground/stands/lost_in_a_crowd", 1.0 - held / stood, 1e-5);
}

// --- The unit of a lean -----------------------------------------------------------------------------------------------------

// A lean is a bend in radians, as stems take it: grass that the default walker has pressed lies, the bend's tip 80 degrees down.
TEST(GroundWalkers, PressedGrassLies) {
    GroundMemory ground = walked_ground({.texel_size = 0.01f, .blend_width = 0.1f});
    const GroundWalker walker{.position = {0.055, 0.0, 0.005}, .previous = {0.055, 0.0, 0.005}};
    walk_on(ground, 1.0 / 60.0, std::span(&walker, 1));
    const glm::vec2 lean = ground.at({0.005, 0.0, 0.005}).lean; // five texels beside the middle
    const numerics::WindrowStem stem =
        numerics::windrow_stem({0.0f, 1.0f, 0.0f}, 1.0f, {lean.x, 0.0f, lean.y}, glm::vec3(0.0f), 0.0f, 1.5f);
    const glm::vec3 before = numerics::windrow_stem_shift(stem, 0.999f), tip = numerics::windrow_stem_shift(stem, 1.0f);
    const glm::dvec3 along = glm::dvec3(tip - before) + glm::dvec3(0.0, 0.001, 0.0);
    const double degrees = std::acos(along.y / glm::length(along)) * 180.0 / std::numbers::pi;
    EXPECT_GT(test::figure("ground/push/degrees_down", degrees), 70.0);
    EXPECT_LT(degrees, 90.0);

    // In texels as wide as half the walker's radius the inmost one takes a good part of the push.
    GroundMemory coarse = walked_ground({});
    const GroundWalker walks{.position = {1.0, 0.0, 0.125}, .previous = {-1.0, 0.0, 0.125}};
    walk_on(coarse, 1.0 / 60.0, std::span(&walks, 1));
    const auto down = [](glm::vec2 bend) { return static_cast<double>(glm::length(bend)) * 180.0 / std::numbers::pi; };
    test::figure("ground/push/default_texels_degrees_on_the_path", down(coarse.at({0.125, 0.0, 0.125}).lean));
    test::figure("ground/push/default_texels_degrees_a_texel_beside", down(coarse.at({0.125, 0.0, 0.375}).lean));
}

// A hand in the strands of a plane presses by the same weight as a foot on the ground; of no size it presses nothing.
TEST(GroundWalkers, HandsAndFeetPressAlike) {
    numerics::WindrowWalker foot{};
    foot.from = {3.0f, 4.0f, 0.0f, 2.5f};
    foot.to = {3.0f, 4.0f, 0.0f, 1.0f};
    int pressed = 0;
    for (float x = 0.0f; x < 6.0f; x += 0.37f)
        for (float y = 1.0f; y < 7.0f; y += 0.41f) {
            const float weight = numerics::windrow_ground_contact(foot, {x, y}, 0.4f).weight;
            EXPECT_NEAR(glm::length(numerics::windrow_radial_load({x - 3.0f, y - 4.0f}, 2.5f, 1.0f)), weight, 1e-6f);
            pressed += weight > 0.0f ? 1 : 0;
        }
    EXPECT_GT(pressed, 50);
    EXPECT_EQ(numerics::windrow_radial_load({0.0f, 0.0f}, 0.0f, 1.0f), glm::vec2(0.0f));
    EXPECT_EQ(numerics::windrow_radial_load({0.1f, 0.0f}, 0.0f, 1.0f), glm::vec2(0.0f));
}

// --- Small, many, jumping ---------------------------------------------------------------------------------------------------

// A foot of 5 cm at the corner of four texels of 25 cm.
TEST(GroundWalkers, ASmallFootBetweenTexelsIsFelt) {
    GroundMemory ground = walked_ground({});
    const GroundWalker foot{.radius = 0.05f};
    walk_on(ground, 1.0 / 60.0, std::span(&foot, 1));
    EXPECT_GT(test::figure("ground/small_foot/trample", static_cast<double>(ground.at(k_texel).trample)), 0.2);
    EXPECT_EQ(ground.at({0.375, 0.0, 0.125}).trample, 0.0f); // the next texel is further than one texel
}

// More than there is room for: the first ones count, and the host is told.
TEST(GroundWalkers, OneTooManyIsLeftOutAlone) {
    GroundMemory ground = walked_ground({.max_walkers = 2});
    const GroundWalker crowd[] = {walker_at({-4.0, 0.0, 0.0}), walker_at({100.0, 0.0, 0.0}), walker_at({0.0, 0.0, 0.0}),
                                  walker_at({4.0, 0.0, 0.0})}; // the second is out of the window and takes no room
    walk_on(ground, 0.1, crowd);
    EXPECT_GT(ground.at(crowd[0].position).trample, 0.5f);
    EXPECT_GT(ground.at(crowd[2].position).trample, 0.5f);
    EXPECT_EQ(ground.at(crowd[3].position).trample, 0.0f);
    EXPECT_EQ(ground.walkers_left_out(), 1);
    walk_on(ground, 0.1, std::span(crowd, 3));
    EXPECT_EQ(ground.walkers_left_out(), 0);
}

// Height is no part of the way: a fall from a roof is a step, a leap of 30 m aside is not.
TEST(GroundWalkers, AFallIsNoTeleport) {
    GroundMemory ground = walked_ground({});
    const GroundWalker fell{.position = {1.0, 0.0, 0.0}, .previous = {-1.0, 30.0, 0.0}};
    walk_on(ground, 0.1, std::span(&fell, 1));
    EXPECT_GT(ground.at({0.0, 0.0, 0.0}).trample, 0.5f);
}

// A respawn over 3 m in a frame is 180 m/s: a jump, as for obstacles and wakes of the wind. With 0 nothing is.
TEST(GroundWalkers, ARespawnSweepsNothing) {
    for (const double way : {1.0, 3.0, 1000.0})
        for (const float fastest : {100.0f, 0.0f}) {
            GroundMemory ground = walked_ground({.jump_speed = fastest});
            const GroundWalker moved{.position = {2.0, 0.0, 0.0}, .previous = {2.0 - way, 0.0, 0.0}};
            walk_on(ground, 1.0 / 60.0, std::span(&moved, 1));
            EXPECT_GT(ground.at(moved.position).trample, 0.5f);
            EXPECT_EQ(ground.at({2.0 - 0.6 * std::min(way, 4.0), 0.0, 0.0}).trample > 0.3f, way < 2.0 || fastest == 0.0f) << way;
        }
}

// A host that pauses steps by 0 s. Who is put elsewhere meanwhile has jumped; who stands where he was presses there.
TEST(GroundWalkers, AWayInNoTimeSweepsNothing) {
    GroundMemory ground = walked_ground({});
    const GroundWalker moved{.position = {6.0, 0.0, 0.0}, .previous = {-6.0, 0.0, 0.0}};
    walk_on(ground, 0.0, std::span(&moved, 1));
    EXPECT_EQ(ground.at({0.0, 0.0, 0.0}).trample, 0.0f);
    EXPECT_EQ(ground.at({0.0, 0.0, 0.0}).trail, 0.0f);
    EXPECT_GT(ground.at(moved.position).trample, 0.5f);
    const GroundWalker stands = walker_at(k_texel);
    walk_on(ground, 0.0, std::span(&stands, 1));
    EXPECT_GT(ground.at(k_texel).trample, 0.5f);
}

// Who presses nothing leaves his room to the next.
TEST(GroundWalkers, WhoPressesNothingTakesNoRoom) {
    GroundMemory ground = walked_ground({.max_walkers = 1});
    GroundWalker crowd[] = {walker_at({-4.0, 0.0, 0.0}, 0.0f), walker_at({-2.0, 0.0, 0.0}), walker_at({0.0, 0.0, 0.0}),
                            walker_at({4.0, 0.0, 0.0})};
    crowd[1].foot_height = crowd[1].previous_foot_height = 5.0f;
    crowd[2].foot_height = -3.0f;
    crowd[2].previous_foot_height = -2.0f;
    crowd[3].previous.x = 3.0; // who leaps off
    crowd[3].foot_height = 1.0f;
    walk_on(ground, 0.1, crowd);
    EXPECT_EQ(ground.walkers_left_out(), 0);
    EXPECT_GT(ground.at(crowd[3].previous).trample, 0.3f);
    EXPECT_EQ(ground.at(crowd[0].position).trample + ground.at(crowd[1].position).trample, 0.0f);
}

// Who walks in a cellar leaves the meadow above alone; who sinks in by less than the clearance presses in full.
TEST(GroundWalkers, OneUnderTheGroundTouchesNothing) {
    const auto trample_of = [](float feet) {
        GroundMemory ground = walked_ground({});
        const GroundWalker walker{.foot_height = feet, .previous_foot_height = feet};
        walk_on(ground, 1.0 / 60.0, std::span(&walker, 1));
        return ground.at(k_texel).trample;
    };
    const float whole = trample_of(0.0f);
    EXPECT_GT(whole, 0.5f);
    EXPECT_EQ(trample_of(-0.4f), whole);
    EXPECT_NEAR(trample_of(-0.6f), 0.5f * whole, 1e-3f);
    EXPECT_EQ(trample_of(-5.0f), 0.0f);
}

TEST(GroundWalkers, AHeightThatDoesNotCountMayBeAnything) {
    GroundMemory ground = walked_ground({});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const GroundWalker walker{.position = {0.0, nan, 0.0}, .previous = {0.0, nan, 0.0}};
    EXPECT_TRUE(ground.follow({1.0, nan, 2.0}));
    EXPECT_TRUE(ground.advance({.duration = 0.1, .walkers = std::span(&walker, 1)}));
    EXPECT_GT(ground.at({0.0, 0.0, 0.0}).trample, 0.5f);
}

} // namespace
} // namespace windrow
