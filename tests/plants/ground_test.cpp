// The ground's memory of walkers: blades lean outward within the radius, none outside, none under an airborne walker. Shifts of
// the window lose nothing.
#include "coupling/ground_host.h"
#include "coupling/ground_memory.h"
#include "coupling/ground_state.h"
#include "coupling/motion_numerics.h"
#include "fluid/thread_pool.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace windrow {
namespace {

GroundMemory ground_of(const GroundConfig& config, ParallelFor parallel_for = {}) {
    auto made = GroundMemory::create(config, parallel_for);
    EXPECT_TRUE(made) << (made ? "" : made.error());
    return *std::move(made);
}

void advance(GroundMemory& ground, double duration, std::span<const GroundWalker> walkers = {}, glm::vec2 lean = {0.0f, 0.0f}) {
    const auto done = ground.advance({.duration = duration, .walkers = walkers, .wind_lean = lean});
    ASSERT_TRUE(done) << done.error();
}

GroundWalker standing(glm::dvec3 place, float radius, float feet = 0.0f) {
    return {.position = place, .previous = place, .foot_height = feet, .previous_foot_height = feet, .radius = radius};
}

// --- The world's origin moves
// ----------------------------------------------------------------------------------------------------------------------------

// Places beyond 1e8 m are exact to 1e-8 m alone, so that the window's own digits show whether it went on counting from them.
TEST(Ground, AShiftOfTheOriginMovesNoTexel) {
    for (const glm::dvec3 offset :
         {glm::dvec3(-4096.0, 3.0, 512.0), glm::dvec3(1000.125, 0.0, -7.0625), glm::dvec3(1e8, 0.0, 1e8)}) {
        GroundMemory ground = ground_of({.texels = 32}), shifted = ground_of({.texels = 32});
        glm::dvec3 place(0.0);
        for (int frame = 0; frame < 90; ++frame) {
            const glm::dvec3 before = place, by = frame >= 30 ? offset : glm::dvec3(0.0);
            if (frame == 30) {
                ASSERT_TRUE(shifted.shift_origin(offset));
            }
            place += glm::dvec3(0.125, 0.0, 0.0625);
            GroundWalker walker{.position = place, .previous = before, .radius = 0.5f};
            ASSERT_TRUE(ground.follow(place));
            ASSERT_TRUE(shifted.follow(place + by));
            advance(ground, 1.0 / 60.0, std::span(&walker, 1), {0.2f, 0.1f});
            walker.position += by;
            walker.previous += by;
            advance(shifted, 1.0 / 60.0, std::span(&walker, 1), {0.2f, 0.1f});
            ASSERT_TRUE(std::ranges::equal(ground.texels(), shifted.texels())) << frame;
            for (const glm::dvec3 at : {place, before, place + glm::dvec3(1.5, 0.0, -0.75)}) {
                ASSERT_EQ(ground.at(at).lean, shifted.at(at + by).lean) << frame;
                ASSERT_EQ(ground.previous_at(at).trail, shifted.previous_at(at + by).trail) << frame;
            }
            ASSERT_LT(glm::distance(ground.next_centre({3, 7}) + glm::dvec2(by.x, by.z), shifted.next_centre({3, 7})), 1e-7);
        }
        EXPECT_GT(ground.at(place).trample, 0.5f) << "there is something to lose";
        EXPECT_FALSE(shifted.shift_origin(glm::dvec3(std::numeric_limits<double>::quiet_NaN())));
        EXPECT_FALSE(shifted.shift_origin({0.0, 0.0, 1e13}));
        const auto bytes = shifted.save();
        ASSERT_TRUE(bytes);
        const auto loaded = GroundMemory::load(*bytes);
        ASSERT_TRUE(loaded) << loaded.error();
        EXPECT_EQ(loaded->at(place + offset).lean, shifted.at(place + offset).lean);
    }
}

// --- A walker pushes outward
// -----------------------------------------------------------------------------------------------------

TEST(Ground, BladesLeanOutwardWithinTheRadiusAndNoneOutside) {
    GroundMemory ground = ground_of({});
    const glm::dvec3 place(0.37109375, 0.0, -0.8125); // known exactly to the ground: a multiple of 1/16384 texel
    const float radius = 1.5f;
    const GroundWalker walker = standing(place, radius);
    for (int frame = 0; frame < 30; ++frame)
        advance(ground, 1.0 / 60.0, std::span(&walker, 1));

    // Blades anywhere, as a vertex shader finds them: between texels too.
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double texel = static_cast<double>(ground.config().texel_size);
    double worst_angle = 0.0, weakest = 1.0, outside = 0.0;
    for (int n = 0; n < 20000; ++n) {
        const double r = 3.0 * unit(random), angle = 2.0 * std::numbers::pi * unit(random);
        const glm::dvec2 away(std::cos(angle), std::sin(angle));
        const glm::dvec2 lean(ground.at(place + glm::dvec3(r * away.x, 0.0, r * away.y)).lean);
        if (r > static_cast<double>(radius) + std::numbers::sqrt2 * texel) // further than a texel that is touched reaches
            outside = std::max(outside, glm::length(lean));
        else if (r > texel && r < static_cast<double>(radius) - texel) {
            worst_angle = std::max(worst_angle, std::acos(std::clamp(glm::dot(lean, away) / glm::length(lean), -1.0, 1.0)));
            weakest = std::min(weakest, glm::length(lean));
        }
    }
    WINDROW_EXPECT_FIGURE("ground/push/degrees_off", worst_angle * 180.0 / std::numbers::pi, 5.0);
    EXPECT_GT(test::figure("ground/push/weakest_lean", weakest), 0.02);
    WINDROW_EXPECT_FIGURE("ground/push/outside", outside, 0.0);

    // At the texels themselves: the formula, and nothing from the radius on.
    double off = 0.0;
    const int n = ground.config().texels;
    const double push = static_cast<double>(ground.config().push);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const glm::dvec2 centre = ground.next_centre({i, j}), from = centre - glm::dvec2(place.x, place.z);
            const double s2 = glm::dot(from, from) / static_cast<double>(radius * radius);
            const glm::vec2 lean = detail::GroundState::of(ground)[static_cast<std::size_t>(j * n + i)].lean;
            if (s2 >= 1.0)
                EXPECT_EQ(lean, glm::vec2(0.0f));
            else if (glm::length(from) > texel) // inside, the trail pulls further than the softened push
                off = std::max(off, glm::length(glm::dvec2(lean) - push * (1.0 - s2) * (1.0 - s2) * from /
                                                                       std::sqrt(glm::dot(from, from) + texel * texel)));
        }
    WINDROW_EXPECT_FIGURE("ground/push/at_texels", off, 1e-6);
}

