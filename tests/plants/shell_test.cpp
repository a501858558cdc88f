// Shells: extrusion by height, the sources' pushes by parameters, and no push into the surface, on posed bodies too.
#include "coupling/plant_numerics.h"
#include "coupling/shell.h"
#include "tests/fields.h"
#include "tests/figure.h"
#include "tests/plants/skin.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>

namespace windrow {
namespace {

using test::Random;

Shells shells(const ShellSettings& settings) {
    auto made = Shells::create(settings);
    EXPECT_TRUE(made) << made.error();
    return *made;
}

TEST(Shell, ExtrudesToItsHeightOverASphere) {
    Random random(1);
    double most = 0.0;
    for (const bool tip : {true, false})
        for (const float spacing : {0.5f, 1.0f, 2.5f}) {
            const int count = 24;
            const Shells fur =
                shells({.shells = count, .reaches_tip = tip, .length = 0.2f, .spacing = spacing, .push = 0.0f, .sag = 0.0f});
            for (int n = 0; n < 500; ++n) {
                const int i = random.integer(0, count - 1);
                const float map = random.uniform(0.0f, 1.0f);
                const glm::dvec3 exact = random.direction();
                const glm::vec3 normal(exact);
                const double wanted =
                    1.0 + 0.2 * static_cast<double>(map) * std::pow(i / (tip ? count - 1.0 : count * 1.0), spacing);
                const float h = fur.height(i);
                most = std::max(
                    most, std::abs(glm::length(glm::dvec3(fur.translated(normal, normal, h, map, glm::vec3(0.0f)))) - wanted));
                most =
                    std::max(most, std::abs(glm::length(glm::dvec3(fur.bent(normal, normal, h, map, glm::vec3(0.0f)))) - wanted));
            }
            const double outermost = tip ? 1.0 : std::pow(23.0 / 24.0, spacing);
            EXPECT_NEAR(fur.height(count - 1), outermost, 1e-6);
        }
    WINDROW_EXPECT_FIGURE("plants/shell/distance_from_a_sphere_error", most, 1e-6);
}

// Each source's push on a plane, n = +y, as its own text has it.
TEST(Shell, MakesTheSourcesPushesByParameters) {
    Random random(2);
    double most = 0.0;
    const glm::vec3 n{0.0f, 1.0f, 0.0f}, p{1.0f, 0.0f, 2.0f};
    constexpr int k_shells = 20;
    const auto off = [&](glm::vec3 ours, glm::dvec3 theirs) { most = std::max(most, glm::length(glm::dvec3(ours) - theirs)); };
    for (int round = 0; round < 200; ++round) {
        const glm::vec3 d = glm::vec3(random.direction()) * glm::vec3(1.0f, 0.0f, 1.0f); // level: none of it is inward
        const glm::dvec3 rest(p), up(n), push(d);
        const double a = random.real(0.3, 3.0), c = random.real(0.3, 3.0), s = random.real(0.0, 0.3),
                     size = random.real(0.05, 0.4);
        const Shells naive = shells({.shells = k_shells,
                                     .reaches_tip = false,
                                     .length = static_cast<float>(size),
                                     .spacing = static_cast<float>(a),
                                     .push = static_cast<float>(s),
                                     .push_exponent = static_cast<float>(c)});
        const Shells geometry = shells({.shells = k_shells,
                                        .length = static_cast<float>(size),
                                        .push = static_cast<float>(-size * s),
                                        .push_exponent = 1.0f});
        const Shells bunny = shells({.shells = k_shells,
                                     .reaches_tip = false,
                                     .length = static_cast<float>(size),
                                     .push = static_cast<float>(-s),
                                     .push_exponent = 1.0f});
        const Shells world = shells({.shells = k_shells,
                                     .length = static_cast<float>(size),
                                     .push = static_cast<float>(s),
                                     .push_exponent = static_cast<float>(c)});
        const Shells king = shells({.shells = k_shells,
                                    .reaches_tip = false,
                                    .length = static_cast<float>(size),
                                    .bias = 0.025f,
                                    .push = 0.0f,
                                    .droop = static_cast<float>(s),
                                    .droop_shape = 3.0f,
                                    .down = {0.0f, 0.0f, -1.0f}});
        for (int i = 0; i < k_shells; ++i) {
            const double of_n = i / 20.0, to_tip = i / 19.0, h = std::pow(of_n, a);
            off(naive.translated(p, n, naive.height(i), 1.0f, d), rest + up * size * h + push * std::pow(h, c) * s);
            off(geometry.translated(p, n, geometry.height(i), 1.0f, d), rest + up * (to_tip * size) - push * (to_tip * size * s));
            off(bunny.translated(p, n, bunny.height(i), 1.0f, d),
                rest + up * (of_n * size) - push * s * of_n); // d is the velocity
            off(world.translated(p, n, world.height(i), 1.0f, d), rest + up * (to_tip * size) + push * (s * std::pow(to_tip, c)));
            const double map = 0.7, f = (std::pow(3.0, of_n) - 1.0) / 2.0;
            off(king.translated(p, n, king.height(i), 0.7f, glm::vec3(0.0f)),
                rest + up * size * (of_n * map + 0.025) + glm::dvec3(0.0, 0.0, -1.0) * (f * s));
        }
    }
    WINDROW_EXPECT_FIGURE("plants/shell/sources_forms_error", most, 1e-6);
}

// How far inside of its place's plane a shell lies, over L, and how far it lies below the shell before it.
struct Breach {
    double inward = 0.0, order = 0.0;
};

Breach breach_of(const Shells& fur, glm::vec3 p, glm::vec3 n, float map, glm::vec3 direction, glm::vec3 load) {
    Breach most;
    double translated_before = 0.0, bent_before = 0.0;
    const double length = static_cast<double>(fur.settings().length);
    for (int i = 0; i < fur.settings().shells; ++i) {
        const float h = fur.height(i);
        const auto out = [&](glm::vec3 q) { return glm::dot(glm::dvec3(q) - glm::dvec3(p), glm::dvec3(n)) / length; };
        const double translated = out(fur.translated(p, n, h, map, direction)), bent = out(fur.bent(p, n, h, map, load));
        most.inward = std::max({most.inward, -translated, -bent});
        if (i > 0)
            most.order = std::max({most.order, translated_before - translated, bent_before - bent});
        translated_before = translated;
        bent_before = bent;
    }
    return most;
}

// Every kind of setting, with pushes of any direction up to ten lengths and the wind of a storm.
Breach worst(const std::vector<test::SkinPoint>& skin, int directions, std::uint32_t seed,
             double (*outside)(glm::dvec3) = nullptr) {
    Random random(seed);
    Breach most;
    for (int n = 0; n < directions; ++n) {
        const Shells fur = shells({.shells = 12,
                                   .reaches_tip = n % 2 == 0,
                                   .length = 0.05f,
                                   .spacing = random.uniform(0.4f, 2.5f),
                                   .push = random.uniform(0.0f, 0.5f),
                                   .push_exponent = random.uniform(0.3f, 4.0f),
                                   .droop = random.uniform(0.0f, 0.5f),
                                   .droop_shape = static_cast<float>(random.spread(1e-2, 1e2)),
                                   .sag = random.uniform(0.0f, 1.57f)});
        const test::SkinPoint& at = skin[static_cast<std::size_t>(random.integer(0, static_cast<int>(skin.size()) - 1))];
        const glm::vec3 direction(random.direction());
        const float map = random.uniform(0.0f, 1.0f);
        const glm::vec3 load = n % 3 == 0 ? 3.0f * glm::vec3(random.direction()) // a spring gone wild, not across the normal
                                          : fur.load(at.normal, map, 60.0f * direction);
        const Breach found = breach_of(fur, at.position, at.normal, map, direction, load);
        most.inward = std::max(most.inward, found.inward);
        most.order = std::max(most.order, found.order);
        if (outside != nullptr)
            for (int i = 0; i < 12; ++i) {
                const float h = fur.height(i);
                most.inward = std::max({most.inward, -outside(fur.translated(at.position, at.normal, h, map, direction)) / 0.05,
                                        -outside(fur.bent(at.position, at.normal, h, map, load)) / 0.05});
            }
    }
    return most;
}

std::vector<test::SkinPoint> plane_points() {
    return {{glm::vec3(0.0f), {0.0f, 1.0f, 0.0f}, {}}};
}

std::vector<test::SkinPoint> sphere_points() {
    Random random(9);
    std::vector<test::SkinPoint> points(2000);
    for (test::SkinPoint& point : points)
        point.position = point.normal = glm::vec3(random.direction());
    return points;
}

TEST(Shell, NeverEntersAPlaneOrASphereAndKeepsItsOrder) {
    const Breach plane = worst(plane_points(), 10'000, 3, [](glm::dvec3 q) { return q.y; });
    const Breach sphere = worst(sphere_points(), 10'000, 4, [](glm::dvec3 q) { return glm::length(q) - 1.0; });
    // 1e-6 L: on a sphere of radius 1 the rounding of the place itself is 6e-8 over L = 0.05 m.
    WINDROW_EXPECT_FIGURE("plants/shell/into_the_plane_over_length", plane.inward, 1e-6);
    WINDROW_EXPECT_FIGURE("plants/shell/order_on_the_plane", plane.order, 1e-6);
    WINDROW_EXPECT_FIGURE("plants/shell/into_the_sphere_over_length", sphere.inward, 1e-6);
    WINDROW_EXPECT_FIGURE("plants/shell/order_on_the_sphere", sphere.order, 1e-6);
}

TEST(Shell, NeverEntersABodyInAnyPose) {
    const std::vector<test::SkinPoint> rest = test::bumpy_body();
    const float poses[][2] = {{0.0f, 0.0f}, {0.9f, 0.0f}, {-0.6f, 1.1f}};
    for (int n = 0; n < 3; ++n) {
        const std::string name = "plants/shell/pose_" + std::to_string(n);
        const Breach found =
            worst(n == 0 ? rest : test::posed(rest, poses[n][0], poses[n][1]), 10'000, 5u + static_cast<std::uint32_t>(n));
        WINDROW_EXPECT_FIGURE(name + "_inward_over_length", found.inward, 1e-6);
        WINDROW_EXPECT_FIGURE(name + "_order", found.order, 1e-6);
    }
}

// The radius of a hollow, over the strands' length, below which tips enter the body about it: from the tip's place over a level skin,
// (d^2 + h^2) / 2 h. Held against a hollow ball: no tip of a wider one is in its wall, and all of a narrower one are.
double narrowest_hollow(const Shells& fur, float speed) {
    const glm::vec3 up{0.0f, 1.0f, 0.0f};
    const glm::dvec3 tip(fur.bent(glm::vec3(0.0f), up, 1.0f, 1.0f, fur.load(up, 1.0f, {speed, 0.0f, 0.0f})));
    const double length = static_cast<double>(fur.settings().length), radius = glm::dot(tip, tip) / (2.0 * tip.y);
    for (const double wider : {0.98, 1.02}) {
        const glm::dvec3 bottom(0.0, -wider * radius, 0.0);
        EXPECT_EQ(glm::length(bottom + tip) > wider * radius, wider < 1.0) << speed;
    }
    return radius / length;
}

// As coupling/shell.h states.
TEST(Shell, EntersABodyInNarrowHollows) {
    for (const auto& [length, radius] : {std::pair(0.03f, 0.9), std::pair(0.06f, 1.6), std::pair(0.1f, 2.6)})
        EXPECT_NEAR(narrowest_hollow(shells({.length = length, .sag = 0.0f}), 20.0f), radius, 0.06) << length;
    for (const float length : {0.03f, 0.06f}) {
        const Shells fur = shells({.length = length});
        int tips = 0, inside = 0;
        double depth = 0.0;
        for (const glm::vec3 way : {glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(-1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 0.0f, 1.0f)})
            for (const test::SkinPoint& at : test::bumpy_body(240, 192)) {
                if (std::abs(at.share.x - 0.5f) > 0.42f) // its ends are cut
                    continue;
                const glm::dvec3 tip(fur.bent(at.position, at.normal, 1.0f, 1.0f, fur.load(at.normal, 1.0f, 20.0f * way)));
                const double deep = test::bumpy_radius((tip.x + 0.8) / 1.6, std::atan2(tip.z, tip.y)) - std::hypot(tip.y, tip.z);
                ++tips;
                if (deep > 1e-5) {
                    ++inside;
                    depth += deep / static_cast<double>(length);
                }
            }
        const std::string name = "plants/shell/raw_tips_inside_at_20_m_s/" + std::to_string(std::lround(100.0f * length)) + "_cm";
        const double part = test::figure(name, static_cast<double>(inside) / tips);
        if (length < 0.05f) {
            EXPECT_LE(part, 1e-4);
        } else {
            EXPECT_NEAR(part, 0.013, 0.002);
            EXPECT_NEAR(test::figure(name + "/depth_over_length", depth / inside), 0.10, 0.01);
        }
    }
}

// Were displacement applied before skinning, the pose would turn the wind with the bones.
TEST(Shell, LeansWithTheWorldsWindOnATurnedBody) {
    const Shells fur = shells({.length = 0.05f, .sag = 0.0f});
    const std::vector<test::SkinPoint> rest = test::bumpy_body(), pose = test::posed(rest, 0.9f, 0.0f);
    const glm::vec3 wind{0.0f, 0.0f, 6.0f};
    double most = 0.0;
    for (std::size_t n = 0; n < pose.size(); ++n) {
        const glm::vec3 across = wind - glm::dot(wind, pose[n].normal) * pose[n].normal;
        if (glm::length(across) < 1.0f)
            continue;
        const glm::vec3 tip =
            fur.bent(pose[n].position, pose[n].normal, 1.0f, 1.0f, fur.load(pose[n].normal, 1.0f, wind)) - pose[n].position;
        const glm::vec3 lean = tip - glm::dot(tip, pose[n].normal) * pose[n].normal;
        most = std::max(most, static_cast<double>(glm::length(glm::cross(glm::normalize(lean), glm::normalize(across)))));
    }
    WINDROW_EXPECT_FIGURE("plants/shell/lean_off_the_wind_on_a_posed_body_rad", most, 1e-3);
}

TEST(Shell, StrandsThatTheMapShortensBendAsShortStrandsDo) {
    Random random(10);
    double load_most = 0.0, place_most = 0.0;
    for (int n = 0; n < 2000; ++n) {
        const float map = random.uniform(0.05f, 1.0f), h = random.uniform(0.0f, 1.0f);
        const ShellSettings whole{.length = 0.05f, .sag = 1.0f};
        ShellSettings trimmed = whole; // every strand of it is as short as the map makes one here
        trimmed.length = map * whole.length;
        trimmed.sag = map * map * map * whole.sag; // the tip's angle under its weight, as under an even load
        const Shells fur = shells(whole), stubble = shells(trimmed);
        const glm::vec3 normal(random.direction()),
            wind = static_cast<float>(random.spread(0.1, 40.0)) * glm::vec3(random.direction());
        const glm::vec3 load = fur.load(normal, map, wind);
        load_most = std::max(load_most, static_cast<double>(glm::length(load - stubble.load(normal, 1.0f, wind))));
        place_most = std::max(place_most, static_cast<double>(glm::length(fur.bent(glm::vec3(0.0f), normal, h, map, load) -
                                                                          stubble.bent(glm::vec3(0.0f), normal, h, 1.0f, load))));
    }
    WINDROW_EXPECT_FIGURE("plants/shell/load_off_a_class_of_that_length_rad", load_most, 2e-6); // a few roundings
    WINDROW_EXPECT_FIGURE("plants/shell/place_off_a_class_of_that_length_m", place_most, 1e-7);
    // Where the map is bald nothing is left to bend.
    EXPECT_LE(glm::length(shells({}).load({0.0f, 1.0f, 0.0f}, 0.0f, {40.0f, 0.0f, 0.0f})), 1e-12f);
}

TEST(Shell, RemovesThePushAndTheSagEachForItself) {
    // Push out early, fall late: cut as one sum, the tips would lie lower than what is below them.
    const Shells fur =
        shells({.shells = 40, .length = 0.01f, .push = 0.1f, .push_exponent = 0.3f, .droop = 0.2f, .droop_shape = 50.0f});
    const glm::vec3 n{0.0f, 1.0f, 0.0f};
    double whole_before = 0.0, worst_whole = 0.0;
    for (int i = 0; i < 40; ++i) {
        const auto shared = numerics::WindrowShells{fur.block().form, fur.block().push, fur.block().sag, {fur.block().drag.load}};
        const float h = fur.height(i);
        const glm::vec3 sum = numerics::windrow_shell_push(shared, h, n) + numerics::windrow_shell_droop(shared, h);
        const double whole =
            static_cast<double>(numerics::windrow_shell_distance(shared, h, 1.0f) + numerics::windrow_outward(sum, n).y);
        worst_whole = std::max(worst_whole, whole_before - whole);
        whole_before = whole;
    }
    EXPECT_GT(worst_whole, 1e-4); // the sum would have crossed
    EXPECT_LE(breach_of(fur, glm::vec3(0.0f), n, 1.0f, n, glm::vec3(0.0f)).order, 1e-6);
}

} // namespace
} // namespace windrow
