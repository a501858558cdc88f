// Colour, occlusion, light, normals and noise pairs of strands, against references of their own in double.
#include "tests/fields.h"
#include "tests/figure.h"
#include "vegetation/fur/strand_field.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {
namespace {

using windrow::test::Random;

constexpr double k_level = 1.0 / 255.0;

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

TEST(StrandLight, OcclusionIsItsFormula) {
    double off = 0.0, falls = 0.0;
    for (const double a : {0.0, 0.27, 1.0, 5.0})
        for (const double b : {0.0, 0.15, 1.0}) {
            double last = 0.0;
            for (int n = 0; n <= 256; ++n) {
                const double h = n / 256.0;
                const double expected = std::clamp((a > 0.0 ? std::pow(h, a) : 1.0) + b, 0.0, 1.0);
                const double o = static_cast<double>(
                    numerics::windrow_strand_occlusion(static_cast<float>(h), static_cast<float>(a), static_cast<float>(b)));
                off = std::max(off, std::abs(o - expected));
                falls = std::max(falls, last - o);
                last = o;
            }
        }
    WINDROW_EXPECT_FIGURE("shells/light/occlusion_off", off, k_level);
    WINDROW_EXPECT_FIGURE("shells/light/occlusion_falls_toward_the_tip", falls, 0.0);
}

TEST(StrandLight, ColourIsItsFormula) {
    Random random(1);
    double off = 0.0, least = 2.0, most = 0.0, sum = 0.0;
    for (int n = 0; n < 20'000; ++n) {
        const auto colour = [&] {
            return glm::vec3(random.uniform(0.0f, 1.0f), random.uniform(0.0f, 1.0f), random.uniform(0.0f, 1.0f));
        };
        const glm::vec3 root = colour(), tip = colour(), second = colour();
        const float t = random.uniform(0.0f, 1.0f), share = random.uniform(0.0f, 1.0f),
                    power = n % 2 == 0 ? 3.0f : random.uniform(0.2f, 5.0f);
        const float tone = numerics::windrow_strand_tone({random.bits(), random.bits()}, 0.3f);
        const glm::dvec3 tips =
            (1.0 - static_cast<double>(share)) * glm::dvec3(tip) + static_cast<double>(share) * glm::dvec3(second);
        const double weight = std::pow(static_cast<double>(t), static_cast<double>(power));
        const glm::dvec3 expected = static_cast<double>(tone) * ((1.0 - weight) * glm::dvec3(root) + weight * tips);
        const glm::dvec3 apart =
            glm::abs(glm::dvec3(numerics::windrow_strand_colour(root, tip, second, share, t, power, tone)) - expected);
        off = std::max({off, apart.x, apart.y, apart.z});
        least = std::min(least, static_cast<double>(tone));
        most = std::max(most, static_cast<double>(tone));
        sum += static_cast<double>(tone);
    }
    WINDROW_EXPECT_FIGURE("shells/light/colour_off", off, k_level);
    // Tones are even between 1 - spread and 1 + spread.
    EXPECT_NEAR(windrow::test::figure("shells/light/min_tone", least), 0.7, 0.002);
    EXPECT_NEAR(windrow::test::figure("shells/light/largest_tone", most), 1.3, 0.002);
    EXPECT_NEAR(windrow::test::figure("shells/light/mean_tone", sum / 20'000), 1.0, 0.006);
}

// The tone of a strand is independent of its length.
TEST(StrandLight, TonesFollowNoLengths) {
    double both = 0.0;
    constexpr int k_count = 100'000;
    for (int n = 0; n < k_count; ++n) {
        const glm::uvec2 key = numerics::windrow_strand_key(0u, {n % 317, n / 317});
        const double tone = static_cast<double>(numerics::windrow_strand_tone(key, 1.0f)) - 1.0;
        both += tone * (2.0 * static_cast<double>(numerics::windrow_strand_chance(key)) - 1.0);
    }
    WINDROW_EXPECT_FIGURE("shells/light/tone_length_correlation", std::abs(3.0 * both / k_count), 0.0125); // four standard errors
}

TEST(StrandLight, PatchesHaveBothColours) {
    Random random(2);
    double sum = 0.0;
    int pure = 0;
    for (int n = 0; n < 50'000; ++n) {
        const double share = static_cast<double>(numerics::windrow_strand_patch(1u, random.vector(50.0f)));
        sum += share;
        pure += share < 0.1 || share > 0.9;
    }
    EXPECT_NEAR(windrow::test::figure("shells/light/mean_patch", sum / 50'000), 0.5, 0.02);
    EXPECT_GT(windrow::test::figure("shells/light/pure_fraction", pure / 50'000.0), 0.3);
}

// Half-Lambert and Blinn-Phong light on a sphere, for every normal and light.
TEST(StrandLight, LitSphereIsItsFormula) {
    Random random(3);
    double wrapped_off = 0.0, gloss_off = 0.0, sheen_off = 0.0, through_off = 0.0;
    for (int n = 0; n < 50'000; ++n) {
        const glm::dvec3 normal = random.direction(), light = random.direction(), eye = random.direction();
        const double cosine = glm::dot(normal, light);
        const double half_lambert = 0.25 * (cosine + 1.0) * (cosine + 1.0);
        for (const double wrap : {0.0, 0.6, 1.0})
            wrapped_off = std::max(
                wrapped_off,
                std::abs(static_cast<double>(numerics::windrow_wrapped(static_cast<float>(cosine), static_cast<float>(wrap))) -
                         ((1.0 - wrap) * std::max(cosine, 0.0) + wrap * half_lambert)));
        const glm::dvec3 half_way = glm::normalize(light + eye);
        const glm::vec3 found = numerics::windrow_half_way(glm::vec3(light), glm::vec3(eye), glm::vec3(normal));
        for (const double power : {1.0, 24.0, 200.0}) {
            gloss_off = std::max(
                gloss_off,
                std::abs(static_cast<double>(numerics::windrow_plain_gloss(glm::vec3(normal), found, static_cast<float>(power))) -
                         std::pow(std::max(glm::dot(normal, half_way), 0.0), power)));
            const double sine = glm::length(glm::cross(normal, half_way));
            sheen_off = std::max(
                sheen_off,
                std::abs(static_cast<double>(numerics::windrow_hair_sheen(glm::vec3(normal), found, static_cast<float>(power))) -
                         std::pow(sine, power)));
        }
        const double t = random.real(0.0, 1.0), against = -glm::dot(light, eye);
        through_off = std::max(
            through_off,
            std::abs(static_cast<double>(numerics::windrow_tips_through(static_cast<float>(t), static_cast<float>(against))) -
                     t * t * std::pow(std::max(against, 0.0), 4.0)));
    }
    WINDROW_EXPECT_FIGURE("shells/light/wrapped_off", wrapped_off, k_level);
    WINDROW_EXPECT_FIGURE("shells/light/gloss_off", gloss_off, k_level);
    WINDROW_EXPECT_FIGURE("shells/light/sheen_off", sheen_off, k_level);
    WINDROW_EXPECT_FIGURE("shells/light/through_off", through_off, k_level);
    // The back falls smoothly to 0: 000 clamps first and leaves an even quarter there.
    double rises = 0.0, last = 1.0;
    for (int n = 0; n <= 180; ++n) {
        const double light =
            static_cast<double>(numerics::windrow_wrapped(static_cast<float>(std::cos(n * std::numbers::pi / 180.0)), 1.0f));
        rises = std::max(rises, light - last);
        last = light;
    }
    WINDROW_EXPECT_FIGURE("shells/light/back_of_the_sphere", last, 1e-6);
    WINDROW_EXPECT_FIGURE("shells/light/rises_toward_the_back", rises, 0.0);
}

// Normals of strands as drawn, against the analytic normals of cones. Fur of 3 cells' height, jittered.
TEST(StrandLight, SlopedNormalsAreThoseOfCones) {
    const StrandFieldSettings settings{.density = 1.0f, .low = 0.5f, .thickness = 0.9f};
    const StrandFieldBlock field = block(settings);
    constexpr double k_high = 3.0;       // [cells] length of the coat
    const glm::vec3 n(0.0f, 0.0f, 1.0f); // u and v lie across it
    for (const float t : {0.2f, 0.35f, 0.5f, 0.65f, 0.8f}) {
        Random random(4);
        std::vector<double> sloped, blended;
        for (int k = 0; k < 20'000; ++k) {
            const glm::vec2 q(random.uniform(-20.0f, 20.0f), random.uniform(-20.0f, 20.0f));
            const StrandHit at_root = strand_at(field, q, 0.0f);
            const float h = t * at_root.reach; // the fraction t of its own length
            const StrandHit hit = strand_at(field, q, h);
            if (hit.inside <= 0.0f || hit.key != at_root.key)
                continue;
            // A cone about its root: radius T/2 R at the skin, 0 at R * k_high above it.
            const glm::dvec2 d = glm::dvec2(q) - glm::dvec2(hit.root);
            const glm::dvec3 cone =
                glm::normalize(glm::dvec3(glm::normalize(d), 0.5 * static_cast<double>(settings.thickness) / k_high));
            const glm::vec3 g = numerics::windrow_strand_gradient(hit.outward, hit.facet, n, 0.0f);
            const float slope = numerics::windrow_strand_slope(field, h, hit.reach) / static_cast<float>(k_high);
            const auto angle = [&](glm::vec3 normal) {
                return glm::degrees(std::acos(std::clamp(glm::dot(glm::dvec3(normal), cone), -1.0, 1.0)));
            };
            sloped.push_back(angle(numerics::windrow_strand_sloped(g, n, slope)));
            blended.push_back(angle(numerics::windrow_strand_blended(g, n, t)));
        }
        const std::string at = std::to_string(t).substr(0, 4);
        WINDROW_EXPECT_FIGURE("shells/light/normal_at_" + at + "/median_deg", median(sloped), 10.0);
        // What the sources' blend gives, which turns up toward the tip by design: stated, not bounded.
        windrow::test::figure("shells/light/normal_at_" + at + "/blended_median_deg", median(blended));
    }
}

// The slope equals differences of `inside` over h, for each profile.
TEST(StrandLight, SlopesAreThoseOfTheField) {
    struct StrandsInLight {
        const char* name;
        StrandFieldSettings settings;
    };
    for (const StrandsInLight& kind : {StrandsInLight{"cone", {.density = 1.0f, .jitter = 0.0f, .low = 0.8f, .high = 0.8f}},
                                       StrandsInLight{"centre",
                                                      {.density = 1.0f,
                                                      .jitter = 0.0f,
                                                      .low = 0.8f,
                                                      .high = 0.8f,
                                                      .profile = StrandProfile::centre,
                                                      .cut_exponent = 1.5f}},
                                       StrandsInLight{"edge",
                                                      {.density = 1.0f,
                                                      .jitter = 0.0f,
                                                      .low = 0.8f,
                                                      .high = 0.8f,
                                                      .profile = StrandProfile::edge,
                                                      .cut_min = 0.05f,
                                                      .cut_max = 0.4f}}}) {
        const StrandFieldBlock field = block(kind.settings);
        double off = 0.0;
        for (int n = 1; n < 14; ++n) {
            const float h = 0.05f * static_cast<float>(n);
            constexpr float k_apart = 1.0f / 256.0f;
            const double difference = (static_cast<double>(strand_at(field, {0.6f, 0.5f}, h - k_apart).inside) -
                                       static_cast<double>(strand_at(field, {0.6f, 0.5f}, h + k_apart).inside)) /
                                      (2.0 * k_apart);
            const double slope = static_cast<double>(numerics::windrow_strand_slope(field, h, 0.8f));
            off = std::max(off, std::abs(slope / difference - 1.0));
        }
        WINDROW_EXPECT_FIGURE(std::string("shells/light/slope_off/") + kind.name, off,
                              0.01); // second order in 1/256, steep near tips
    }
}

TEST(StrandLight, SquareNormalsPointAwayFromTheEdge) {
    const glm::vec3 n = glm::normalize(glm::vec3(0.2f, 0.1f, 1.0f));
    Random random(5);
    double off = 0.0, across = 0.0;
    for (int k = 0; k < 2000; ++k) {
        const glm::vec3 outward = random.vector(0.4f), facet(glm::vec3(random.direction()));
        const glm::vec3 square = numerics::windrow_strand_gradient(outward, facet, n, 1.0f);
        const glm::dvec3 expected =
            glm::normalize(glm::dvec3(facet) - glm::dot(glm::dvec3(facet), glm::dvec3(n)) * glm::dvec3(n));
        off = std::max(off, glm::length(glm::dvec3(square) - expected));
        across = std::max(across,
                          static_cast<double>(std::abs(glm::dot(numerics::windrow_strand_gradient(outward, facet, n, 0.5f), n))));
    }
    WINDROW_EXPECT_FIGURE("shells/light/square_off", off, 1e-4); // facets nearly along n lose digits
    WINDROW_EXPECT_FIGURE("shells/light/gradient_along_n", across, 1e-4);
    EXPECT_EQ(numerics::windrow_strand_gradient(glm::vec3(0.0f), glm::vec3(0.0f), n, 0.0f), glm::vec3(0.0f));
    EXPECT_EQ(numerics::windrow_strand_blended(glm::vec3(0.0f), n, 0.0f), n);
}

TEST(StrandLight, NoisePairsAreTheirFormula) {
    Random random(6);
    for (int k = 0; k < 2000; ++k) {
        const float first = static_cast<float>(random.integer(0, 255)) / 255.0f,
                    second = static_cast<float>(random.integer(0, 255)) / 255.0f;
        EXPECT_EQ(numerics::windrow_noise_pair(first, second, 0.0f, 0.0f), 1.0f); // no effect at all
        EXPECT_EQ(numerics::windrow_noise_pair(first, second, 1.0f, 0.0f), 1.0f - (1.0f - first));
        const float a = random.uniform(0.0f, 1.0f), b = random.uniform(0.0f, 1.0f);
        EXPECT_EQ(numerics::windrow_noise_pair(first, second, a, b),
                  numerics::windrow_noise_pair(first, 0.5f, a, 0.0f) * numerics::windrow_noise_pair(second, 0.5f, b, 0.0f));
    }
}

TEST(StrandLight, CelStepsHaveTheirLevels) {
    double jump = 0.0, falls = 0.0, off = 0.0;
    for (const float levels : {1.0f, 3.0f, 8.0f}) {
        float last = 0.0f;
        for (int n = 0; n <= 100'000; ++n) {
            const float light = static_cast<float>(n) / 100'000.0f, now = numerics::windrow_cel(light, levels, 0.2f);
            jump = std::max(jump, static_cast<double>(now - last));
            falls = std::max(falls, static_cast<double>(last - now));
            last = now;
        }
        for (float k = 0.0f; k <= levels; ++k) // flat in the middle of a level
            off = std::max(off,
                           static_cast<double>(std::abs(numerics::windrow_cel((k + 0.2f) / levels, levels, 0.2f) - k / levels)));
    }
    WINDROW_EXPECT_FIGURE("shells/light/cel_level_off", off, 1e-6);
    WINDROW_EXPECT_FIGURE("shells/light/cel_falls", falls, 0.0);
    WINDROW_EXPECT_FIGURE("shells/light/cel_jump", jump,
                          1e-5 * 1.5 / 0.2 + 1e-6); // the steepest of a smoothstep over 0.2 of a step
    EXPECT_EQ(numerics::windrow_cel(0.37f, 0.0f, 0.2f), 0.37f);
}

} // namespace
} // namespace windrow::vegetation::fur