TEST(Ground, AirborneWalkersTouchNothing) {
    GroundMemory ground = ground_of({});
    const float clearance = ground.config().clearance;
    GroundWalker walker = standing({0.1, 0.0, 0.2}, 1.0f, clearance);
    for (int frame = 0; frame < 10; ++frame) {
        walker.previous = walker.position;
        walker.position.x += 0.3;
        advance(ground, 1.0 / 60.0, std::span(&walker, 1));
    }
    for (const numerics::WindrowGround& texel : detail::GroundState::of(ground)) {
        ASSERT_EQ(texel.lean, glm::vec2(0.0f));
        ASSERT_EQ(texel.trail, glm::vec2(0.0f));
        ASSERT_EQ(texel.trample, 0.0f);
    }
    // A leap: down, up and down again within one step's sweep; only what lies below the feet's clearance is touched.
    GroundMemory leaped = ground_of({.texel_size = 0.125f});
    const GroundWalker leap{
        .position = {4.0, 0.0, 0.0}, .previous = {-4.0, 0.0, 0.0}, .foot_height = 2.0f * clearance, .radius = 0.5f};
    advance(leaped, 0.1, std::span(&leap, 1));
    EXPECT_GT(leaped.at({-3.5, 0.0, 0.0}).trample, 0.7f);
    EXPECT_NEAR(leaped.at({-2.0, 0.0, 0.0}).trample, 0.5f * std::exp(-0.075f / 0.8f), 0.05f); // half the height: half the weight
    EXPECT_EQ(leaped.at({0.5, 0.0, 0.0}).trample, 0.0f);
}

