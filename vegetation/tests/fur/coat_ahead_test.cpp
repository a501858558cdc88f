// How fast a coat's skin is for the wind that it feels: of the moment, whatever the frame's length, from the first frame on.
#include "tests/figure.h"
#include "vegetation/tests/fur/stage.h"

#include <algorithm>

namespace windrow::vegetation::fur::test {
namespace {

TEST(CoatAhead, SkinHasTheSpeedOfTheMomentFromTheFirstFrame) {
    Stage stage;
    Coat& coat = stage.dress(square(), bare_bones(), at({}));
    const glm::dvec3 speed{4.0, 0.0, -3.0};
    double worst = 0.0;
    double time = 0.0;
    for (const double frame : {0.0, 1.0 / 30.0, 1.0 / 144.0}) { // 0: it was put there
        time += frame;
        CoatAhead ahead;
        ahead.body = at((time + ahead.seconds) * speed);
        ASSERT_TRUE(coat.move(frame, at(time * speed), {}, ahead));
        stage.draw(camera_at({0.0, 5.0, 3.0}));
        for (const CoatSkinBlock& vertex : engine::must(coat.skin()))
            worst = std::max(worst, glm::length(glm::dvec3(vertex.velocity) - speed));
    }
    // Two floats of a metre, 1.2e-7 apart at most, over 2 ms.
    WINDROW_EXPECT_FIGURE("shells/ahead/off_speed_m_s", worst, 1e-3);
    EXPECT_FALSE(coat.move(0.1, at({}), {}, CoatAhead{.seconds = 0.0, .body = at({}), .bones = {}}));
}

} // namespace
} // namespace windrow::vegetation::fur::test
