// Light on a leaf and from the sky, on the CPU: the text that the shaders include.
#include "tests/figure.h"
#include "vegetation/render/frame_block.h"
#include "vegetation/render/light_numerics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace windrow::vegetation::render {
namespace {

using namespace numerics;

constexpr double k_pi = 3.14159265358979;

float largest(glm::vec3 v) {
    return std::max({v.x, v.y, v.z});
}

// Middles of cells of equal solid angle.
std::vector<glm::vec3> even_directions(int rows, int columns) {
    std::vector<glm::vec3> made;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double mu = -1.0 + 2.0 * (row + 0.5) / rows, across = std::sqrt(1.0 - mu * mu),
                         turn = 2.0 * k_pi * (column + 0.5) / columns;
            made.emplace_back(across * std::cos(turn), mu, across * std::sin(turn));
        }
    return made;
}

WindrowSky shared(const SkyBlock& sky) {
    return {sky.sun, sky.rayleigh, sky.haze};
}

TEST(LeafLight, HalfLambertIsASmoothSquareThatReachesTheFarSide) {
    double worst = 0.0;
    for (int n = -100; n <= 100; ++n) {
        const double cosine = n / 100.0;
        const double reference = 0.25 * (1.0 + cosine) * (1.0 + cosine);
        worst = std::max(worst, std::abs(static_cast<double>(windrow_half_lambert(static_cast<float>(cosine))) - reference));
    }
    WINDROW_EXPECT_FIGURE("render/light/half_lambert", worst, 1e-6); // float rounding; a picture has 1/255
    // Clamped before it is squared the far side would be an even 0.25.
    EXPECT_EQ(windrow_half_lambert(-1.0f), 0.0f);
    EXPECT_LT(windrow_half_lambert(-0.5f), 0.1f);
}

// Leaves of all directions together give less than they get: both sides, all terms, the brightest look that `validate` lets pass.
TEST(LeafLight, LeavesGiveNoMoreThanTheyGet) {
    const float against = PlantLook{}.against_light;
    const float each = 0.6f / (2.0f + 0.1f * against);
    const std::vector<glm::vec3> directions = even_directions(24, 48);
    const glm::vec3 to_sun(0.0f, 1.0f, 0.0f);
    for (const float gloss : {1.0f, 24.0f, 100.0f}) {
        double given = 0.0, got = 0.0;
        for (const glm::vec3& leaf : directions) {
            got += std::abs(static_cast<double>(glm::dot(leaf, to_sun)));
            for (const glm::vec3& to_eye : directions) {
                const glm::vec3 normal = glm::dot(leaf, to_eye) < 0.0f ? -leaf : leaf; // on the side that is seen
                const float cosine = glm::dot(normal, to_sun);
                const float diffuse =
                    windrow_half_lambert(cosine) + windrow_leaf_through(cosine, -glm::dot(to_eye, to_sun), against);
                const float radiance = 0.318309886f * each * diffuse + windrow_gloss(normal, to_sun, to_eye, gloss);
                given += static_cast<double>(radiance * glm::dot(normal, to_eye));
            }
        }
        given *= 4.0 * k_pi / static_cast<double>(directions.size());
        WINDROW_EXPECT_FIGURE("render/light/given_over_got_" + std::to_string(static_cast<int>(gloss)), given / got, 1.0);
    }
}

TEST(LeafLight, AroundIsExactForAnEvenSkyAndGround) {
    // The irradiance of a face under an even sky of radiance 1 / pi over black ground is (1 + n.y) / 2.
    for (const float up : {-1.0f, -0.3f, 0.0f, 0.6f, 1.0f}) {
        const glm::vec3 normal(std::sqrt(1.0f - up * up), up, 0.0f);
        double sum = 0.0;
        const std::vector<glm::vec3> directions = even_directions(200, 400);
        for (const glm::vec3& direction : directions)
            if (direction.y > 0.0f)
                sum += std::max(0.0, static_cast<double>(glm::dot(direction, normal))) / k_pi;
        sum *= 4.0 * k_pi / static_cast<double>(directions.size());
        const double around = k_pi * static_cast<double>(windrow_around(normal, glm::vec3(1.0f), glm::vec3(0.0f)).x);
        WINDROW_EXPECT_FIGURE("render/light/around", std::abs(around - sum), 2e-4); // the sum's own error: 80,000 directions
    }
}