// --- A fast walker leaves no gaps
// ---------------------------------------------------------------------------------------------------

// The trail of a walk along x at `speed` from -half to half [m].
GroundMemory walked(const GroundConfig& config, double half, double speed, int rate, float radius) {
    GroundMemory ground = ground_of(config);
    const double seconds = 2.0 * half / speed;
    const int frames = std::max(1, static_cast<int>(std::lround(seconds * rate)));
    GroundWalker walker = standing({-half, 0.0, 0.05}, radius);
    advance(ground, 0.0);
    for (int frame = 1; frame <= frames; ++frame) {
        walker.previous = walker.position;
        walker.position.x = half * (2.0 * frame / frames - 1.0);
        advance(ground, seconds / frames, std::span(&walker, 1));
    }
    return ground;
}

TEST(Ground, AFastWalkerLeavesNoGaps) {
    const GroundMemory ground = walked({}, 8.0, 50.0, 30, 0.3f); // 1.7 m a frame, eleven radii
    const GroundConfig config = ground.config();
    const double texel = static_cast<double>(config.texel_size);
    double least = 1.0, most = 0.0;
    for (double x = -7.875; x < 7.9; x += texel) { // along the row of texels that lies nearest to the path
        const float trail = ground.at({x, 0.0, 0.125}).trail;
        least = std::min(least, static_cast<double>(trail));
        most = std::max(most, static_cast<double>(trail));
    }
    test::figure("ground/sweep/most", most);
    // The row lies 0.075 m off: (1 - 1/16)^2 of the walker's push; the oldest part has faded for 0.32 s of 20 s.
    const double expected = static_cast<double>(config.push * config.trail_fraction) * std::pow(1.0 - 1.0 / 16.0, 2);
    EXPECT_NEAR(most, expected, 1e-3 * expected);
    WINDROW_EXPECT_FIGURE("ground/sweep/lost_along_the_path", 1.0 - least / expected, 1.0 - 0.999 * std::exp(-0.32 / 20.0));
}

// The trail of one walk at several frame rates, texel by texel. A contact is taken where the walker comes closest in a frame,
// which the frames do not change. Bounds: of the deepest trail, a hundredth, which is by how much the way of a millisecond or two
// turns it, for which a trail is renewed beyond the closest place, until its fading is outrun; and of the press what fades in the
// few milliseconds around that place.
TEST(Ground, AWalkLeavesTheSameTrailAtAnyFrameRate) {
    const GroundConfig small{.texels = 32, .blend_width = 1.0f};
    const double deepest = static_cast<double>(small.push * small.trail_fraction);
    const GroundMemory truth = walked(small, 2.0, 1.5, 1000, 0.5f);
    double trail = 0.0, trample = 0.0;
    for (const int rate : {15, 30, 60, 144}) {
        const GroundMemory found = walked(small, 2.0, 1.5, rate, 0.5f);
        for (std::size_t n = 0; n < detail::GroundState::of(truth).size(); ++n) {
            trail = std::max(trail, static_cast<double>(glm::length(detail::GroundState::of(found)[n].trail -
                                                                    detail::GroundState::of(truth)[n].trail)));
            trample = std::max(trample, static_cast<double>(std::abs(detail::GroundState::of(found)[n].trample -
                                                                     detail::GroundState::of(truth)[n].trample)));
        }
    }
    WINDROW_EXPECT_FIGURE("ground/walk/trail_at_15_to_1000_hz", trail, 0.01 * deepest);
    WINDROW_EXPECT_FIGURE("ground/walk/trample_at_15_to_1000_hz", trample, 0.01);
}

