// What is seen between layers: gaps at grazing view and at the silhouette against a coat of very many layers, with the fragments'
// walk between layers and without; what layers cost in fragments.
#include "tests/figure.h"
#include "tests/tier.h"
#include "vegetation/tests/fur/stage.h"

#include <cmath>
#include <cstdio>

namespace windrow::vegetation::fur::test {
namespace {

constexpr int k_side = 96, k_ring = 160; // [pixels]

// Red skin and green strands: a pixel tells which it shows.
CoatSettings marked(int shells, int march) {
    CoatSettings coat;
    coat.layers.shells = shells;
    coat.layers.length = 0.06f;
    coat.layers.sag = 0.0f;
    coat.wind_fraction = 0.0f;
    coat.strands = {.density = 60.0f, .low = 0.6f, .high = 1.0f, .thickness = 0.8f};
    coat.look.root = {0.8f, 0.0f, 0.0f};
    coat.look.tip = coat.look.second = {0.0f, 0.8f, 0.0f};
    coat.look.tip_power = 1e-3f; // root's colour at the skin alone
    coat.look.occlusion = coat.look.gloss = coat.look.sheen = 0.0f;
    coat.levels.march = march;
    coat.levels.shadow_shells = 0;
    coat.levels.full_until = 1e4f;
    return coat;
}

// Shares of the skin's pixels through which the skin is seen.
double skin_fraction(Stage& stage, const render::Camera& camera) {
    stage.draw(camera);
    const render::PictureF light = stage.light();
    int skin = 0, all = 0;
    for (int row = 0; row < k_side; ++row)
        for (int column = 0; column < k_side; ++column) {
            const glm::vec3 got = radiance(light, column, row);
            const bool is_skin = got.r > 10.0f * got.g, is_strand = got.g > 10.0f * got.r;
            skin += is_skin ? 1 : 0;
            all += is_skin || is_strand ? 1 : 0;
        }
    return all > 0 ? static_cast<double>(skin) / all : -1.0;
}

TEST(CoatGaps, TheWalkBetweenLayersClosesGapsOfAPlane) {
    for (const double deg : {5.0, 15.0, 45.0}) {
        if (!windrow::test::whole_sweeps() && deg > 5.0) // the flattest look, where gaps are widest
            continue;
        const double angle = deg * 3.14159265358979 / 180.0;
        // Only the middle of a wide square: no rim is in sight.
        const render::Camera camera =
            camera_at({0.0, 1.5 * std::sin(angle), 1.5 * std::cos(angle)}, {0.0, 0.0, 0.0}, deg < 10.0 ? 4.0f : 10.0f);
        const auto share = [&](int shells, int march) {
            Stage stage({.width = k_side, .height = k_side});
            stage.dress(square(4.0f), marked(shells, march), at({}));
            return skin_fraction(stage, camera);
        };
        const double truth = share(256, 0);
        const std::string name = "shells/gaps/plane/" + std::to_string(static_cast<int>(deg));
        windrow::test::figure(name + "/truth", truth);
        ASSERT_GE(truth, 0.0);
        for (const int shells : {16, 32}) {
            const double before = share(shells, 0), after = share(shells, 8);
            const std::string of = name + "/" + std::to_string(shells);
            windrow::test::figure(of + "/before", before);
            windrow::test::figure(of + "/after", after);
            EXPECT_LT(after, before) << of;
            EXPECT_LT(std::abs(after - truth), std::abs(before - truth)) << of;
        }
    }
}

// A ring of pixels between the skin's rim and the tips': how many are open, against the truth.
TEST(CoatGaps, TheWalkBetweenLayersClosesTheSilhouette) {
    const render::Camera camera = camera_at({0.0, 0.0, 3.0}, {0.0, 0.0, 0.0}, 22.0f);
    const double radius = 0.45;
    const auto open_fraction = [&](int shells, int march) {
        Stage stage({.width = k_ring, .height = k_ring});
        CoatSettings settings = marked(shells, march);
        stage.dress(*globe_sphere({.radius = static_cast<float>(radius), .sectors = 40, .stacks = 30}), settings, at({}));
        stage.draw(camera);
        const render::PictureF light = stage.light();
        const double pixels = 0.5 * k_ring / std::tan(0.5 * 22.0 * 3.14159265358979 / 180.0); // of a tangent of 1
        const auto rim = [&](double r) { return pixels * std::tan(std::asin(r / 3.0)); };
        const double low = rim(radius) + 1.0, high = rim(radius + 0.6 * 0.06);
        int open = 0, all = 0;
        for (int row = 0; row < k_ring; ++row)
            for (int column = 0; column < k_ring; ++column) {
                const double from_middle = std::hypot(column + 0.5 - 0.5 * k_ring, row + 0.5 - 0.5 * k_ring);
                if (from_middle < low || from_middle > high)
                    continue;
                const glm::vec3 got = radiance(light, column, row);
                open += got.b > 0.2f * got.g ? 1 : 0; // the sky has blue
                ++all;
            }
        return static_cast<double>(open) / all;
    };
    const double truth = open_fraction(256, 0);
    windrow::test::figure("shells/gaps/rim/truth", truth);
    for (const int shells : {16, 32}) {
        const double before = open_fraction(shells, 0), after = open_fraction(shells, 8);
        const std::string of = "shells/gaps/rim/" + std::to_string(shells);
        windrow::test::figure(of + "/before", before);
        windrow::test::figure(of + "/after", after);
        EXPECT_LT(after, before) << of;
        EXPECT_LT(std::abs(after - truth), std::abs(before - truth)) << of;
    }
}

TEST(CoatCost, FragmentsAPixelGrowEvenlyWithLayers) {
    const render::Camera camera = camera_at({0.0, 0.0, 3.0}, {0.0, 0.0, 0.0}, 22.0f);
    std::vector<glm::dvec2> points;
    bool counts = true;
    for (const int shells : {8, 16, 32, 64, 128, 256}) {
        Stage stage({.width = 32, .height = 32});
        stage.dress(*globe_sphere({.sectors = 13, .stacks = 10}), marked(shells, 0), at({}));
        stage.draw(camera);
        counts = stage.renderer->counter()->counts();
        points.emplace_back(shells, static_cast<double>(stage.counted.fragments) / (32.0 * 32.0));
        windrow::test::figure("shells/fragments_a_pixel/" + std::to_string(shells), points.back().y);
    }
    if (!counts)
        GTEST_SKIP() << "the device has no pipeline statistics";
    // Least squares, and what they leave.
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const glm::dvec2& p : points) {
        n += 1.0;
        x += p.x;
        y += p.y;
        xx += p.x * p.x;
        xy += p.x * p.y;
    }
    const double slope = (n * xy - x * y) / (n * xx - x * x), base = (y - slope * x) / n;
    double worst = 0.0;
    for (const glm::dvec2& p : points)
        worst = std::max(worst, std::abs(p.y - base - slope * p.x));
    windrow::test::figure("shells/fragments_a_pixel/slope", slope);
    windrow::test::figure("shells/fragments_a_pixel/base", base);
    WINDROW_EXPECT_FIGURE("shells/fragments_a_pixel/residual", worst / points.back().y, 0.05); // of the most: a line
}

TEST(CoatCost, TheOrderOfLayersAndADepthPass) {
    const render::Camera camera = camera_at({0.0, 0.0, 3.0}, {0.0, 0.0, 0.0}, 22.0f);
    std::vector<std::vector<float>> pictures;
    for (int way = 0; way < 3; ++way) {
        Stage stage({.width = 96, .height = 96});
        CoatSettings settings = marked(24, 4);
        settings.levels.outer_first = way != 1;
        settings.levels.depth_first = way == 2;
        stage.dress(*globe_sphere({}), settings, at({}));
        stage.draw(camera);
        const char* const names[] = {"outer_first", "inner_first", "depth_first"};
        windrow::test::figure(std::string("shells/fragments/") + names[way],
                              static_cast<double>(stage.counted.fragments) / (96.0 * 96.0));
        pictures.push_back(stage.light().values);
    }
    // The order changes what it costs, not what is seen: depth decides.
    int apart = 0;
    for (std::size_t n = 0; n < pictures[0].size(); ++n)
        apart += pictures[0][n] != pictures[1][n] || pictures[0][n] != pictures[2][n] ? 1 : 0;
    WINDROW_EXPECT_FIGURE("shells/order/values_apart", apart, 0);
}

} // namespace
} // namespace windrow::vegetation::fur::test
