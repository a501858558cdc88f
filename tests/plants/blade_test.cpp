// Blades: the root stays, the length is kept within 1 %, the tip leans along the wind; and their shape at rest.
#include "coupling/blade.h"
#include "coupling/plant_classes.h"
#include "coupling/plant_numerics.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace windrow {
namespace {

using test::Random;

constexpr double k_blade_degrees = 180.0 / 3.14159265358979323846;

Blades blades(const BladeSettings& settings) {
    auto made = Blades::create(settings);
    EXPECT_TRUE(made) << made.error();
    return *made;
}

// Length of a curve of points in double, by chords between close points.
double arc_length(const std::function<glm::dvec3(double)>& point, int pieces = 4000) {
    double sum = 0.0;
    glm::dvec3 last = point(0.0);
    for (int n = 1; n <= pieces; ++n) {
        const glm::dvec3 next = point(static_cast<double>(n) / pieces);
        sum += glm::length(next - last);
        last = next;
    }
    return sum;
}

double arc_change(const Blades& grass, PlantKey key, glm::vec3 load, float side = 0.0f) {
    const auto point = [&](double h) { return glm::dvec3(grass.vertex(key, load, static_cast<float>(h), side).position); };
    return std::abs(arc_length(point, 400) / static_cast<double>(grass.length(key)) - 1.0);
}

TEST(Blade, ItsRootStaysWhateverBlows) {
    Random random(1);
    const Blades grass = blades({.width = 0.0f, .rest_bend = 1.5f, .view_bend = 1.0f});
    const Blades wide = blades({.rest_bend = 1.5f});
    for (int n = 0; n < 1000; ++n) {
        const PlantKey key{random.bits(), random.bits()};
        const glm::vec3 wind = random.vector(60.0f);
        ASSERT_EQ(grass.vertex(key, grass.load(key, wind), 0.0f, 1.0f).position, glm::vec3(0.0f));
        ASSERT_EQ(wide.vertex(key, wide.load(key, wind), 0.0f, 1.0f).position,
                  wide.vertex(key, glm::vec3(0.0f), 0.0f, 1.0f).position);
        ASSERT_EQ(numerics::windrow_translated(wind, 0.0f, 0.01f, 2.0f), glm::vec3(0.0f));
    }
}

TEST(Blade, WithoutWindAndBendItIsTheRestShapeToTheBit) {
    const Blades grass = blades({.rest_bend = 0.0f, .rest_bend_spread = 0.0f});
    Random random(2);
    for (int n = 0; n < 1000; ++n) {
        const PlantKey key{random.bits(), random.bits()};
        const float h = random.uniform(0.0f, 1.0f);
        const PlantVertex vertex = grass.vertex(key, grass.load(key, glm::vec3(0.0f)), h, 0.0f);
        ASSERT_EQ(vertex.position, glm::vec3(0.0f, grass.length(key) * h, 0.0f));
        ASSERT_EQ(vertex.tangent, glm::vec3(0.0f, 1.0f, 0.0f));
        ASSERT_EQ(vertex.normal.y, 0.0f);
    }
}

TEST(Blade, TheTranslateFormIsLinearInTheWindTheBendIsMonotone) {
    const glm::vec3 wind{3.0f, 0.0f, -1.0f};
    EXPECT_EQ(numerics::windrow_translated(2.0f * wind, 0.7f, 0.01f, 2.0f),
              2.0f * numerics::windrow_translated(wind, 0.7f, 0.01f, 2.0f));
    const Blades grass = blades({.rest_bend = 0.0f, .rest_bend_spread = 0.0f});
    const PlantKey key{3, 5};
    double before = -1.0;
    for (int n = 0; n <= 600; ++n) {
        const PlantVertex tip = grass.vertex(key, grass.load(key, {0.1f * static_cast<float>(n), 0.0f, 0.0f}), 1.0f, 0.0f);
        const double angle = std::atan2(static_cast<double>(tip.tangent.x), static_cast<double>(tip.tangent.y));
        ASSERT_GE(angle, before) << n;
        before = angle;
    }
    EXPECT_NEAR(before, 0.5 * 3.14159265, 0.02);
}

TEST(Blade, KeepsItsLengthAtFullClamp) {
    Random random(3);
    double by_wind = 0.0, by_itself = 0.0, both = 0.0, edge = 0.0, by_spring = 0.0;
    const BladeSettings plain{.rest_bend = 0.0f, .rest_bend_spread = 0.0f};
    for (int n = 0; n < 300; ++n) {
        const PlantKey key{random.bits(), random.bits()};
        const glm::vec3 storm = 60.0f * glm::vec3(random.direction());
        BladeSettings curly = plain;
        curly.rest_bend = n % 2 == 0 ? 3.0f : -3.0f;
        curly.rest_curve = random.uniform(0.0f, 1.0f);
        BladeSettings springy = curly;
        springy.stalk.max_bend = 2.5f;
        const Blades straight = blades(plain), bent = blades(curly), swung = blades(springy);
        const float angle = random.uniform(0.0f, 6.2832f), size = n % 3 == 0 ? 3.0f : random.uniform(0.0f, 3.0f);
        const glm::vec3 swing = size * glm::vec3(std::cos(angle), 0.0f, std::sin(angle));
        by_wind = std::max(by_wind, arc_change(straight, key, straight.load(key, storm)));
        by_itself = std::max(by_itself, arc_change(bent, key, glm::vec3(0.0f)));
        both = std::max(both, arc_change(bent, key, bent.load(key, storm * random.uniform(0.0f, 0.2f))));
        by_spring = std::max(by_spring, arc_change(swung, key, swing));
        edge = std::max(edge, arc_change(straight, key, straight.load(key, storm), 1.0f));
    }
    WINDROW_EXPECT_FIGURE("plants/blade/arc_change_by_wind_at_full_clamp", by_wind, 0.01);
    WINDROW_EXPECT_FIGURE("plants/blade/arc_change_by_own_bend_of_3_rad", by_itself, 0.01);
    WINDROW_EXPECT_FIGURE("plants/blade/arc_change_by_both", both, 0.01);
    WINDROW_EXPECT_FIGURE("plants/blade/arc_change_by_a_spring_of_2.5_rad", by_spring, 0.01);
    // An edge of a strip that bends sidelong is longer or shorter than its middle by half a width times the bend: geometry.
    test::figure("plants/blade/arc_change_of_an_edge", edge);
    const auto translated = [](double h) {
        return glm::dvec3(0.0, 0.3 * h, 0.0) +
               glm::dvec3(numerics::windrow_translated({10.0f, 0.0f, 0.0f}, static_cast<float>(h), 0.03f, 2.0f));
    };
    test::figure("plants/blade/arc_change_of_the_translate_form", arc_length(translated) / 0.3 - 1.0);
}

TEST(Blade, BendsByItsOwnLengthAsAClassOfThatLengthDoes) {
    const BladeSettings mixed{.length_spread = 0.6f, .stiffness_spread = 0.0f};
    const Blades grass = blades(mixed);
    Random random(7);
    double most = 0.0, shortest = 10.0, longest = 0.0;
    for (int n = 0; n < 2000; ++n) {
        const PlantKey key{random.bits(), random.bits()};
        const glm::vec3 wind = static_cast<float>(random.spread(0.1, 40.0)) * glm::vec3(random.direction());
        BladeSettings alike = mixed;
        alike.length_spread = 0.0f;
        alike.stalk.length = grass.length(key);
        most = std::max(most, static_cast<double>(glm::length(grass.load(key, wind) - blades(alike).load(key, wind))));
        const double breeze = static_cast<double>(glm::length(grass.load(key, {0.2f, 0.0f, 0.0f})));
        shortest = std::min(shortest, breeze);
        longest = std::max(longest, breeze);
    }
    WINDROW_EXPECT_FIGURE("plants/blade/load_off_a_class_of_that_length_rad", most, 2e-6);             // a few roundings
    test::figure("plants/blade/load_of_the_longest_over_the_shortest_in_0.2_m_s", longest / shortest); // at most 4^3
}

TEST(Blade, LeansAlongTheWind) {
    Random random(4);
    const Blades straight = blades({.rest_bend = 0.0f, .rest_bend_spread = 0.0f});
    const Blades grass = blades({});
    double most = 0.0, own_in_storm = 0.0, out_of_plane = 0.0;
    for (int n = 0; n < 20000; ++n) {
        const PlantKey key{random.bits(), random.bits()};
        const double azimuth = random.real(0.0, 6.283185307);
        const float speed = static_cast<float>(random.spread(0.3, 40.0));
        const glm::vec3 wind{speed * static_cast<float>(std::cos(azimuth)), random.uniform(-5.0f, 5.0f),
                             speed * static_cast<float>(std::sin(azimuth))};
        const auto off = [&](const Blades& kind, glm::vec3 blowing) {
            const glm::dvec3 tip(kind.vertex(key, kind.load(key, blowing), 1.0f, 0.0f).position);
            const double turn = std::atan2(tip.z, tip.x) - azimuth;
            return std::abs(std::remainder(turn, 6.283185307179586)) * k_blade_degrees;
        };
        most = std::max(most, off(straight, wind));
        own_in_storm = std::max(own_in_storm, off(grass, wind * (40.0f / speed)));
        const glm::vec3 normal = straight.vertex(key, straight.load(key, wind), 0.6f, 0.0f).normal;
        out_of_plane = std::max(out_of_plane, std::abs(static_cast<double>(glm::length(normal)) - 1.0));
    }
    WINDROW_EXPECT_FIGURE("plants/blade/lean_off_the_wind_degrees", most, 1.0);
    // With a bend of its own a blade turns into the wind as the wind grows.
    test::figure("plants/blade/lean_off_a_storm_with_own_bend_degrees", own_in_storm);
    WINDROW_EXPECT_FIGURE("plants/blade/normal_length_error", out_of_plane, 1e-5);
}

TEST(Blade, BendsAboutItsOwnAxisWhenAskedTo) {
    const Blades flat = blades({.along_wind = 0.0f, .rest_bend = 0.0f, .rest_bend_spread = 0.0f});
    Random random(5);
    for (int n = 0; n < 1000; ++n) {
        const PlantKey key{random.bits(), random.bits()};
        const glm::vec3 facing = flat.vertex(key, glm::vec3(0.0f), 0.0f, 0.0f).normal;
        const glm::vec3 wind = glm::vec3(random.direction()) * 5.0f;
        const glm::vec3 tip = flat.vertex(key, flat.load(key, wind), 1.0f, 0.0f).position;
        const glm::vec3 across{facing.z, 0.0f, -facing.x};
        ASSERT_NEAR(glm::dot(tip, across), 0.0f, 1e-6f);
        ASSERT_GE(glm::dot(tip, facing) * glm::dot(wind, facing), -1e-6f);
    }
}

// The frame against differences of the positions: tangent along h, normal across h and side.
TEST(Blade, NormalsAndTangentsAreThePositionsDerivatives) {
    double straight_error = 0.0, both_error = 0.0, twisted_error = 0.0, tangent_error = 0.0;
    Random random(6);
    for (int n = 0; n < 2000; ++n) {
        const bool own = n % 2 == 1, twists = n % 3 == 2;
        const Blades grass = blades({.stalk = wheat(),
                                     .width = 0.1f,
                                     .rest_bend = own ? 0.8f : 0.0f,
                                     .rest_bend_spread = 0.0f,
                                     .twist = twists ? 2.0f : 0.0f});
        const PlantKey key{random.bits(), random.bits()};
        const glm::vec3 load = grass.load(key, glm::vec3(random.direction()) * random.uniform(0.0f, 15.0f));
        const float h = random.uniform(0.05f, 0.95f), side = twists ? 0.0f : random.uniform(-1.0f, 1.0f);
        const auto at = [&](float where, float across) { return glm::dvec3(grass.vertex(key, load, where, across).position); };
        const double step = 4e-3;
        const auto along = [&](float across) {
            return (at(h + static_cast<float>(step), across) - at(h - static_cast<float>(step), across)) / (2.0 * step);
        };
        const PlantVertex vertex = grass.vertex(key, load, h, side);
        const glm::dvec3 normal = glm::normalize(glm::cross(at(h, 1.0f) - at(h, -1.0f), along(side)));
        const double off =
            std::acos(std::clamp(std::abs(glm::dot(normal, glm::dvec3(vertex.normal))), 0.0, 1.0)) * k_blade_degrees;
        double& worst = twists ? twisted_error : own ? both_error : straight_error;
        worst = std::max(worst, off);
        tangent_error = std::max(
            tangent_error, std::acos(std::clamp(glm::dot(glm::normalize(along(0.0f)), glm::dvec3(vertex.tangent)), -1.0, 1.0)) *
                               k_blade_degrees);
    }
    // What the differences themselves leave is about 0.1 degrees.
    WINDROW_EXPECT_FIGURE("plants/blade/normal_off_degrees_one_plane", straight_error, 0.5);
    WINDROW_EXPECT_FIGURE("plants/blade/normal_off_degrees_twisted_on_its_middle_line", twisted_error, 0.5);
    test::figure("plants/blade/normal_off_degrees_own_bend_out_of_the_winds_plane", both_error);
    WINDROW_EXPECT_FIGURE("plants/blade/tangent_off_degrees", tangent_error, 1.0);
}

// Twist by the moment of a flat plate. The middle line does not move.
TEST(Blade, TwistsItsFaceToTheWind) {
    constexpr float k_twist = 1.5f;
    constexpr double k_load = 0.02; // [rad] so little that the bend turns the face by less than its square
    const BladeSettings plain{.rest_bend = 0.4f, .twist = 0.0f};
    BladeSettings turning = plain;
    turning.twist = k_twist;
    const Blades still = blades(plain), grass = blades(turning);
    Random random(8);
    double off = 0.0, most = 0.0;
    for (int n = 0; n < 2000; ++n) {
        const PlantKey key{random.bits(), random.bits()};
        const glm::dvec3 facing(grass.vertex(key, glm::vec3(0.0f), 0.0f, 0.0f).normal);
        const double angle = random.real(-3.14159, 3.14159); // from the face to the load
        const glm::dvec3 width = glm::cross(glm::dvec3(0.0, 1.0, 0.0), facing);
        const glm::vec3 load(k_load * (std::cos(angle) * facing + std::sin(angle) * width));
        for (const float h : {0.25f, 0.5f, 1.0f}) {
            const glm::dvec3 without(still.vertex(key, load, h, 1.0f).normal), with(grass.vertex(key, load, h, 1.0f).normal);
            const glm::dvec3 across = glm::cross(glm::dvec3(still.vertex(key, load, h, 1.0f).tangent), without);
            const double turned = std::atan2(glm::dot(with, across), glm::dot(with, without));
            const double share = static_cast<double>(h) * (2.0 - static_cast<double>(h)); // an even moment
            off = std::max(off, std::abs(turned - share * static_cast<double>(k_twist) * k_load * std::sin(2.0 * angle)));
            most = std::max(most, turned);
            ASSERT_EQ(still.vertex(key, load, h, 0.0f).position, grass.vertex(key, load, h, 0.0f).position);
        }
    }
    WINDROW_EXPECT_FIGURE("plants/blade/twist_off_the_moment_of_a_plate_rad", off, 1e-5);
    EXPECT_GT(most, 0.99 * static_cast<double>(k_twist) * k_load); // at 45 degrees
}

TEST(Blade, FeelsNothingOfAWindThatIsNotFinite) {
    const Blades grass = blades({});
    const float broken[] = {std::nanf(""), std::numeric_limits<float>::infinity(), 3e38f};
    for (const float value : broken)
        for (int axis = 0; axis < 3; axis += 2) {
            glm::vec3 wind(1.0f);
            wind[axis] = value;
            EXPECT_EQ(grass.load({1, 2}, wind), glm::vec3(0.0f));
        }
}

} // namespace
} // namespace windrow