TEST(Ground, ATeleportedWalkerSweepsNothing) {
    GroundMemory ground = ground_of({});
    const GroundWalker jumped{.position = {10.0, 0.0, 0.0}, .previous = {-12.0, 0.0, 0.0}};
    advance(ground, 0.1, std::span(&jumped, 1));
    EXPECT_EQ(ground.at({0.0, 0.0, 0.0}).trample, 0.0f);
    EXPECT_GT(ground.at({10.0, 0.0, 0.0}).trample, 0.5f);
}

// --- The window moves
// ---------------------------------------------------------------------------------------------------------------

// A story of walkers in gusts, of which some frames move the window by whole texels, and some do not.
struct Walk {
    std::mt19937 random{7};
    std::uniform_real_distribution<double> unit{-1.0, 1.0};
    std::vector<GroundWalker> walkers = std::vector<GroundWalker>(8);
    glm::dvec3 origin{0.0};
    explicit Walk(glm::dvec3 at = {0.0, 0.0, 0.0}) : origin(at) {
        for (GroundWalker& walker : walkers)
            walker = standing(origin + place(), 0.6f);
    }
    // A multiple of 1/1024 m: sums with a far origin are exact.
    glm::dvec3 place() { return {std::round(6144.0 * unit(random)) / 1024.0, 0.0, std::round(6144.0 * unit(random)) / 1024.0}; }
    void step(GroundMemory& ground, bool follows) {
        glm::vec2 lean(0.3 * unit(random), 0.3 * unit(random));
        for (GroundWalker& walker : walkers) {
            walker.previous = walker.position;
            walker.position = walker.position + glm::dvec3(std::round(300.0 * unit(random)) / 1024.0, 0.0, 0.125);
            if (unit(random) > 0.9)
                walker = standing(origin + place(), 0.6f);
        }
        const glm::dvec3 point = origin + 0.5 * place();
        ASSERT_TRUE(ground.follow(follows ? point : origin));
        advance(ground, 1.0 / 60.0, walkers, lean);
    }
};

// A texel's state by its place in the world.
const numerics::WindrowGround* texel_at(const GroundMemory& ground, glm::dvec2 centre, glm::dvec2 slot_of_origin) {
    const int n = ground.config().texels;
    const auto along = [&](double value) {
        const auto texel = static_cast<std::int64_t>(std::llround(value));
        return static_cast<int>(((texel % n) + n) % n);
    };
    const double size = static_cast<double>(ground.config().texel_size);
    const glm::ivec2 slot(along(centre.x / size - 0.5 + slot_of_origin.x), along(centre.y / size - 0.5 + slot_of_origin.y));
    if (glm::length(ground.next_centre(slot) - centre) > 1e-6)
        return nullptr;
    return &detail::GroundState::of(ground)[static_cast<std::size_t>(slot.y * n + slot.x)];
}

bool same_bits(const numerics::WindrowGround& a, const numerics::WindrowGround& b) {
    return a.lean == b.lean && a.velocity == b.velocity && a.trail == b.trail && a.trample == b.trample;
}

// One window stays, one wanders by up to 3 m a frame: what was always in both has the same bits.
TEST(Ground, WindowShiftsChangeNoBit) {
    GroundMemory stays = ground_of({}), wanders = ground_of({});
    Walk one, other;
    for (int frame = 0; frame < 300; ++frame) {
        one.step(stays, false);
        other.step(wanders, true);
    }
    int compared = 0, touched = 0;
    // The window reaches 16 m from its point, which strays by 3 m at most, so texels within 12 m have never left it.
    for (double z = -11.875; z < 12.0; z += 0.25)
        for (double x = -11.875; x < 12.0; x += 0.25) {
            const auto *const a = texel_at(stays, {x, z}, {0.0, 0.0}), *const b = texel_at(wanders, {x, z}, {0.0, 0.0});
            ASSERT_NE(a, nullptr);
            ASSERT_NE(b, nullptr);
            ASSERT_TRUE(same_bits(*a, *b)) << x << ", " << z;
            ++compared;
            touched += glm::length(a->trail) > 0.01f ? 1 : 0;
        }
    test::figure("ground/shifts/texels_compared", compared);
    EXPECT_GT(test::figure("ground/shifts/texels_with_a_trail", touched), 1000);
}

