// Coats on bodies that move: lag, bones, motion vectors, on the device's own vertices.
#include "tests/figure.h"
#include "vegetation/fur/beast.h"
#include "vegetation/fur/skeleton.h"
#include "vegetation/tests/fur/coat_numerics.h"
#include "vegetation/tests/fur/stage.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace windrow::vegetation::fur::test {
namespace {

using namespace numerics;

// [m] From the skin: separate from the place, whose own rounding is 1e-7 m.
glm::dvec3 layer_offset(const Coat& coat, const CoatSkinBlock& skin, float h) {
    const auto shells = windrow::detail::shared(coat.block().shells);
    const glm::vec3 n(skin.normal);
    if (coat.settings().translated)
        return glm::dvec3(windrow_shell_translated(shells, glm::vec3(0.0f), n, h, 1.0f, glm::vec3(skin.load)) +
                          h * (glm::vec3(skin.lag) + h * glm::vec3(skin.lag_more)));
    const WindrowCoatStrand strand = windrow_coat_strand(shells, n, skin.position.w, glm::vec3(skin.load), glm::vec3(skin.own),
                                                         glm::vec3(skin.lag), glm::vec3(skin.lag_more));
    return glm::dvec3((shells.form.x * h + shells.form.x * shells.form.z) * n + windrow_coat_shift(strand, h));
}
glm::dvec3 layer_place(const Coat& coat, const CoatSkinBlock& skin, float h) {
    return glm::dvec3(glm::vec3(skin.position)) + layer_offset(coat, skin, h);
}

// A body that jerks and turns, on the device's own vertices: no shell enters the skin, and the shells lag without crossing.
TEST(CoatMotion, LagNeitherEntersTheSkinNorCrossesLayers) {
    Stage stage({.ambient = {5.0f, 0.0f, 0.0f}, .gusts = 0.5f, .width = 32, .height = 32});
    CoatSettings settings = bare_bones();
    settings.layers.sag = 0.6f;
    settings.layers.length = 0.1f;
    settings.comb.bend = 0.8f;
    settings.inertia.emplace();
    Coat& coat = stage.dress(*globe_sphere({}), settings, at({}));
    double inward = 0.0, crossed = 0.0, max_lag = 0.0, longest = 0.0;
    double tip_before = 1e9;
    for (int frame = 0; frame < 24; ++frame) {
        windrow::Pose body = at({frame < 6 ? 0.25 * frame : 1.25, frame == 3 ? 0.5 : 0.0, 0.0});
        body.rotation = {0.0, std::sin(0.2 * std::min(frame, 8)), 0.0, std::cos(0.2 * std::min(frame, 8))};
        ASSERT_TRUE(coat.move(k_frame, body));
        stage.draw(camera_at({0.0, 0.3, 4.0}));
        double lag = 0.0;
        for (const CoatSkinBlock& skin : engine::must(coat.skin())) {
            double last = 0.0;
            glm::dvec3 there(0.0);
            double way = 0.0;
            for (int layer = 1; layer <= 16; ++layer) {
                const glm::dvec3 place = layer_offset(coat, skin, static_cast<float>(layer) / 16.0f);
                const double out = glm::dot(place, glm::dvec3(glm::vec3(skin.normal)));
                inward = std::max(inward, -out / 0.1);
                crossed = std::max(crossed, (last - out) / 0.1);
                way += glm::length(place - there);
                there = place;
                last = out;
            }
            longest = std::max(longest, way / 0.1);
            lag = std::max(lag, static_cast<double>(glm::length(glm::vec3(skin.lag + skin.lag_more))));
        }
        max_lag = std::max(max_lag, lag);
        if (frame > 12) { // the body rests: tips come after it
            EXPECT_LE(lag, tip_before + 1e-6);
            tip_before = lag;
        }
    }
    EXPECT_GT(windrow::test::figure("shells/lag/max_m", max_lag), 0.1);
    WINDROW_EXPECT_FIGURE("shells/lag/inward", inward, 1e-6);
    WINDROW_EXPECT_FIGURE("shells/lag/crossed", crossed, 1e-5);
    WINDROW_EXPECT_FIGURE("shells/lag/stretched", longest - 1.0, 0.01); // strands keep their length within 1 %
}

// Motion vectors of an outermost layer that is closed, against its vertices' projected places in this frame and the last.
void expect_motion(const std::string& name, bool translated) {
    constexpr int side = 256;
    Stage stage({.ambient = {5.0f, 0.0f, 1.0f}, .gusts = 0.6f, .width = side, .height = side});
    CoatSettings settings = bare_bones();
    settings.translated = translated;
    settings.layers.shells = 2;
    settings.layers.droop = 0.03f;
    settings.layers.length = 0.12f;
    settings.layers.strand.rigidity = 2e-6f;
    settings.strands_on = StrandsOn::uv;
    settings.strands = closed();
    settings.levels.march = 0;
    settings.inertia.emplace();
    Coat& coat = stage.dress(*globe_sphere({.sectors = 40, .stacks = 30}), settings, at({}));
    const auto pose = [](int frame) {
        windrow::Pose body = at({0.01 * frame, 0.004 * frame, 0.0});
        body.rotation = {0.0, std::sin(0.01 * frame), 0.0, std::cos(0.01 * frame)};
        return body;
    };
    const auto camera = [](int frame) { return camera_at({0.02 * frame, 0.4, 3.0}, {0.0, 0.0, 0.0}, 26.0f); };
    std::vector<CoatSkinBlock> last;
    const int frames = 6;
    for (int frame = 0; frame < frames; ++frame) {
        if (frame == frames - 1)
            last = engine::must(coat.skin());
        ASSERT_TRUE(coat.move(k_frame, pose(frame)));
        stage.draw(camera(frame));
    }
    const render::PictureF motion = stage.renderer->images().motion_picture();
    double worst = 0.0, most = 0.0, of_wind = 0.0;
    int compared = 0;
    const std::vector<CoatSkinBlock> now = engine::must(coat.skin());
    for (std::size_t n = 0; n < last.size(); ++n) {
        const CoatSkinBlock& skin = now[n];
        const glm::dvec3 here = layer_place(coat, skin, 1.0f), there = layer_place(coat, last[n], 1.0f);
        const glm::dvec3 to_eye = glm::normalize(camera(frames - 1).position - k_anchor - here);
        if (glm::dot(glm::dvec3(glm::vec3(skin.normal)), to_eye) < 0.7)
            continue;
        const glm::dvec2 place = seen(camera(frames - 1), here, side, side);
        const glm::dvec2 expected = place - seen(camera(frames - 2), there, side, side);
        const int column = static_cast<int>(place.x), row = static_cast<int>(place.y);
        const glm::dvec2 got = glm::dvec2(motion.at(column, row, 0), motion.at(column, row, 1)) * double(side);
        worst = std::max(worst, glm::length(got - expected));
        most = std::max(most, glm::length(expected));
        of_wind = std::max(of_wind, static_cast<double>(glm::distance(glm::vec3(skin.load), glm::vec3(last[n].load))));
        ++compared;
    }
    windrow::test::figure("shells/motion/" + name + "/compared", compared);
    EXPECT_GT(compared, 60);
    EXPECT_GT(windrow::test::figure("shells/motion/" + name + "/of_wind_rad", of_wind), 1e-4);
    windrow::test::figure("shells/motion/" + name + "/max_px", most);
    // A pixel's middle lies up to 0.7 px from the vertex, where the motion is another: a twentieth of the largest.
    WINDROW_EXPECT_FIGURE("shells/motion/" + name + "/apart_px", worst, 0.05 * most);
}

TEST(CoatMotion, MotionIsTheDifferenceOfProjectedPlaces) {
    expect_motion("bent", false);
    expect_motion("translated", true);
}

// Displacement after skinning: the device's against the CPU's, in the body's pose.
TEST(CoatMotion, ABodyWithBonesIsSkinnedAsOnTheHost) {
    Stage stage({.width = 32, .height = 32});
    Mesh beast = *beast_mesh();
    const Skeleton skeleton = *beast_skeleton();
    ASSERT_TRUE(bind(beast, skeleton));
    CoatSettings settings = bare_bones();
    settings.layers.shells = 4;
    Coat& coat = stage.dress(beast, settings, at({}));
    windrow::Pose body = at({0.4, 0.1, -0.2}, 1.2);
    body.rotation = {0.0, std::sin(0.4), 0.0, std::cos(0.4)};
    double places = 0.0, normals = 0.0;
    for (const double seconds : {0.2, 0.55}) {
        const std::vector<glm::mat4> bones = pose(skeleton, seconds);
        ASSERT_TRUE(coat.move(k_frame, body, bones));
        stage.draw(camera_at({0.0, 0.5, 6.0}));
        std::vector<glm::vec3> positions(beast.vertices.size()), turned(beast.vertices.size());
        ASSERT_TRUE(skin(beast, bones, positions, turned));
        std::vector<bool> met(beast.vertices.size());
        std::size_t next = 0;
        const std::vector<CoatSkinBlock> posed = engine::must(coat.skin());
        const glm::dquat turn(body.rotation.w, body.rotation.x, body.rotation.y, body.rotation.z);
        for (const std::uint32_t index : beast.indices) {
            if (met[index])
                continue;
            met[index] = true;
            const CoatSkinBlock& got = posed[next++];
            const glm::dvec3 wanted = body.position - k_anchor + turn * (1.2 * glm::dvec3(positions[index]));
            places = std::max(places, glm::distance(glm::dvec3(glm::vec3(got.position)), wanted));
            normals = std::max(normals, glm::distance(glm::dvec3(glm::vec3(got.normal)), turn * glm::dvec3(turned[index])));
        }
        EXPECT_EQ(next, posed.size());
    }
    WINDROW_EXPECT_FIGURE("shells/skinning/places_m", places, 2e-6); // floats of some metres
    WINDROW_EXPECT_FIGURE("shells/skinning/normals", normals, 2e-6);
}

} // namespace
} // namespace windrow::vegetation::fur::test
