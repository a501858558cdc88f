// Feet that press strands of coats aside.
#include "tests/figure.h"
#include "vegetation/tests/fur/coat_numerics.h"
#include "vegetation/tests/fur/stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace windrow::vegetation::fur::test {
namespace {

constexpr float k_radius = 0.5f;

CoatSettings lawn() {
    CoatSettings grass = bare_bones();
    grass.layers.length = 0.2f;
    grass.layers.shells = 8;
    grass.wind_fraction = 0.0f;
    return grass;
}

// Strands lean outward around the sole, none beyond its radius, none under a sole that is lifted by the strands' length.
TEST(CoatFeet, LeanStrandsOutwardWithinTheirRadius) {
    Stage stage;
    Coat& grass = stage.dress(*sheet({.size = {2.0f, 2.0f}, .columns = 40, .rows = 40}), lawn(), at({}));
    const render::Camera camera = camera_at({0.0, 3.0, 2.0});
    const glm::dvec3 sole{0.13, 0.0, -0.21};
    double worst_deg = 0.0, beyond = 0.0, most = 0.0, off_formula = 0.0;
    ASSERT_TRUE(grass.set_feet(std::array{Foot{.position = k_anchor + sole, .radius = k_radius}}));
    stage.draw(camera);
    int pressed = 0;
    for (const CoatSkinBlock& root : engine::must(grass.skin())) {
        const glm::dvec2 away(static_cast<double>(root.position.x) - sole.x, static_cast<double>(root.position.z) - sole.z);
        const glm::dvec2 load(root.load.x, root.load.z);
        const double far = glm::length(away), leant = glm::length(load);
        if (far >= static_cast<double>(k_radius)) {
            beyond = std::max(beyond, leant);
            continue;
        }
        const double share = far / static_cast<double>(k_radius);
        off_formula = std::max(off_formula, std::abs(leant - 1.2 * std::pow(1.0 - share * share, 2.0)));
        most = std::max(most, leant);
        if (leant > 1e-3) {
            ++pressed;
            worst_deg = std::max(worst_deg, std::acos(std::min(1.0, glm::dot(away, load) / (far * leant))) * 57.29577951308232);
        }
    }
    EXPECT_GT(pressed, 200);
    EXPECT_GT(most, 1.0);
    WINDROW_EXPECT_FIGURE("shells/feet/off_outward_deg", worst_deg, 5.0);
    WINDROW_EXPECT_FIGURE("shells/feet/beyond_rad", beyond, 0.0);
    WINDROW_EXPECT_FIGURE("shells/feet/off_formula_rad", off_formula, 1e-4); // 0.2 um of a place that far from the anchor

    ASSERT_TRUE(grass.set_feet(std::array{Foot{.position = k_anchor + sole + glm::dvec3(0.0, 0.2, 0.0), .radius = k_radius}}));
    stage.draw(camera);
    double lifted = 0.0;
    for (const CoatSkinBlock& root : engine::must(grass.skin()))
        lifted = std::max(lifted, static_cast<double>(glm::length(glm::vec3(root.load))));
    WINDROW_EXPECT_FIGURE("shells/feet/lifted_rad", lifted, 1e-5);
}

// The idea of Curoe's page: a foot is seen on a square of four vertices, whose corners do not feel it.
TEST(CoatFeet, AreSeenOnFourVertices) {
    Stage stage;
    CoatSettings grass = lawn();
    grass.wind_at = WindAt::pixel;
    grass.strands_on = StrandsOn::uv;
    grass.strands.density = 24.0f;
    grass.look.tip = grass.look.second = {0.1f, 0.6f, 0.1f};
    Coat& coat = stage.dress(square(2.0f), grass, at({}));
    const render::Camera camera = camera_at({0.0, 6.0, 0.1}, {}, 24.0f);
    stage.draw(camera);
    const render::PictureF free = stage.light();
    ASSERT_TRUE(coat.set_feet(std::array{Foot{.position = k_anchor, .radius = k_radius}}));
    stage.draw(camera);
    const render::PictureF trodden = stage.light();
    const double reach = static_cast<double>(k_radius) + 0.2; // a strand at its rim leans out by its length at most
    int within = 0, beyond = 0, counted = 0;
    const glm::dvec2 middle = seen(camera, {}, 256, 256), rim = seen(camera, {reach, 0.2, 0.0}, 256, 256);
    for (int row = 0; row < 256; ++row)
        for (int column = 0; column < 256; ++column) {
            const bool changed = glm::length(radiance(free, column, row) - radiance(trodden, column, row)) > 1e-3f;
            const double far = glm::length(glm::dvec2(column, row) + 0.5 - middle);
            beyond += changed && far > rim.x - middle.x + 2.0 ? 1 : 0;
            if (far < 0.5 * (rim.x - middle.x)) {
                within += changed ? 1 : 0;
                ++counted;
            }
        }
    EXPECT_GT(within, counted / 4);
    WINDROW_EXPECT_FIGURE("shells/feet/pixels_changed_beyond", beyond, 0);
}

TEST(CoatFeet, RejectWhatIsNoFoot) {
    const auto rejected = [](const Foot& foot, const char* field) {
        const auto judged = validate(std::span(&foot, 1));
        ASSERT_FALSE(judged) << field;
        EXPECT_NE(judged.error().find(field), std::string::npos) << judged.error();
    };
    rejected({.radius = 0.0f}, "feet[0].radius");
    rejected({.radius = std::numeric_limits<float>::quiet_NaN()}, "feet[0].radius");
    rejected({.weight = 1.5f}, "feet[0].weight");
    rejected({.position = {0.0, std::numeric_limits<double>::infinity(), 0.0}}, "feet[0].position");
    EXPECT_FALSE(validate(std::vector<Foot>(k_max_feet + 1)));
    EXPECT_TRUE(validate(std::vector<Foot>(k_max_feet)));
}

} // namespace
} // namespace windrow::vegetation::fur::test