TEST(Ground, FarAwayHasTheSameBits) {
    GroundMemory near = ground_of({}), far = ground_of({});
    const glm::dvec3 there(1048576.0, 0.0, -2097152.0);
    Walk one, other(there);
    for (int frame = 0; frame < 100; ++frame) {
        one.step(near, true);
        other.step(far, true);
    }
    for (double z = -7.875; z < 8.0; z += 0.25)
        for (double x = -7.875; x < 8.0; x += 0.25) {
            const auto* const a = texel_at(near, {x, z}, {0.0, 0.0});
            const auto* const b = texel_at(far, {there.x + x, there.z + z}, {0.0, 0.0});
            ASSERT_TRUE(a != nullptr && b != nullptr);
            ASSERT_TRUE(same_bits(*a, *b)) << x << ", " << z;
        }
}

TEST(Ground, ATeleportBeginsAnew) {
    GroundMemory ground = ground_of({});
    Walk walk;
    for (int frame = 0; frame < 60; ++frame)
        walk.step(ground, false);
    ASSERT_TRUE(ground.follow({1e6, 0.0, -1e6}));
    advance(ground, 1.0 / 60.0, {}, {0.2f, 0.1f});
    for (const numerics::WindrowGround& texel : detail::GroundState::of(ground)) {
        ASSERT_EQ(texel.lean, glm::vec2(0.2f, 0.1f)); // as if that wind had blown for long
        ASSERT_EQ(texel.trail, glm::vec2(0.0f));
    }
    EXPECT_EQ(ground.at({1e6, 0.0, -1e6}).lean, glm::vec2(0.2f, 0.1f));
}

// As the point crosses the place where the window jumps by a texel, nothing that is sampled moves. Bound: a float holds the 16 m
// to the window's corner to 1e-6 m, over which the steepest lean here, 1.4 within a texel of 0.25 m, changes by 6e-6.
TEST(Ground, AJumpOfTheWindowIsNotSeen) {
    GroundMemory ground = ground_of({});
    Walk walk;
    for (int frame = 0; frame < 120; ++frame)
        walk.step(ground, false);
    const double edge = 0.5 * static_cast<double>(ground.config().texel_size);
    ASSERT_TRUE(ground.follow({edge - 1e-7, 0.0, 0.0}));
    advance(ground, 0.0);
    GroundMemory jumped = ground;
    ASSERT_TRUE(jumped.follow({edge + 1e-7, 0.0, 0.0}));
    advance(jumped, 0.0);
    double worst = 0.0, largest = 0.0;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-18.0, 18.0);
    for (int n = 0; n < 20000; ++n) {
        const glm::dvec3 p(place(random), 0.0, place(random));
        worst = std::max(worst, static_cast<double>(glm::length(jumped.at(p).lean - ground.at(p).lean)));
        largest = std::max(largest, static_cast<double>(glm::length(ground.at(p).lean)));
    }
    EXPECT_GT(largest, 0.3);
    WINDROW_EXPECT_FIGURE("ground/jump_of_the_window", worst, 6e-6);
}

// --- Threads, rejections
// ----------------------------------------------------------------------------------------------------------

TEST(Ground, ParallelRowsHaveTheSameBits) {
    ThreadPool pool(3);
    GroundMemory serial = ground_of({}), parallel = ground_of({}, pool.parallel_for());
    Walk one, other;
    for (int frame = 0; frame < 60; ++frame) {
        one.step(serial, true);
        other.step(parallel, true);
    }
    for (std::size_t n = 0; n < detail::GroundState::of(serial).size(); ++n)
        ASSERT_TRUE(same_bits(detail::GroundState::of(serial)[n], detail::GroundState::of(parallel)[n])) << n;
}

