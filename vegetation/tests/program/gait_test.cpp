// Walkers on their feet: a foot that stands does not slide, legs keep their length, knees bend forward.
#include "tests/figure.h"
#include "vegetation/program/figures.h"
#include "vegetation/program/picture_reader.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>

namespace windrow::vegetation::program {
namespace {

namespace person = render::person;

windrow::Result<PictureScene> read_walk(const std::string& points) {
    return read_picture_scene_text(R"({"paths": {"way": {"points": )" + points + R"(}}, "picture": {"ground_memory": {},
        "ground": {"hills": {"height": 3, "length": 20}}, "walkers": [{"path": "way"}]}})",
                                   "a.json");
}

constexpr const char* k_stroll = "[[0, 0, 0, 0], [6, 8, 0, 1], [8, 8, 0, 1], [14, 9, 0, 9]]"; // with a rest and a corner
constexpr const char* k_run = "[[0, 0, 0, 0], [4, 0, 0, 18]]";

TEST(Gait, FootThatStandsDoesNotSlideAndSwingsTakeItOn) {
    for (const char* points : {k_stroll, k_run}) {
        const auto scene = read_walk(points);
        ASSERT_TRUE(scene) << scene.error();
        const Gait gait(scene->air.paths[0].path);
        int stands = 0, both_down = 0, none_down = 0;
        double last[2] = {gait.foot(0, 0.0).way, gait.foot(1, 0.0).way};
        bool planted[2] = {gait.foot(0, 0.0).planted, gait.foot(1, 0.0).planted};
        for (int n = 1; n < 2800; ++n) {
            const double time = 0.005 * n;
            int down = 0;
            for (int side = 0; side < 2; ++side) {
                const Gait::Foot foot = gait.foot(side, time);
                if (foot.planted && planted[side]) {
                    EXPECT_EQ(foot.way, last[side]) << "at " << time;
                }
                EXPECT_GE(foot.way, last[side] - 1e-12) << "no foot goes back";
                // A step of 5 ms: the swing's fastest is 1.5 strides over what it lasts, well below 10 times the walker's speed.
                EXPECT_LT(foot.way - last[side], 0.005 * 10.0 * gait.speed()) << "no foot jumps, at " << time;
                EXPECT_LT(std::abs(foot.way - gait.way(time)), 0.8 * gait.stride()) << "it stays below the body";
                stands += foot.planted && !planted[side];
                down += foot.planted;
                last[side] = foot.way;
                planted[side] = foot.planted;
            }
            both_down += down == 2;
            none_down += down == 0;
        }
        EXPECT_GT(stands, 8);
        EXPECT_EQ(none_down > 0, gait.runs()) << "who walks has a foot on the ground";
        EXPECT_EQ(both_down > 0, !gait.runs()) << "who runs never has both";
    }
}

TEST(Gait, StrideGrowsWithTheSpeedAndWhoStandsStands) {
    const auto slow = read_walk(k_stroll), fast = read_walk(k_run), still = read_walk("[[0, 3, 0, 4]]");
    ASSERT_TRUE(slow && fast && still);
    const Gait walk(slow->air.paths[0].path), run(fast->air.paths[0].path), stand(still->air.paths[0].path);
    EXPECT_GT(windrow::test::figure("gait/stride_walk", walk.stride()), 1.2); // people: 1.4 to 1.6 m at 1.35 m/s
    EXPECT_LT(walk.stride(), 1.7);
    EXPECT_GT(windrow::test::figure("gait/stride_run", run.stride()), 2.4); // people: 2.5 to 3.4 m at 4.5 m/s
    EXPECT_LT(run.stride(), 3.5);
    EXPECT_EQ(stand.speed(), 0.0);
    const WalkerPose pose = walker_pose(*still, still->picture.walkers[0], stand, 1.0);
    EXPECT_EQ(pose.place.x, 3.0);
    EXPECT_NEAR(pose.stance.legs[0].ankle.z, pose.stance.legs[1].ankle.z, 1e-6f);
}

TEST(Gait, LegsKeepTheirLengthKneesBendForwardAndAnklesAreWhereTheFeetStand) {
    for (const char* points : {k_stroll, k_run}) {
        const auto scene = read_walk(points);
        ASSERT_TRUE(scene) << scene.error();
        const Gait gait(scene->air.paths[0].path);
        double off = 0.0, missed = 0.0, backward = 0.0, jump = 0.0;
        float hip = 0.0f;
        for (int n = 0; n < 1400; ++n) {
            const WalkerPose pose = walker_pose(*scene, scene->picture.walkers[0], gait, 0.01 * n);
            const render::PersonParts parts = render::person_parts(pose.stance);
            if (n > 0)
                jump = std::max(jump, static_cast<double>(std::abs(pose.stance.hip - hip)));
            hip = pose.stance.hip;
            for (int side = 0; side < 2; ++side) {
                const auto of = [&](person::Part part) { return parts[static_cast<std::size_t>(part + side)]; };
                const glm::vec3 top(of(person::thigh)[3]), knee(of(person::shin)[3]), ankle(of(person::foot)[3]);
                off = std::max({off, static_cast<double>(std::abs(glm::distance(top, knee) - person::k_thigh)),
                                static_cast<double>(std::abs(glm::distance(knee, ankle) - person::k_shin))});
                backward = std::max(backward, static_cast<double>(glm::mix(top, ankle, 0.5f).z - knee.z));
                if (const auto foot = gait.foot(side, 0.01 * n); foot.planted && foot.stood < 0.5)
                    missed = std::max(missed, static_cast<double>(
                                                  glm::distance(ankle, pose.stance.legs[static_cast<std::size_t>(side)].ankle)));
            }
        }
        const std::string name = gait.runs() ? "gait/run" : "gait/walk";
        WINDROW_EXPECT_FIGURE(name + "/leg_length_off", off, 1e-4);
        WINDROW_EXPECT_FIGURE(name + "/knee_backward", backward, 0.03);
        WINDROW_EXPECT_FIGURE(name + "/planted_ankle_missed", missed, 0.01); // [m] while it carries
        WINDROW_EXPECT_FIGURE(name + "/hips_jump_in_10_ms", jump, 0.02);     // 2 m/s
    }
}

} // namespace
} // namespace windrow::vegetation::program