TEST(LeafLight, GlossIsGivenOnTheLitSideOnlyAndNeverIsNotFinite) {
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    EXPECT_EQ(windrow_gloss(up, -up, up, 24.0f), 0.0f);
    EXPECT_EQ(windrow_gloss(up, up, -up, 24.0f), 0.0f); // half way between the two is nowhere
    EXPECT_TRUE(std::isfinite(windrow_gloss(up, up, up, 1000.0f)));
    EXPECT_GT(windrow_gloss(up, up, up, 24.0f), windrow_gloss(up, up, glm::normalize(glm::vec3(1.0f, 1.0f, 0.0f)), 24.0f));
}

TEST(Sky, TheAirSendsDownNoMoreThanTheBeamLost) {
    double worst = 0.0;
    for (const float elevation : {2.0f, 5.0f, 10.0f, 26.0f, 45.0f, 70.0f, 90.0f})
        for (const float haze : {0.0f, 0.06f, 0.2f, 0.5f}) {
            const SkyBlock sky = sky_block({.elevation_deg = elevation, .irradiance = 1.0f, .haze = haze});
            const glm::vec3 down = sky_irradiance(sky), beam = sun_irradiance(sky);
            for (int channel = 0; channel < 3; ++channel)
                worst = std::max(worst, static_cast<double>(down[channel] / ((1.0f - beam[channel]) * sky.sun.y)));
        }
    WINDROW_EXPECT_FIGURE("render/sky/down_over_lost", worst, 1.0);
}

TEST(Sky, IsBlueAboveAndPaleBelowAndTheLowSunIsRed) {
    const SkyBlock sky = sky_block({.elevation_deg = 40.0f});
    const glm::vec3 above = windrow_sky_radiance(shared(sky), glm::vec3(0.0f, 1.0f, 0.0f));
    const glm::vec3 away = glm::normalize(glm::vec3(-sky.sun.x, 0.0f, -sky.sun.z));
    const glm::vec3 level = windrow_sky_radiance(shared(sky), away);
    EXPECT_GT(above.b / above.r, 2.0f); // a clear zenith is two to four times as bright at 0.44 as at 0.68 um
    EXPECT_LT(level.b / level.r, 0.7f * above.b / above.r);
    EXPECT_GT(level.g, above.g);
    const glm::vec3 low = sun_irradiance(sky_block({.elevation_deg = 3.0f}));
    EXPECT_GT(low.r / low.b, 5.0f);
}

// The quotient's limit where the air mass of sight and sun agree leaves no seam.
TEST(Sky, IsSmoothWhereSightAndSunHaveOneAirMass) {
    const SkyBlock sky = sky_block({.elevation_deg = 30.0f});
    double worst = 0.0;
    for (int n = -200; n < 200; ++n) {
        const auto at = [&](double offset) {
            const double up = 0.5235987756 + offset * 1e-5;
            const glm::vec3 direction(-std::cos(up), std::sin(up), 0.0);
            return windrow_sky_radiance(shared(sky), direction);
        };
        worst = std::max(worst, static_cast<double>(largest(glm::abs(at(n + 1) - at(n)))));
    }
    WINDROW_EXPECT_FIGURE("render/sky/step", worst, 2e-4); // of about 1: 1e-5 rad of slope and float's rounding of the quotient
}

TEST(Sky, TheDisksLightIsTheBeams) {
    const SkyBlock sky = sky_block({.elevation_deg = 50.0f});
    const glm::vec3 to_sun(sky.sun);
    const glm::vec3 one = glm::normalize(glm::cross(to_sun, glm::vec3(0.0f, 1.0f, 0.0f))), other = glm::cross(to_sun, one);
    constexpr int side = 400;
    const float width = 2.2f * sky.sun.w / side;
    double sum = 0.0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const float x = (static_cast<float>(column) - 0.5f * side + 0.5f) * width,
                        y = (static_cast<float>(row) - 0.5f * side + 0.5f) * width;
            const glm::vec3 direction = glm::normalize(to_sun + x * one + y * other);
            sum += static_cast<double>(windrow_sun_radiance(shared(sky), direction).g) * static_cast<double>(width * width);
        }
    const double beam = static_cast<double>(sun_irradiance(sky).g);
    WINDROW_EXPECT_FIGURE("render/sky/disk", std::abs(sum / beam - 1.0), 5e-3); // 400 x 400 cells over an edge
}

} // namespace
} // namespace windrow::vegetation::render