TEST(Ground, RejectsWhatIsNoGround) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const auto names = [](const GroundConfig& config, const char* field) {
        const auto made = GroundMemory::create(config);
        return !made && made.error().find(field) != std::string::npos;
    };
    EXPECT_TRUE(names({.texels = 4}, "texels"));
    EXPECT_TRUE(names({.texels = 1000}, "texels"));
    for (const float bad : {0.0f, -1.0f, nan, infinity}) {
        EXPECT_TRUE(names({.texel_size = bad}, "texel_size"));
        EXPECT_TRUE(names({.trail_time = bad}, "trail_time"));
        EXPECT_TRUE(names({.trample_time = bad}, "trample_time"));
        EXPECT_TRUE(names({.clearance = bad}, "clearance"));
        EXPECT_TRUE(names({.blend_width = bad}, "blend_width"));
        EXPECT_TRUE(bad == 0.0f || names({.jump_speed = bad}, "jump_speed")); // 0: never
    }
    EXPECT_TRUE(names({.spring = {-1.0, 0.1}}, "frequency_hz"));
    EXPECT_TRUE(names({.push = -0.1f}, "push"));
    EXPECT_TRUE(names({.trail_fraction = 1.5f}, "trail_fraction"));
    EXPECT_TRUE(names({.blend_width = 9.0f}, "blend_width")); // wider than a quarter of the window
    EXPECT_TRUE(names({.max_walkers = 0}, "max_walkers"));

    GroundMemory ground = ground_of({.max_walkers = 2});
    const auto rejects = [&](const GroundWalker& walker, const char* field) {
        const auto done = ground.advance({.duration = 0.1, .walkers = std::span(&walker, 1)});
        return !done && done.error().find(field) != std::string::npos;
    };
    EXPECT_TRUE(rejects({.position = {std::nan(""), 0.0, 0.0}}, "position"));
    EXPECT_TRUE(rejects({.previous = {0.0, 0.0, std::nan("")}}, "previous"));
    EXPECT_TRUE(rejects({.foot_height = nan}, "foot_height"));
    EXPECT_TRUE(rejects({.radius = 0.0f}, "radius"));
    EXPECT_TRUE(rejects({.weight = 2.0f}, "weight"));
    EXPECT_FALSE(ground.advance({.duration = -0.1}));
    EXPECT_FALSE(ground.advance({.wind_lean = {nan, 0.0f}}));
    EXPECT_FALSE(ground.advance({.wind_lean = {0.0f, 2e3f}}));
    EXPECT_FALSE(ground.advance({}, std::vector<glm::vec2>(7)));
    EXPECT_FALSE(ground.follow({std::nan(""), 0.0, 0.0}));
    EXPECT_FALSE(ground.follow({1e15, 0.0, 0.0}));
    EXPECT_EQ(ground.at({0.0, 0.0, 0.0}).trample, 0.0f);
    EXPECT_TRUE(ground.advance({.duration = 0.1}));
}

// --- Copies
// -----------------------------------------------------------------------------------------------------------------------

TEST(Ground, WhatWasMovedFromMayBeAssignedTo) {
    GroundMemory a = ground_of({.texels = 16, .blend_width = 0.5f});
    const GroundWalker walker;
    advance(a, 0.1, std::span(&walker, 1));
    GroundMemory b = std::move(a);
    a = b;
    EXPECT_GT(a.at({0.0, 0.0, 0.0}).trample, 0.5f);
    GroundMemory c = std::move(b);
    const GroundMemory d = b; // NOLINT: of nothing, nothing
    b = d;
    b = c;
    EXPECT_EQ(b.at({0.0, 0.0, 0.0}).trample, a.at({0.0, 0.0, 0.0}).trample);
}

// A copy has its room for walkers from the first: a step finds it and allocates none.
TEST(Ground, ACopyHasRoomForWalkers) {
    const detail::GroundHost first{GroundConfig{}};
    detail::GroundHost copy = first;
    const void* const room = copy.walkers().data();
    const std::vector<GroundWalker> walkers(40);
    ASSERT_TRUE(copy.begin({.duration = 0.1, .walkers = walkers}, WindLeans::everywhere));
    EXPECT_EQ(copy.walkers().size(), 40u);
    EXPECT_EQ(copy.walkers().data(), room);
}

} // namespace
} // namespace windrow
