// The ambient wind by itself: its pattern, its tile, what a plant feels of it, and the cheap gust without any of that.

#include "fluid/ambient.h"
#include "fluid/core/ambient_numerics.h"
#include "fluid/cpu/ambient_field.h"
#include "fluid/thread_pool.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

namespace {

using namespace windrow;
using namespace windrow::test;

// Baked once for all tests, as an application would.
const std::shared_ptr<const GustTile>& tile() {
    static const std::shared_ptr<const GustTile> shared = GustTile::bake(1);
    return shared;
}

AmbientWind blown(glm::vec3 mean, float intensity, std::optional<LogProfile> profile = {}, float length = 24.0f,
                  double ground = 0.0) {
    const Gusts gusts{.intensity = intensity, .length = length, .tile = tile()};
    auto wind = AmbientWind::create({.mean = mean, .profile = profile, .gusts = gusts, .ground = ground});
    EXPECT_TRUE(wind) << wind.error();
    return *std::move(wind);
}

// Infinite where anything is NaN, which a maximum would lose.
double distance(glm::vec3 a, glm::vec3 b) {
    const double length = glm::length(glm::dvec3(a) - glm::dvec3(b));
    return std::isnan(length) ? std::numeric_limits<double>::infinity() : length;
}

bool same_bits(glm::vec3 a, glm::vec3 b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// The largest of many errors, each at a random place up to `reach` [m] away and up to 40 m high.
template <class Error>
double largest(std::uint32_t seed, double reach, const Error& error) {
    Random random(seed);
    double worst = 0.0;
    for (int n = 0; n < 2'000; ++n) {
        const double x = random.real(-reach, reach), y = random.real(0.0, 40.0), z = random.real(-reach, reach);
        worst = std::max(worst, error(random, glm::dvec3(x, y, z)));
    }
    return worst;
}

TEST(Gusts, ThePatternIsCarriedByTheMeanWind) {
    const glm::vec3 mean(6.0f, 0.0f, -2.5f);
    for (const auto& [name, start, reach] :
         {std::tuple{"near", 0.0, 100.0}, {"far_away", 0.0, 1e6}, {"after_1e7_seconds", 1e7, 100.0}}) {
        const double worst = largest(201, reach, [&, from = start](Random& random, glm::dvec3 x) {
            AmbientWind wind = blown(mean, 0.5f, LogProfile{});
            wind.advance(from);
            const double d = random.real(-30.0, 30.0);
            const glm::vec3 earlier = wind.velocity(x - glm::dvec3(mean) * d);
            wind.advance(d);
            return distance(wind.velocity(x), earlier);
        });
        WINDROW_EXPECT_FIGURE(std::string("gusts/pattern_moves_") + name, worst, 1e-5);
    }
}

TEST(Gusts, ManySmallTicksCarryAsFarAsOneStep) {
    AmbientWind ticked = blown({7.0f, 0.0f, 3.0f}, 0.3f), stepped = ticked;
    for (int n = 0; n < 100'000; ++n)
        ticked.advance(1.0 / 60.0);
    stepped.advance(100'000.0 / 60.0);
    const auto error = [&](Random&, glm::dvec3 x) { return distance(ticked.velocity(x), stepped.velocity(x)); };
    WINDROW_EXPECT_FIGURE("gusts/ticks_against_one_step", largest(202, 50.0, error), 1e-5);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_TRUE(ticked.phase()[axis] >= 0.0 && ticked.phase()[axis] <= ticked.period());
}

TEST(Gusts, StrengthIsLinear) {
    const AmbientWind one = blown({2.0f, 0.0f, 1.5f}, 0.4f, LogProfile{}), three = blown({6.0f, 0.0f, 4.5f}, 0.4f, LogProfile{});
    const auto error = [&](Random&, glm::dvec3 x) { return distance(3.0f * one.velocity(x), three.velocity(x)); };
    WINDROW_EXPECT_FIGURE("gusts/linear_in_strength", largest(203, 100.0, error), 1e-5);
}

TEST(Gusts, ReversalMirrorsInTime) {
    const glm::vec3 mean(5.0f, 0.0f, -3.0f);
    const auto error = [&](Random& random, glm::dvec3 x) {
        AmbientWind there = blown(mean, 0.4f), back = blown(-mean, 0.4f);
        const double t = random.real(0.0, 100.0);
        there.advance(-t);
        back.advance(t);
        return distance(there.velocity(x) - mean, back.velocity(x) + mean);
    };
    WINDROW_EXPECT_FIGURE("gusts/reversal_mirrors", largest(204, 100.0, error), 1e-5);
}

TEST(Gusts, WholeTilesAwayTheBitsAreEqual) {
    AmbientWind wind = blown({5.0f, 0.0f, 2.0f}, 0.4f, LogProfile{});
    wind.advance(123.456);
    const Sampling sampling{.detail = 0.5f};
    const glm::vec3 u(3.0f, 1.0f, 2.0f);
    const auto differing = [&](Random&, glm::dvec3 anywhere) {
        const glm::dvec3 x = glm::floor(anywhere * 64.0) / 64.0, away = x + wind.period() * glm::dvec3(4096.0, 0.0, -5000.0);
        const bool same = same_bits(wind.velocity(x), wind.velocity(away));
        return same && same_bits(wind.felt(u, x, sampling), wind.felt(u, away, sampling)) ? 0.0 : 1.0;
    };
    EXPECT_EQ(largest(205, 250.0, differing), 0.0);
}

TEST(Gusts, ABlockAnswersAsTheWindDoes) {
    AmbientWind wind = blown({5.0f, 0.0f, 2.0f}, 0.4f, LogProfile{}, 17.0f, 3.0);
    wind.advance(1234.5);
    const Sampling sampling{.strength = 1.5f, .limit = 20.0f, .detail = 0.3f, .detail_length = 0.8f};
    const glm::dvec3 anchor(1e6 + 0.3, 5.0, -2e6 - 0.7);
    const auto block = std::bit_cast<numerics::WindrowAmbient>(wind.block(anchor, sampling));
    const numerics::TileView view{tile()->texels().data()};
    const auto ambient = [&](Random& random, glm::dvec3) {
        const glm::vec3 local = random.vector(16.0f);
        return distance(numerics::windrow_ambient(view, block, local), wind.velocity(anchor + glm::dvec3(local)));
    };
    const auto felt = [&](Random& random, glm::dvec3) {
        const glm::vec3 local = random.vector(16.0f), u = random.vector(5.0f);
        return distance(numerics::windrow_felt(view, block, u, local), wind.felt(u, anchor + glm::dvec3(local), sampling));
    };
    WINDROW_EXPECT_FIGURE("gusts/block_against_query", largest(206, 0.0, ambient), 1e-5);
    WINDROW_EXPECT_FIGURE("felt_wind/block_against_query", largest(206, 0.0, felt), 3e-5); // ripples are 30 times as steep
}

TEST(Gusts, APhaseSavedIsTheWholeState) {
    AmbientWind wind = blown({5.0f, 0.0f, 2.0f}, 0.4f), restored = wind;
    wind.advance(98'765.4);
    restored.set_phase(wind.phase());
    const glm::dvec3 x(1.0, 2.0, 3.0);
    const glm::vec3 u = wind.velocity(x);
    EXPECT_TRUE(same_bits(u, restored.velocity(x)));
    EXPECT_TRUE(same_bits(wind.felt(u, x, {.detail = 0.5f}), restored.felt(u, x, {.detail = 0.5f})));
    restored.set_phase({std::numeric_limits<double>::quiet_NaN(), -1.0, 1e300});
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_TRUE(restored.phase()[axis] >= 0.0 && restored.phase()[axis] <= restored.period());
}

TEST(Gusts, BetweenTwoTicksThePhaseGoesTheShortWay) {
    const glm::dvec3 a(255.0, 0.0, 20.0), b(3.0, 0.0, 18.0); // x over the seam of 256 m
    for (const auto& [factor, expected] : {std::pair{0.0, a}, {0.5, glm::dvec3(1.0, 0.0, 19.0)}, {1.0, b}})
        EXPECT_LT(glm::length(AmbientWind::between(a, b, factor, 256.0) - expected), 1e-12) << factor;
}

TEST(Gusts, WithoutProfileAndGustsTheWindIsTheMeanToTheBit) {
    auto wind = AmbientWind::create({.mean = {3.1f, -0.2f, 0.7f}});
    ASSERT_TRUE(wind);
    EXPECT_TRUE(wind->uniform() && !wind->gusting());
    EXPECT_EQ(wind->tile(), nullptr) << "a tile that nothing needs costs time and memory";
    wind->advance(17.3);
    EXPECT_TRUE(same_bits(wind->velocity({1e6, -40.0, 3.0}), wind->mean()));
    const glm::vec3 u(1.0f, 2.0f, 3.0f);
    EXPECT_TRUE(same_bits(wind->felt(u, {}, {.detail = 1.0f}), u)) << "no tile, no detail";
    EXPECT_FALSE(blown({0.0f, 2.0f, 0.0f}, 0.5f).gusting()) << "nothing carries gusts along";
}

TEST(Gusts, TheProfileIsLogarithmic) {
    const LogProfile profile{.roughness_length = 0.1f, .reference_height = 8.0f};
    const AmbientWind wind = blown({4.0f, 0.0f, 3.0f}, 0.0f, profile, 24.0f, 100.0);
    for (const double height : {100.0, 90.0})
        EXPECT_EQ(wind.velocity({0.0, height, 0.0}), glm::vec3(0.0f));
    EXPECT_EQ(wind.velocity({0.0, 108.0, 0.0}), wind.mean());
    double worst = 0.0;
    for (double z = 0.05; z < 200.0; z *= 1.3) {
        const double share = std::log((z + 0.1) / 0.1) / std::log(8.1 / 0.1);
        worst = std::max(worst, std::abs(wind.velocity({5.0, 100.0 + z, 0.0}).x - 4.0 * share));
        EXPECT_GT(wind.profile_at(100.0 + 1.3 * z), wind.profile_at(100.0 + z));
    }
    WINDROW_EXPECT_FIGURE("gusts/log_profile_error", worst, 1e-5);
}

TEST(Gusts, NoGustBlowsThroughTheGround) {
    for (const auto& profile : {std::optional<LogProfile>{}, std::optional(LogProfile{})}) {
        AmbientWind wind = blown({5.0f, 0.0f, 2.0f}, 1.0f, profile, 24.0f, 12.25);
        wind.advance(31.7);
        const auto error = [&](Random&, glm::dvec3 x) { return std::abs(double(wind.velocity({x.x, 12.25, x.z}).y)); };
        EXPECT_EQ(largest(207, 500.0, error), 0.0);
    }
}

TEST(Gusts, AClosedAxisHasNoGusts) {
    AmbientWind wind = blown({5.0f, 0.0f, 2.0f}, 1.0f);
    const glm::vec3 before = wind.velocity({3.0, 4.0, 5.0});
    wind.set_gust_axes({0.0f, 1.0f, 1.0f});
    const glm::vec3 after = wind.velocity({3.0, 4.0, 5.0});
    EXPECT_NE(before.x, 5.0f);
    EXPECT_EQ(after, glm::vec3(5.0f, before.y, before.z));
}

TEST(Gusts, TheirStrengthIsTheDeclaredOne) {
    AmbientWind wind = blown({8.0f, 0.0f, -6.0f}, 0.25f);
    Random random(208);
    glm::dvec3 squares(0.0);
    const int count = 200'000;
    for (int n = 0; n < count; ++n) {
        const glm::dvec3 x(random.real(0.0, 256.0), random.real(0.0, 32.0), random.real(0.0, 256.0));
        const glm::dvec3 gust = wind.velocity(x) - wind.mean();
        squares += gust * gust;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double deviation = std::sqrt(squares[axis] / count) / 2.5, declared = axis == 1 ? 0.5 : 1.0;
        WINDROW_EXPECT_FIGURE("gusts/rms_off_axis_" + std::to_string(axis), std::abs(deviation / declared - 1.0), 0.03);
    }
}

TEST(GustTile, RepeatsWithoutASeam) {
    Random random(209);
    double wrap = 0.0, mirror = 0.0, procedural = 0.0;
    for (int n = 0; n < 1'000; ++n) {
        // Multiples of 1/64, so that a shift by a period rounds nothing.
        const glm::dvec3 place(random.integer(0, 8192), random.integer(0, 1024), random.integer(0, 8192));
        const double x = place.x / 64.0, y = place.y / 64.0, z = place.z / 64.0;
        wrap = std::max({wrap, distance(tile()->sample({x, y, z}), tile()->sample({x + 128.0, y, z - 256.0})),
                         distance(tile()->sample({0.0, y, z}), tile()->sample({128.0, y, z})),
                         distance(tile()->sample({x, y, 0.0}), tile()->sample({x, y, 128.0}))});
        procedural = std::max({procedural, distance(tile()->procedural({0.0, y, z}), tile()->procedural({128.0, y, z})),
                               distance(tile()->procedural({x, y, z}), tile()->procedural({x - 128.0, y, z + 128.0}))});
        // The mirror in the ground and in the lid.
        const glm::vec3 above = tile()->sample({x, y, z}), below = tile()->sample({x, -y, z});
        const glm::vec3 over = tile()->sample({x, 32.0 - y, z});
        mirror = std::max({mirror, distance(above, {below.x, -below.y, below.z}), distance(above, {over.x, -over.y, over.z})});
    }
    WINDROW_EXPECT_FIGURE("gust_tile/seam_difference", wrap, 0.0);
    WINDROW_EXPECT_FIGURE("gust_tile/mirror_difference", mirror, 1e-6);
    WINDROW_EXPECT_FIGURE("gust_tile/seam_difference_procedural", procedural, 1e-6);
}

TEST(GustTile, StandsForTheWaves) {
    Random random(210);
    double squares = 0.0;
    const int count = 20'000;
    for (int n = 0; n < count; ++n) {
        const glm::dvec3 place(random.real(0.0, 128.0), random.real(0.0, 32.0), random.real(0.0, 128.0));
        squares += std::pow(distance(tile()->sample(place), tile()->procedural(place)), 2);
    }
    const double rms = std::sqrt(squares / count), range = 2.0 * tile()->bound();
    WINDROW_EXPECT_FIGURE("gust_tile/rms_against_procedural_over_range", rms / range, 1.0 / 255.0);
}

TEST(GustTile, HasTheDeclaredStrengthInEveryDirection) {
    glm::dvec3 squares(0.0);
    double longest = 0.0, along = 0.0;
    for (const glm::vec4& n : tile()->texels()) {
        squares += glm::dvec3(n) * glm::dvec3(n);
        along += double(n.x) * n.z;
        longest = std::max(longest, double(glm::length(glm::vec3(n))));
        ASSERT_EQ(n.w, 0.0f);
    }
    const glm::dvec3 rms = glm::sqrt(squares / double(tile()->texels().size()));
    // Texels are 3 % stronger than what their blend gives; see gust_tile.cpp.
    const glm::dvec3 off = glm::abs(rms / glm::dvec3(1.0, 0.5, 1.0) - 1.03);
    WINDROW_EXPECT_FIGURE("gust_tile/texel_rms_off", std::max({off.x, off.y, off.z}), 0.02);
    WINDROW_EXPECT_FIGURE("gust_tile/correlation_of_x_and_z", std::abs(along) / std::sqrt(squares.x * squares.z), 0.02);
    EXPECT_LE(longest, tile()->bound());
    figure("gust_tile/bound", tile()->bound());
}

// The waves are free of divergence; what central differences over two texels see of it is their own error, and falls with the
// step squared.
TEST(GustTile, IsSolenoidal) {
    const auto divergence = [](const auto& velocity, double h) {
        Random random(211);
        double divergent = 0.0, all = 0.0;
        for (int n = 0; n < 500; ++n) {
            const glm::dvec3 place(random.real(0.0, 128.0), random.real(0.0, 32.0), random.real(0.0, 128.0));
            double sum = 0.0;
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 step(0.0);
                step[axis] = h;
                const glm::dvec3 slope = (glm::dvec3(velocity(place + step)) - glm::dvec3(velocity(place - step))) / (2.0 * h);
                sum += slope[axis];
                all += glm::dot(slope, slope);
            }
            divergent += sum * sum;
        }
        return std::sqrt(divergent / all); // of the rms gradient
    };
    const auto waves = [](glm::dvec3 place) { return tile()->procedural(place); };
    const double coarse = divergence(waves, 1.0), fine = divergence(waves, 0.25);
    WINDROW_EXPECT_FIGURE("gust_tile/divergence_of_waves_quarter_texel", fine, 0.002);
    EXPECT_GT(figure("gust_tile/divergence_order", std::log(coarse / fine) / std::log(4.0)), 1.9);
    const auto texels = [](glm::dvec3 place) { return tile()->sample(glm::floor(place) + 0.5); };
    WINDROW_EXPECT_FIGURE("gust_tile/divergence_of_texels", divergence(texels, 1.0), 0.03);
}

TEST(GustTile, ASeedGivesTheSameBits) {
    const auto hash = [](const GustTile& baked) {
        std::uint64_t sum = 14695981039346656037ull; // FNV-1a over the floats' bits, -0 and 0 alike
        for (const glm::vec4& n : baked.texels())
            for (int axis = 0; axis < 4; ++axis)
                sum = (sum ^ std::bit_cast<std::uint32_t>(n[axis] + 0.0f)) * 1099511628211ull;
        return sum;
    };
    EXPECT_EQ(hash(*tile()), 0xc7eb83fb61d2ba3dull) << "on every machine: integers, IEEE sums, products and roots only";
    EXPECT_NE(hash(*GustTile::bake(2)), hash(*tile()));
    EXPECT_EQ(tile()->memory_bytes() >> 18, 16u) << "4 MiB of texels and the waves";
}

TEST(Felt, DetailFollowsTheLocalSpeed) {
    AmbientWind wind = blown({5.0f, 0.0f, 2.0f}, 0.3f);
    wind.advance(77.7);
    const Sampling sampling{.limit = 1e6f, .detail = 0.4f, .detail_length = 0.7f};
    const auto share = [&](Random& random, glm::dvec3 x) {
        EXPECT_EQ(wind.felt(glm::vec3(0.0f), x, sampling), glm::vec3(0.0f)) << "still air stays still";
        const glm::vec3 u = random.vector(20.0f);
        return distance(wind.felt(u, x, sampling), u) / glm::length(glm::dvec3(u));
    };
    const auto nonlinear = [&](Random& random, glm::dvec3 x) {
        const glm::vec3 u = random.vector(5.0f);
        return distance(wind.felt(3.0f * u, x, sampling), 3.0f * wind.felt(u, x, sampling));
    };
    const double most = largest(212, 1e5, share);
    WINDROW_EXPECT_FIGURE("felt_wind/detail_over_speed", most, 0.4 * (1.0 + 1e-6));
    EXPECT_GT(most, 0.2) << "there is detail";
    WINDROW_EXPECT_FIGURE("felt_wind/detail_linear_in_speed", largest(213, 1e5, nonlinear), 1e-5);
}

// A wrapped phase must not be seen: neither the gusts' tile nor the detail's may jump there.
TEST(Felt, DetailScrollsWithoutAJump) {
    AmbientWind wind = blown({5.0f, 0.0f, 0.0f}, 0.3f, {}, 23.0f);
    const Sampling sampling{.detail = 0.5f, .detail_length = 1.7f};
    const auto felt = [&](double x) { return wind.felt({4.0f, 0.0f, 1.0f}, {x, 2.0, 3.0}, sampling); };
    double at_wrap = 0.0, elsewhere = 0.0;
    wind.set_phase({wind.period() - 0.25, 0.0, 0.0});
    for (int n = 0; n < 1'000; ++n) {
        const double before = wind.phase().x;
        const glm::vec3 last = felt(1.0);
        wind.advance(1e-4);
        double& step = wind.phase().x < before ? at_wrap : elsewhere;
        step = std::max(step, distance(felt(1.0), last));
    }
    EXPECT_LT(wind.phase().x, 1.0) << "the phase has wrapped";
    EXPECT_GT(at_wrap, 0.0);
    WINDROW_EXPECT_FIGURE("felt_wind/step_at_wrap_over_elsewhere", at_wrap / elsewhere, 1.1);
    const glm::vec3 there = felt(1.0);
    wind.advance(2.0);
    WINDROW_EXPECT_FIGURE("felt_wind/detail_moves_with_the_wind", distance(felt(11.0), there), 1e-5);
}

TEST(Felt, IsScaledAndNeverAboveTheLimit) {
    const AmbientWind wind = blown({5.0f, 0.0f, 2.0f}, 0.3f);
    constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    Random random(213);
    double longest = 0.0, turned = 0.0;
    for (int n = 0; n < 20'000; ++n) {
        const glm::vec3 direction(random.direction());
        const float speed = static_cast<float>(random.spread(1e-20, 3e38)), limit = random.uniform(1.0f, 100.0f);
        const float strength = random.uniform(0.0f, 3.0f);
        const glm::vec3 u = direction * speed, felt = wind.felt(u, {}, {.strength = strength, .limit = limit});
        longest = std::max(longest, glm::length(glm::dvec3(felt)) / limit);
        if (double(speed) * strength < 0.999 * limit) {
            ASSERT_TRUE(same_bits(felt, strength * u)) << "linear below the limit";
        } else if (double(speed) * strength > limit) {
            turned = std::max(turned, glm::length(glm::cross(glm::normalize(glm::dvec3(felt)), glm::normalize(glm::dvec3(u)))));
            EXPECT_GT(glm::length(felt), 0.999f * limit);
        }
    }
    WINDROW_EXPECT_FIGURE("felt_wind/longest_over_limit", longest, 1.0);
    WINDROW_EXPECT_FIGURE("felt_wind/direction_kept", turned, 1e-6);
    for (const Sampling& sampling : {Sampling{}, Sampling{.detail = 1.0f}}) {
        for (const glm::vec3 u : {glm::vec3(1e6f), {-1e6f, 0.0f, 0.0f}, {0.0f, 1e38f, -1e38f}}) {
            const glm::vec3 felt = wind.felt(u, {1.0, 2.0, 3.0}, sampling);
            EXPECT_LE(glm::length(glm::dvec3(felt)), 60.0);
            EXPECT_GT(glm::length(felt), 59.0f);
        }
        for (const glm::vec3 u : {glm::vec3(nan, 0.0f, 0.0f), {0.0f, infinity, 0.0f}, {1.0f, nan, -infinity}})
            EXPECT_EQ(wind.felt(u, {1.0, 2.0, 3.0}, sampling), glm::vec3(0.0f));
    }
    for (const double bad : {double(nan), double(infinity), -double(infinity)}) {
        EXPECT_EQ(wind.velocity({bad, 0.0, 0.0}), wind.mean());
        EXPECT_EQ(wind.felt({1.0f, 2.0f, 3.0f}, {0.0, bad, 0.0}, {.detail = 1.0f}), glm::vec3(1.0f, 2.0f, 3.0f));
    }
    for (const double far : {1e12, -1e17, 1e300})
        EXPECT_LT(distance(wind.velocity({far, far, far}), wind.mean()), 20.0);
}

TEST(Felt, StaticAndDynamicWindAddUp) {
    AmbientWind wind = blown({5.0f, 0.0f, 2.0f}, 0.3f, LogProfile{});
    wind.advance(12.0);
    const Sampling sampling{.strength = 1.7f};
    const auto error = [&](Random& random, glm::dvec3 x) {
        const glm::vec3 still = wind.velocity(x), moving = random.vector(10.0f);
        const glm::vec3 sum = wind.felt(still, x, sampling) + wind.felt(moving, x, sampling);
        return distance(wind.felt(still + moving, x, sampling), sum) / std::max(1.0f, glm::length(sum));
    };
    WINDROW_EXPECT_FIGURE("felt_wind/superposition", largest(214, 100.0, error), 1e-6);
}

TEST(UniformGusts, HaveTheirMeanAndTheirPeriod) {
    const UniformGust gust{.mean = 5.0f, .amplitude = 3.0f, .period = 7.0f, .direction = {0.0f, 0.0f, 1.0f}};
    const int count = 70'000;
    double sum = 0.0, lowest = 1e9, highest = -1e9, steepest = 0.0, period = 0.0;
    double last = gust.velocity(7.0 - 3.5 / count).z;
    for (int n = 0; n < count; ++n) {
        const double time = 7.0 * (n + 0.5) / count, speed = gust.velocity(time).z;
        sum += speed;
        lowest = std::min(lowest, speed);
        highest = std::max(highest, speed);
        steepest = std::max(steepest, std::abs(speed - last));
        last = speed;
        for (const double periods : {1.0, -3.0, 1e6})
            period = std::max(period, std::abs(double(gust.velocity(time + 7.0 * periods).z) - speed));
    }
    const double e = std::exp(-3.0), share = 0.2 / (1.0 - e) - 0.8 * e / (1.0 - e) + 0.2, lull = share / (1.0 - share);
    WINDROW_EXPECT_FIGURE("uniform_gust/mean_off", std::abs(sum / count - 5.0), 1e-5);
    WINDROW_EXPECT_FIGURE("uniform_gust/period_off", period, 1e-5);
    WINDROW_EXPECT_FIGURE("uniform_gust/peak_off", std::abs(highest - 8.0), 1e-3);
    WINDROW_EXPECT_FIGURE("uniform_gust/lull_off", std::abs(lowest - (5.0 - lull * 3.0)), 1e-3);
    WINDROW_EXPECT_FIGURE("uniform_gust/steepest_step", steepest, 20.0 * 4.75 / count); // the rise has slope 15.8 a period
    EXPECT_EQ(gust.velocity(std::numeric_limits<double>::quiet_NaN()).z, 5.0f);
    EXPECT_EQ((UniformGust{.mean = 2.0f, .period = 0.0f}.velocity(1.0)), glm::vec3(2.0f, 0.0f, 0.0f));
}

TEST(AmbientField, IsTheWindAtTheCells) {
    using Case = std::tuple<const char*, glm::ivec3, float, glm::dvec3, float, bool>;
    for (const auto& [name, cells, cell_size, origin, intensity, profile] :
         {Case{"default", {32, 16, 32}, 1.0f, {-16.0, 0.0, -16.0}, 0.3f, true},
          Case{"far", {20, 9, 13}, 0.37f, {1e6, -3.0, -1e6}, 0.3f, false},
          Case{"one_cell", {1, 1, 1}, 1.0f, {5.0, 2.0, 7.0}, 0.3f, true},
          Case{"long", {2048, 2, 1}, 1.0f, {-900.0, 0.0, 3.0}, 0.3f, true},
          Case{"whole_tile", {123, 2, 3}, 2.0f, {-7.0, 0.0, 3.0}, 0.3f, true},
          Case{"large_cells", {6, 5, 40}, 91.0f, {-900.0, -100.0, 3.0}, 0.3f, true},
          Case{"small_cells", {40, 5, 6}, 0.01f, {-0.2, 0.0, 127.999}, 0.3f, false},
          Case{"profile_only", {9, 8, 7}, 1.0f, {-4.0, -2.0, 0.0}, 0.0f, true},
          Case{"uniform", {9, 8, 7}, 1.0f, {-4.0, -2.0, 0.0}, 0.0f, false}}) {
        AmbientWind wind = blown({8.0f, 0.5f, -3.0f}, intensity, profile ? std::optional(LogProfile{}) : std::nullopt);
        wind.set_gust_axes({1.0f, 0.5f, 1.0f});
        wind.advance(4321.1);
        const Window window{cells, cell_size, CellIndex(glm::floor(origin / double(cell_size)))};
        cpu::AmbientField field(cells);
        field.fill(wind, window, {});
        const glm::ivec3 padded = cells + k_halo;
        EXPECT_GE(field.memory_bytes(), cell_count(padded) * 16);
        double worst = 0.0;
        const float* at = field.data();
        for (int k = 0; k < padded.z; ++k)
            for (int j = 0; j < padded.y; ++j)
                for (int i = 0; i < padded.x; ++i, at += 4) {
                    const glm::dvec3 centre = window.centre(i - k_halo_low, j - k_halo_low, k - k_halo_low);
                    worst = std::max(worst, distance({at[0], at[1], at[2]}, wind.velocity(centre)));
                    ASSERT_EQ(at[3], 0.0f);
                }
        WINDROW_EXPECT_FIGURE(std::string("ambient_field/against_wind_") + name, worst, wind.uniform() ? 0.0 : 1e-5);
    }
}

TEST(AmbientField, DoesNotDependOnThreads) {
    AmbientWind wind = blown({8.0f, 0.0f, -3.0f}, 0.3f, LogProfile{});
    const Window window{.cells = {33, 17, 21}, .cell_size = 0.8f};
    cpu::AmbientField serial(window.cells), threaded(window.cells);
    serial.fill(wind, window, {});
    threaded.fill(wind, window, ThreadPool(3).parallel_for());
    EXPECT_EQ(std::memcmp(serial.data(), threaded.data(), 16 * cell_count(window.cells + k_halo)), 0);
}

TEST(Gusts, SettingsThatMakeNoSenseAreRejected) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto begins = [](const Result<void>& result, const std::string& start) {
        return !result && result.error().rfind(start, 0) == 0 && result.error().back() == '.';
    };
    for (const float bad : {-0.1f, 1e30f, nan}) {
        EXPECT_TRUE(begins(validate(LogProfile{.roughness_length = bad}), "profile.roughness_length is ")) << bad;
        EXPECT_TRUE(begins(validate(LogProfile{.reference_height = bad}), "profile.reference_height is ")) << bad;
        EXPECT_TRUE(begins(validate(Gusts{.intensity = bad}), "gusts.intensity is ")) << bad;
        EXPECT_TRUE(begins(validate(Gusts{.length = bad}), "gusts.length is ")) << bad;
        EXPECT_TRUE(begins(validate(Sampling{.strength = bad}), "sampling.strength is ")) << bad;
        EXPECT_TRUE(begins(validate(Sampling{.limit = bad}), "sampling.limit is ")) << bad;
        EXPECT_TRUE(begins(validate(Sampling{.detail = bad}), "sampling.detail is ")) << bad;
        EXPECT_TRUE(begins(validate(Sampling{.detail_length = bad}), "sampling.detail_length is ")) << bad;
    }
    EXPECT_FALSE(validate(LogProfile{.roughness_length = 0.0f}) || validate(Gusts{.length = 0.0f}));
    EXPECT_TRUE(validate(LogProfile{}) && validate(Gusts{}) && validate(Sampling{}));
    const LogProfile bald{.roughness_length = 0.0f};
    const auto rejected =
        AmbientWind::create({.mean = glm::vec3(nan), .profile = bald, .gusts = {.intensity = 2.0f}, .ground = nan});
    ASSERT_FALSE(rejected);
    EXPECT_EQ(std::count(rejected.error().begin(), rejected.error().end(), '\n'), 3) << rejected.error();
    AmbientWind wind = blown({1.0f, 0.0f, 0.0f}, 0.5f);
    EXPECT_TRUE(begins(wind.set_mean({1e5f, 0.0f, 0.0f}), "mean is "));
    EXPECT_TRUE(begins(wind.set_ground(nan), "ground is "));
    wind.advance(nan);
    EXPECT_TRUE(wind.mean().x == 1.0f && wind.ground() == 0.0 && wind.phase() == glm::dvec3(0.0)) << "rejected changes nothing";
}

} // namespace
