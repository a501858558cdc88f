// Where the eye of the window is, and what is under a pixel.
#include "vegetation/view/eye.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace windrow::vegetation::view {
namespace {

const render::Camera k_far_away{.position = {1.0e6 + 10.0, 5.0, 0.0}, .target = {1.0e6, 1.0, 0.0}, .view_deg = 45.0f};

TEST(Eye, CirclesItsTargetAtItsDistance) {
    Eye eye(k_far_away);
    const render::Camera before = eye.camera({});
    EXPECT_LT(glm::distance(before.position, k_far_away.position), 1e-6);
    eye.turn(1.0, 0.3);
    const render::Camera after = eye.camera({});
    EXPECT_EQ(after.target, k_far_away.target);
    EXPECT_NEAR(glm::distance(after.position, after.target), glm::distance(before.position, before.target), 1e-6);
    EXPECT_GT(glm::distance(after.position, before.position), 5.0);
    eye.turn(0.0, 100.0); // never straight above, where a camera has no up
    EXPECT_TRUE(render::validate(eye.camera({})));
}

TEST(Eye, TurnsOnTheSpotWhereItFlies) {
    Eye eye(k_far_away);
    eye.set_mode(EyeMode::fly);
    const glm::dvec3 before = eye.camera({}).position;
    eye.turn(1.0, 0.1);
    EXPECT_LT(glm::distance(eye.camera({}).position, before), 1e-6);
    EXPECT_GT(glm::distance(eye.target(), k_far_away.target), 1.0);
}

TEST(Eye, GoesAlongWithWhatTheBoxFollows) {
    Eye eye(k_far_away);
    eye.follow({0.0, 0.0, 0.0});
    eye.follow({1.0, 0.0, 0.0});
    EXPECT_EQ(eye.target(), k_far_away.target); // it circles
    eye.set_mode(EyeMode::follow);
    eye.follow({3.0, 0.0, 1.0});
    EXPECT_EQ(eye.target(), k_far_away.target + glm::dvec3(2.0, 0.0, 1.0));
}

TEST(Projection, FindsThePlaceUnderThePixelOfAPlace) {
    const Projection projection(k_far_away, {960.0f, 540.0f});
    const auto middle = projection.pixel(k_far_away.target);
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->x, 480.0f, 0.01f);
    EXPECT_NEAR(middle->y, 270.0f, 0.01f);
    const glm::dvec3 place = k_far_away.target + glm::dvec3(-2.0, 0.0, 1.5);
    const auto pixel = projection.pixel(place);
    ASSERT_TRUE(pixel);
    EXPECT_LT(pixel->y, 270.0f); // farther is higher
    const auto found = projection.on_level(*pixel, place.y);
    ASSERT_TRUE(found);
    EXPECT_LT(glm::distance(*found, place), 1e-3);
    EXPECT_FALSE(projection.pixel(k_far_away.position + glm::dvec3(5.0, 0.0, 0.0))); // behind
    EXPECT_FALSE(projection.on_level({480.0f, 10.0f}, 50.0));                        // the ray leads down
}

TEST(Projection, CutsALineThatBeginsBehindTheEye) {
    const Projection projection(k_far_away, {960.0f, 540.0f});
    const auto line = projection.segment(k_far_away.position + glm::dvec3(5.0, 0.0, 0.0), k_far_away.target);
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->second.x, 480.0f, 0.01f);
    EXPECT_FALSE(
        projection.segment(k_far_away.position + glm::dvec3(5.0, 0.0, 0.0), k_far_away.position + glm::dvec3(6.0, 0.0, 0.0)));
}

} // namespace
} // namespace windrow::vegetation::view
