// Coats in the wind as drawn: strands that lean one by one on a square of four vertices, drift, motion vectors, lag.
#include "tests/figure.h"
#include "tests/shells/coat_numerics.h"
#include "tests/shells/stage.h"

#include <algorithm>
#include <cmath>

namespace shells::test {
namespace {

using namespace numerics;

CoatSettings bare_bones() {
    CoatSettings coat;
    coat.layers.sag = 0.0f;
    coat.look.variation = coat.look.occlusion = coat.look.gloss = coat.look.sheen = 0.0f;
    coat.levels.shadow_shells = 0;
    coat.levels.full_until = 1e4f;
    return coat;
}

// C17: tips of 10 x 10 thin strands on four vertices, against the wind that a fine mesh's vertices feel at their roots.
TEST(CoatWind, StrandsLeanOneByOneOnFourVertices) {
    constexpr int side = 320, rows = 10;
    constexpr float size = 4.0f, length = 0.3f;
    Stage stage({.ambient = {6.0f, 0.0f, 2.0f}, .gusts = 0.7f, .width = side, .height = side});
    CoatSettings thin = bare_bones();
    thin.layers.length = length;
    thin.layers.shells = 24;
    thin.layers.strand = {.length = length, .width = 2e-3f, .rigidity = 2e-4f, .drag_coefficient = 1.5f};
    CoatSettings fine = thin; // its strands are at the roots of the others: vertices in the middles of their cells
    fine.bare = true;
    fine.look.skin = {0.0f, 0.0f, 0.3f};
    const float inner = size * (rows - 1) / rows;
    Coat& reference =
        stage.dress(*sheet({.size = {inner, inner}, .columns = rows - 1, .rows = rows - 1}), fine, at({0.0, -0.02, 0.0}));
    thin.wind_at = WindAt::pixel;
    thin.strands_on = StrandsOn::uv;
    thin.strands = {.density = rows,
                    .jitter = 0.0f,
                    .low = 1.0f,
                    .high = 1.0f,
                    .profile = StrandProfile::centre,
                    .cut_min = 0.0025f,
                    .cut_max = 0.0025f};
    thin.look.root = {0.0f, 0.0f, 0.3f};
    thin.look.tip = thin.look.second = {0.0f, 0.8f, 0.0f};
    thin.look.tip_power = 10.0f; // the outermost layer alone is green
    thin.look.strand_normals = 0.0f;
    thin.levels.march = 0;
    stage.dress(square(size), thin, at({}));
    const render::Camera camera = camera_at({0.0, 20.0, 0.2}, {0.0, 0.0, 0.0}, 13.0f);
    for (int n = 0; n < 4; ++n)
        stage.draw(camera);
    const render::PictureF light = stage.light();
    float most = 0.0f;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            most = std::max(most, light.at(column, row, 1) - light.at(column, row, 2));
    double worst = 0.0, least_lean = 1e9, most_lean = 0.0;
    int found = 0;
    const auto shells = windrow::detail::shared(reference.block().shells);
    for (const CoatSkinBlock& root : reference.skin()) {
        const glm::vec3 load(root.load);
        const WindrowStem stem = windrow_stem({0.0f, 1.0f, 0.0f}, 1.0f, load, glm::vec3(0.0f), 0.0f, shells.drag.load.w);
        const glm::vec3 shift = length * windrow_stem_shift(stem, 1.0f);
        const glm::dvec3 tip = glm::dvec3(root.position.x + shift.x, length, root.position.z + shift.z); // the layer is level
        const glm::dvec2 wanted = seen(camera, tip, side, side);
        glm::dvec2 sum(0.0);
        double weight = 0.0;
        for (int row = std::max(0, static_cast<int>(wanted.y) - 9); row < std::min(side, static_cast<int>(wanted.y) + 10); ++row)
            for (int column = std::max(0, static_cast<int>(wanted.x) - 9);
                 column < std::min(side, static_cast<int>(wanted.x) + 10); ++column)
                if (light.at(column, row, 1) - light.at(column, row, 2) > 0.6f * most) {
                    sum += glm::dvec2(column, row) + 0.5;
                    weight += 1.0;
                }
        if (weight < 1.0)
            continue;
        ++found;
        worst = std::max(worst, glm::length(sum / weight - wanted));
        least_lean = std::min(least_lean, static_cast<double>(glm::length(shift)));
        most_lean = std::max(most_lean, static_cast<double>(glm::length(shift)));
    }
    windrow::test::figure("shells/pixel_lean/least_m", least_lean);
    windrow::test::figure("shells/pixel_lean/most_m", most_lean);
    EXPECT_GE(windrow::test::figure("shells/pixel_lean/strands", found, 95), 95);
    EXPECT_GT(most_lean - least_lean, 0.01); // the wind is not even
    WINDROW_EXPECT_FIGURE("shells/pixel_lean/worst_pixels", worst, 1.0);
}

// A15: the pattern goes with the air to the pixel.
TEST(CoatWind, TheDriftIsTheShiftOfThePattern) {
    constexpr int side = 192;
    Stage stage({.width = side, .height = side});
    CoatSettings sky = bare_bones();
    sky.layers.shells = 12;
    sky.layers.length = 0.5f;
    sky.wind_share = 0.0f;
    sky.mirrored = sky.drifts = true;
    sky.wriggle_hz = 0.0f;
    sky.look.root = sky.look.tip = sky.look.second = {0.8f, 0.0f, 0.0f};
    sky.cloud.emplace();
    sky.cloud->size = 12.0f;
    sky.cloud->fading = 1.0f;
    sky.cloud->round_rim = false;
    Coat& cloud = stage.dress(square(200.0f), sky, at({}));
    const render::Camera camera = camera_at({0.0, 400.0, 4.0}, {0.0, 0.0, 0.0}, 10.0f);
    const auto mask = [&](glm::dvec2 metres) {
        cloud.drift(metres);
        stage.draw(camera);
        const render::PictureF light = stage.light();
        std::vector<int> made;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                made.push_back(light.at(column, row, 0) > 3.0f * light.at(column, row, 2) ? 1 : 0);
        return made;
    };
    const double pixel = on_level(camera, 97, 96, side, side, 0.0).x - on_level(camera, 96, 96, side, side, 0.0).x;
    // 600 s of a wind of 7 m/s and -3 m/s, and then 5 and 9 pixels more.
    const glm::dvec2 long_way(7.0 * 600.0, -3.0 * 600.0);
    const auto before = mask(long_way), after = mask(long_way + pixel * glm::dvec2(5.0, 9.0));
    int best = 1 << 30;
    glm::ivec2 best_shift(0);
    for (int down = 4; down <= 14; ++down)
        for (int right = 0; right <= 10; ++right) {
            int apart = 0;
            for (int row = 20; row < side - 20; ++row)
                for (int column = 20; column < side - 20; ++column)
                    apart += before[static_cast<std::size_t>((row - down) * side + column - right)] !=
                                     after[static_cast<std::size_t>(row * side + column)]
                                 ? 1
                                 : 0;
            if (apart < best) {
                best = apart;
                best_shift = {right, down};
            }
        }
    int filled = 0;
    for (const int each : before)
        filled += each;
    windrow::test::figure("shells/drift/filled", static_cast<double>(filled) / (side * side));
    EXPECT_GT(filled, side * side / 20);
    EXPECT_LT(filled, side * side * 19 / 20);
    windrow::test::figure("shells/drift/apart", static_cast<double>(best) / ((side - 40) * (side - 40)));
    WINDROW_EXPECT_FIGURE("shells/drift/pixels_off", std::max(std::abs(best_shift.x - 5), std::abs(best_shift.y - 9)), 1);
}

// [m] From the skin: told apart from the place, whose own rounding is 1e-7 m.
glm::dvec3 layer_offset(const Coat& coat, const CoatSkinBlock& skin, float h) {
    const auto shells = windrow::detail::shared(coat.block().shells);
    const glm::vec3 n(skin.normal);
    const WindrowCoatStrand strand = windrow_coat_strand(shells, n, skin.position.w, glm::vec3(skin.load), glm::vec3(skin.own),
                                                         glm::vec3(skin.lag), glm::vec3(skin.lag_more));
    return glm::dvec3((shells.form.x * h + shells.form.x * shells.form.z) * n + windrow_coat_shift(strand, h));
}
glm::dvec3 layer_place(const Coat& coat, const CoatSkinBlock& skin, float h) {
    return glm::dvec3(glm::vec3(skin.position)) + layer_offset(coat, skin, h);
}

// A body that jerks and turns: C10 and C13 on what the device makes of it.
TEST(CoatWind, LagNeitherEntersTheSkinNorCrossesLayers) {
    Stage stage({.ambient = {5.0f, 0.0f, 0.0f}, .gusts = 0.5f, .width = 32, .height = 32});
    CoatSettings settings = bare_bones();
    settings.layers.sag = 0.6f;
    settings.layers.length = 0.1f;
    settings.comb.bend = 0.8f;
    settings.inertia.emplace();
    Coat& coat = stage.dress(*globe_sphere({}), settings, at({}));
    double inward = 0.0, crossed = 0.0, most_lag = 0.0, longest = 0.0;
    double tip_before = 1e9;
    for (int frame = 0; frame < 24; ++frame) {
        windrow::Pose body = at({frame < 6 ? 0.25 * frame : 1.25, frame == 3 ? 0.5 : 0.0, 0.0});
        body.rotation = {0.0, std::sin(0.2 * std::min(frame, 8)), 0.0, std::cos(0.2 * std::min(frame, 8))};
        ASSERT_TRUE(coat.move(k_frame, body));
        stage.draw(camera_at({0.0, 0.3, 4.0}));
        double lag = 0.0;
        for (const CoatSkinBlock& skin : coat.skin()) {
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
        most_lag = std::max(most_lag, lag);
        if (frame > 12) { // the body rests: tips come after it
            EXPECT_LE(lag, tip_before + 1e-6);
            tip_before = lag;
        }
    }
    EXPECT_GT(windrow::test::figure("shells/lag/most_m", most_lag), 0.1);
    WINDROW_EXPECT_FIGURE("shells/lag/inward", inward, 1e-6);
    WINDROW_EXPECT_FIGURE("shells/lag/crossed", crossed, 1e-5);
    WINDROW_EXPECT_FIGURE("shells/lag/stretched", longest - 1.0, 0.01); // C3: strands keep their length within 1 %
}

// Motion vectors of an outermost layer that is closed, against its vertices' projected places in this frame and the last.
TEST(CoatWind, MotionIsTheDifferenceOfProjectedPlaces) {
    constexpr int side = 256;
    Stage stage({.ambient = {5.0f, 0.0f, 1.0f}, .gusts = 0.6f, .width = side, .height = side});
    CoatSettings settings = bare_bones();
    settings.layers.shells = 2;
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
            last.assign(coat.skin().begin(), coat.skin().end());
        ASSERT_TRUE(coat.move(k_frame, pose(frame)));
        stage.draw(camera(frame));
    }
    const render::PictureF motion = stage.renderer->images().motion_picture();
    double worst = 0.0, most = 0.0, of_wind = 0.0;
    int compared = 0;
    for (std::size_t n = 0; n < last.size(); ++n) {
        const CoatSkinBlock& skin = coat.skin()[n];
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
    windrow::test::figure("shells/motion/compared", compared);
    EXPECT_GT(compared, 60);
    EXPECT_GT(windrow::test::figure("shells/motion/of_wind_rad", of_wind), 1e-4);
    windrow::test::figure("shells/motion/most_px", most);
    // A pixel's middle lies up to 0.7 px from the vertex, where the motion is another: a twentieth of the largest.
    WINDROW_EXPECT_FIGURE("shells/motion/apart_px", worst, 0.05 * most);
}

} // namespace
} // namespace shells::test
