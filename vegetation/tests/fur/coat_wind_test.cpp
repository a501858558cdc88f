// Coats in the wind as drawn: strands that lean one by one on a square of four vertices, drift.
#include "tests/figure.h"
#include "vegetation/tests/fur/coat_numerics.h"
#include "vegetation/tests/fur/stage.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::fur::test {
namespace {

using namespace numerics;

// Local wind on a coarse mesh: the tips of 10 x 10 thin strands on four vertices, against the wind at the vertices of a fine mesh
// at their roots.
TEST(CoatWind, StrandsLeanOneByOneOnFourVertices) {
    constexpr int side = 320, rows = 10;
    constexpr float size = 4.0f, length = 0.3f;
    Stage stage({.ambient = {6.0f, 0.0f, 2.0f}, .gusts = 0.7f, .width = side, .height = side});
    CoatSettings thin = bare_bones();
    thin.layers.length = length;
    thin.layers.shells = 10;
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
    for (int n = 0; n < 2; ++n)
        stage.draw(camera);
    const render::PictureF light = stage.light();
    float most = 0.0f;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            most = std::max(most, light.at(column, row, 1) - light.at(column, row, 2));
    double worst = 0.0, min_lean = 1e9, max_lean = 0.0;
    int found = 0;
    const auto shells = windrow::detail::shared(reference.block().shells);
    for (const CoatSkinBlock& root : engine::must(reference.skin())) {
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
        min_lean = std::min(min_lean, static_cast<double>(glm::length(shift)));
        max_lean = std::max(max_lean, static_cast<double>(glm::length(shift)));
    }
    windrow::test::figure("shells/pixel_lean/min_m", min_lean);
    windrow::test::figure("shells/pixel_lean/max_m", max_lean);
    EXPECT_GE(windrow::test::figure("shells/pixel_lean/strands", found, 95), 95);
    EXPECT_GT(max_lean - min_lean, 0.01); // the wind is not even
    WINDROW_EXPECT_FIGURE("shells/pixel_lean/worst_pixels", worst, 1.0);
}

// The pattern of clouds drifts by wind times time, to the pixel.
TEST(CoatWind, TheDriftIsTheShiftOfThePattern) {
    constexpr int side = 192;
    Stage stage({.width = side, .height = side});
    CoatSettings sky = bare_bones();
    sky.layers.shells = 12;
    sky.layers.length = 0.5f;
    sky.wind_fraction = 0.0f;
    sky.mirrored = sky.drifts = true;
    sky.wriggle_hz = 0.0f;
    sky.look.root = sky.look.tip = sky.look.second = {0.8f, 0.0f, 0.0f};
    sky.cloud.emplace();
    sky.cloud->size = 12.0f;
    sky.cloud->soft = 0.0f; // a soft edge chooses samples by the pixel, not by the place that drifts
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
                made.push_back(light.at(column, row, 0) > 100.0f * light.at(column, row, 1) ? 1 : 0);
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
    WINDROW_EXPECT_FIGURE("shells/drift/apart", static_cast<double>(best) / ((side - 40) * (side - 40)),
                          0.02); // rims that a pixel\'s middle just misses
    WINDROW_EXPECT_FIGURE("shells/drift/pixels_off", std::max(std::abs(best_shift.x - 5), std::abs(best_shift.y - 9)), 1);
}

// In an even wind it is all one where strands ask for it.
TEST(CoatWind, LayersThatAskTheWindThemselvesAgreeWhereItIsEven) {
    constexpr int side = 96;
    std::vector<std::vector<float>> pictures;
    for (const WindAt where : {WindAt::strand, WindAt::shell}) {
        Stage stage({.ambient = {7.0f, 0.0f, 2.0f}, .width = side, .height = side});
        CoatSettings settings = bare_bones();
        settings.layers.shells = 12;
        settings.layers.length = 0.1f;
        settings.strands.density = 60.0f;
        settings.wind_at = where;
        stage.dress(*globe_sphere({}), settings, at({0.0, 1.0, 0.0}));
        stage.draw(camera_at({0.0, 1.3, 3.0}, {0.0, 1.0, 0.0}));
        pictures.push_back(stage.light().values);
    }
    int apart = 0;
    for (std::size_t n = 0; n < pictures[0].size(); ++n)
        apart += std::abs(pictures[0][n] - pictures[1][n]) > 0.02f ? 1 : 0;
    // Rounding of the wind's samples moves a strand's rim by a pixel's share here and there.
    WINDROW_EXPECT_FIGURE("shells/wind_at_shell/apart", static_cast<double>(apart) / static_cast<double>(pictures[0].size()),
                          0.02);
}

} // namespace
} // namespace windrow::vegetation::fur::test
